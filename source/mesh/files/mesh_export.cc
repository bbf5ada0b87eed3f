// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/mesh/files/mesh_export.h>
#include <vfife/mesh/hexahedron_corners.h>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <set>
#include <sstream>

namespace vfife
{
  namespace
  {
    template <typename Values>
    void write_vtu_array(std::ostream      &out,
                         const char        *type,
                         const std::string &name,
                         const Values      &values)
    {
      out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">\n";
      unsigned int column = 0;
      for (const auto value : values)
        out << +value << (++column % 20 == 0 ? '\n' : ' ');
      out << "\n</DataArray>\n";
    }

    /** Numbers from 1, sixteen a line as CalculiX allows. */
    void write_labels(std::ostream &out, const std::vector<unsigned int> &indices)
    {
      for (std::size_t i = 0; i < indices.size(); ++i)
        out << indices[i] + 1 << (i + 1 == indices.size() || i % 16 == 15 ? "\n" : ", ");
    }

    /** A number as CalculiX reads it, which takes the first twenty characters of a field: with
     * fewer digits where fifteen would be longer. */
    std::string field(const double value)
    {
      for (int digits = 15;; --digits)
        {
          std::ostringstream text;
          text.precision(digits);
          text << value;
          if (text.str().size() <= 20)
            return text.str();
        }
    }

    /** Hexahedra (VTK's type 12), then the faces of the surfaces (type 9). */
    void write_vtu_cells(std::ostream &out, const ExportedMesh &mesh)
    {
      // one list of corners, and where each cell's end
      std::vector<unsigned int> connectivity, offsets;
      std::vector<std::uint8_t> types;
      for (const CellNodes &nodes : mesh.elements)
        {
          for (const unsigned int corner : corner_of_files)
            connectivity.push_back(nodes[corner]);
          offsets.push_back(connectivity.size());
          types.push_back(12);
        }
      for (const auto &surface : mesh.surfaces)
        for (const auto &face : surface.faces)
          {
            const auto nodes = mesh.face_nodes(face);
            connectivity.insert(connectivity.end(), nodes.begin(), nodes.end());
            offsets.push_back(connectivity.size());
            types.push_back(9);
          }
      out << "<Cells>\n";
      // Signed, as VTK's own cells are: its threshold filter crashes on others (ParaView 5.11).
      write_vtu_array(out, "Int32", "connectivity", connectivity);
      write_vtu_array(out, "Int32", "offsets", offsets);
      write_vtu_array(out, "UInt8", "types", types);
      out << "</Cells>\n";
    }
    /** VTK's unstructured grid in text: hexahedra, then faces of the named surfaces; node sets and
     * surfaces as arrays of 0 and 1. */
    void
    write_vtu(std::ostream &out, const ExportedMesh &mesh, const std::vector<ExportedBody> &bodies)
    {
      // Cells are the elements and, behind them, the faces of all surfaces.
      std::size_t n_faces = 0;
      for (const auto &surface : mesh.surfaces)
        n_faces += surface.faces.size();
      const std::size_t n_elements = mesh.elements.size(), n_cells = n_elements + n_faces;

      out << "<?xml version=\"1.0\"?>\n<!-- Lengths in mm. body:";
      for (std::size_t i = 0; i < bodies.size(); ++i)
        out << ' ' << i << " = " << bodies[i].name;
      out << "; region:";
      for (std::size_t i = 0; i < mesh.regions.size(); ++i)
        out << ' ' << i + 1 << " = " << mesh.regions[i].name;
      out << " (0 on faces) -->\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
             "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
          << mesh.nodes.size() << "\" NumberOfCells=\"" << n_cells
          << "\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
             "format=\"ascii\">\n";
      for (const Vector3 &x : mesh.nodes)
        out << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
      out << "</DataArray>\n</Points>\n";
      write_vtu_cells(out, mesh);

      // numbers of cells: those of a face are its element's
      std::vector<unsigned int> region(n_cells, 0), sector(mesh.sector), body(mesh.body);
      for (std::size_t i = 0; i < mesh.regions.size(); ++i)
        for (const unsigned int element : mesh.regions[i].elements)
          region[element] = i + 1;
      for (const auto &surface : mesh.surfaces)
        for (const auto &face : surface.faces)
          {
            sector.push_back(mesh.sector[face.element]);
            body.push_back(mesh.body[face.element]);
          }
      out << "<CellData>\n";
      write_vtu_array(out, "UInt32", "body", body);
      write_vtu_array(out, "UInt32", "region", region);
      write_vtu_array(out, "UInt32", "tooth", sector);
      // surfaces and node sets as arrays of 0 and 1
      std::size_t first = n_elements;
      for (const auto &surface : mesh.surfaces)
        {
          std::vector<std::uint8_t> inside(n_cells, 0);
          std::fill_n(inside.begin() + first, surface.faces.size(), 1);
          first += surface.faces.size();
          write_vtu_array(out, "UInt8", "surface " + surface.name, inside);
        }
      out << "</CellData>\n<PointData>\n";
      for (const auto &set : mesh.node_sets)
        {
          std::vector<std::uint8_t> inside(mesh.nodes.size(), 0);
          for (const unsigned int node : set.nodes)
            inside[node] = 1;
          write_vtu_array(out, "UInt8", "set " + set.name, inside);
        }
      out << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    }

    /** Gmsh's format 2.2 in text: physical groups for regions, surfaces and node sets (points). */
    void write_gmsh(std::ostream &out, const ExportedMesh &mesh, const std::vector<ExportedBody> &)
    {
      // Physical groups are numbered from 1 in each dimension: 0 node sets, 2 surfaces, 3 regions.
      const std::size_t n_regions = mesh.regions.size(), n_surfaces = mesh.surfaces.size();
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
          << n_regions + n_surfaces + mesh.node_sets.size() << '\n';
      std::size_t n_elements = mesh.elements.size(), id = 0;
      for (const auto &set : mesh.node_sets)
        {
          out << "0 " << ++id << " \"" << set.name << "\"\n";
          n_elements += set.nodes.size();
        }
      id = 0;
      for (const auto &surface : mesh.surfaces)
        {
          out << "2 " << ++id << " \"" << surface.name << "\"\n";
          n_elements += surface.faces.size();
        }
      for (std::size_t i = 0; i < n_regions; ++i)
        out << "3 " << i + 1 << " \"" << mesh.regions[i].name << "\"\n";
      out << "$EndPhysicalNames\n$Nodes\n" << mesh.nodes.size() << '\n';
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        out << i + 1 << ' ' << mesh.nodes[i][0] << ' ' << mesh.nodes[i][1] << ' '
            << mesh.nodes[i][2] << '\n';
      out << "$EndNodes\n$Elements\n" << n_elements << '\n';

      //   number type 2 group entity nodes...     two tags an element, both the number of its group
      // elements: hexahedra (type 5), faces (3), points (15), with the number of their group
      std::size_t number = 0;
      id                 = 0;
      for (const auto &region : mesh.regions)
        {
          ++id;
          for (const unsigned int element : region.elements)
            {
              out << ++number << " 5 2 " << id << ' ' << id;
              for (const unsigned int corner : corner_of_files)
                out << ' ' << mesh.elements[element][corner] + 1;
              out << '\n';
            }
        }
      id = 0;
      for (const auto &surface : mesh.surfaces)
        {
          ++id;
          for (const auto &face : surface.faces)
            {
              out << ++number << " 3 2 " << id << ' ' << id;
              for (const unsigned int node : mesh.face_nodes(face))
                out << ' ' << node + 1;
              out << '\n';
            }
        }
      id = 0;
      for (const auto &set : mesh.node_sets)
        {
          ++id;
          for (const unsigned int node : set.nodes)
            out << ++number << " 15 2 " << id << ' ' << id << ' ' << node + 1 << '\n';
        }
      out << "$EndElements\n";
    }

    /** Abaqus or CalculiX: C3D8, NSET, ELSET, SURFACE, materials and sections; no step. */
    void write_abaqus(std::ostream                    &out,
                      const ExportedMesh              &mesh,
                      const std::vector<ExportedBody> &bodies)
    {
      // deal.II's faces x-, x+, y-, y+, z-, z+ in Abaqus' numbers
      constexpr unsigned int abaqus_face[6] = {6, 4, 3, 5, 1, 2};

      out << "** Units: mm, N, MPa, t (10^3 kg), s\n*NODE, NSET=NALL\n";
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        out << i + 1 << ", " << field(mesh.nodes[i][0]) << ", " << field(mesh.nodes[i][1]) << ", "
            << field(mesh.nodes[i][2]) << '\n';
      for (const auto &region : mesh.regions)
        {
          out << "*ELEMENT, TYPE=C3D8I, ELSET=" << abaqus_name(region.name) << '\n';
          for (const unsigned int element : region.elements)
            {
              out << element + 1;
              for (const unsigned int corner : corner_of_files)
                out << ", " << mesh.elements[element][corner] + 1;
              out << '\n';
            }
        }
      // an element set of each body, made of its regions
      for (std::size_t b = 0; b < bodies.size(); ++b)
        {
          out << "*ELSET, ELSET=" << abaqus_name(bodies[b].name) << '\n';
          for (const auto &region : mesh.regions)
            if (region.body == b)
              out << abaqus_name(region.name) << '\n';
        }
      for (const auto &set : mesh.node_sets)
        {
          out << "*NSET, NSET=" << abaqus_name(set.name) << '\n';
          write_labels(out, set.nodes);
        }
      for (const auto &surface : mesh.surfaces)
        {
          out << "*SURFACE, NAME=" << abaqus_name(surface.name) << "_SURFACE, TYPE=ELEMENT\n";
          for (const auto &face : surface.faces)
            out << face.element + 1 << ", S" << abaqus_face[face.face] << '\n';
        }
      // materials once, sections for each body
      std::set<std::string> written;
      for (const ExportedBody &body : bodies)
        {
          const std::string material = abaqus_name(body.material);
          if (written.insert(material).second)
            out << "*MATERIAL, NAME=" << material << "\n*ELASTIC\n"
                << field(body.youngs_modulus) << ", " << field(body.poissons_ratio)
                << "\n*DENSITY\n"
                << field(body.density) << '\n';
          out << "*SOLID SECTION, ELSET=" << abaqus_name(body.name) << ", MATERIAL=" << material
              << '\n';
        }
    }

    using WriteMesh = void (*)(std::ostream                    &out,
                               const ExportedMesh              &mesh,
                               const std::vector<ExportedBody> &bodies);

    /** All formats. */
    const Choices<WriteMesh> written_formats = {{"vtu", &write_vtu},
                                                {"msh", &write_gmsh},
                                                {"inp", &write_abaqus}};
  } // namespace

  std::vector<std::string> export_formats()
  {
    std::vector<std::string> names;
    for (const auto &format : written_formats)
      names.push_back(format.first);
    return names;
  }

  void write_meshes(std::ostream                    &out,
                    const std::string               &format,
                    const std::vector<ExportedBody> &bodies)
  {
    for (const auto &row : written_formats)
      if (row.first == format)
        {
          // coordinates of 100 mm to 1e-13 mm
          out.precision(15);
          row.second(out, collect(bodies), bodies);
          return;
        }
    throw InputError("expected an export format, got \"" + format + "\"; allowed: " +
                     list_of(export_formats()) + did_you_mean(format, export_formats()));
  }
} // namespace vfife
