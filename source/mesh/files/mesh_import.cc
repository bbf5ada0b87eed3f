// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/text_lines.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/files/mesh_import.h>
#include <vfife/mesh/mesh_quality.h>

#include "file_mesh.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace vfife
{
  namespace
  {
    void sort_unique(std::vector<unsigned int> &members)
    {
      std::sort(members.begin(), members.end());
      members.erase(std::unique(members.begin(), members.end()), members.end());
    }

    /** UCD is written to .inp as well, and begins with numbers where Abaqus begins with a keyword.
     */
    FileMesh read_inp_or_ucd(const std::string &path)
    {
      std::ifstream file(path);
      TextLines     lines(file);
      for (std::string line; for_place(path, [&] { return lines.next(line); });)
        {
          const std::string text = trimmed(line);
          if (!text.empty() && text[0] != '#')
            return text[0] >= '0' && text[0] <= '9' ? read_ucd(path) : read_abaqus(path);
        }
      throw InputError(path + ": expected hexahedra, got an empty file");
    }

    using ReadMesh = FileMesh (*)(const std::string &path);

    /** All formats, by the end of the file's name. */
    const Choices<ReadMesh> read_formats = {{"msh", &read_gmsh},
                                            {"inp", &read_inp_or_ucd},
                                            {"vtk", &read_vtk},
                                            {"ucd", &read_inp_or_ucd}};

    FileMesh read_file(const std::string &path)
    {
      if (!std::ifstream(path) || std::filesystem::is_directory(path))
        throw InputError("mesh file " + path + " cannot be opened");
      const auto               dot = path.rfind('.');
      const std::string        end = dot == std::string::npos ? "" : path.substr(dot + 1);
      std::vector<std::string> ends;
      for (const auto &format : read_formats)
        {
          if (format.first == end)
            return format.second(path);
          ends.push_back("." + format.first);
        }
      if (auto mesh = read_by_dealii(path))
        return *std::move(mesh);
      for (const std::string &format : dealii_formats())
        ends.push_back("." + format);
      throw InputError("mesh file " + path + ": expected a name that ends in one of " +
                       list_of(ends));
    }

    /** deal.II wants opposite edges of a cell to point the same way in all cells. */
    void orient(const std::string &path, FileMesh &mesh)
    {
      std::vector<dealii::CellData<3>> cells(mesh.elements.size());
      for (std::size_t e = 0; e < cells.size(); ++e)
        std::copy(mesh.elements[e].begin(), mesh.elements[e].end(), cells[e].vertices.begin());
      try
        {
          dealii::GridTools::consistently_order_cells(cells);
        }
      catch (const dealii::ExceptionBase &)
        {
          throw InputError(path + ": the edges of the hexahedra cannot be given directions that "
                                  "agree in all of them, as in a twisted ring");
        }
      for (std::size_t e = 0; e < cells.size(); ++e)
        std::copy(cells[e].vertices.begin(), cells[e].vertices.end(), mesh.elements[e].begin());
    }

    /** Of a name the nodes of the node set, or else of the surface, or else of the region. */
    void add_node_sets(const FileMesh &file, BodyMesh &mesh)
    {
      FileMesh::Members of_surfaces, of_regions;
      for (const auto &surface : file.surfaces)
        for (const auto &face : surface.faces)
          of_surfaces[surface.name].insert(of_surfaces[surface.name].end(),
                                           face.nodes.begin(),
                                           face.nodes.end());
      for (const auto &region : file.regions)
        for (const unsigned int element : region.members)
          of_regions[region.name].insert(of_regions[region.name].end(),
                                         file.elements[element].begin(),
                                         file.elements[element].end());
      for (const auto &set : file.node_sets)
        mesh.node_sets[set.name] = set.members;
      for (FileMesh::Members *sets : {&of_surfaces, &of_regions})
        for (auto &set : *sets)
          {
            sort_unique(set.second);
            mesh.node_sets.insert(set);
          }
    }

    /** Why nothing can act on a surface; empty where it can. */
    std::string find_fault(const std::string       &path,
                           const FileMesh::Surface &surface,
                           const FaceSet           &boundary,
                           const BodyMesh          &mesh)
    {
      std::size_t               n_inside = 0;
      unsigned int              line     = 0;
      std::vector<unsigned int> nodes;
      for (const auto &face : surface.faces)
        {
          auto corners = face.nodes;
          std::sort(corners.begin(), corners.end());
          nodes.insert(nodes.end(), corners.begin(), corners.end());
          if (boundary.count(corners) != 0)
            continue;
          line = n_inside == 0 ? face.line : line;
          ++n_inside;
        }
      sort_unique(nodes);
      std::ostringstream fault;
      if (n_inside > 0)
        fault << path << ":" << line << ": " << n_inside << " of the " << surface.faces.size()
              << " faces of surface \"" << surface.name
              << "\" lie between two elements. Name a surface that consists of outer faces";
      else if (nodes != mesh.node_sets.at(surface.name))
        fault << path << ": \"" << surface.name
              << "\" is a node set and a surface of other nodes. Give one of them another name";
      return fault.str();
    }

    /** Surfaces by their faces, with boundary ids. */
    void add_surfaces(const std::string &path, const FileMesh &file, BodyMesh &mesh)
    {
      const FaceSet            boundary = file.find_boundary();
      std::vector<std::string> names;
      for (const auto &surface : file.surfaces)
        {
          const std::string fault = find_fault(path, surface, boundary, mesh);
          if (!fault.empty())
            {
              mesh.unusable_surfaces[surface.name] = fault;
              continue;
            }
          FaceSet faces;
          for (const auto &face : surface.faces)
            {
              auto corners = face.nodes;
              std::sort(corners.begin(), corners.end());
              faces.insert(corners);
            }
          try
            {
              mesh.surfaces[surface.name] =
                surface_of_boundary(mesh.triangulation, surface.name, faces);
              names.push_back(surface.name);
            }
          catch (const InputError &error)
            {
              mesh.unusable_surfaces[surface.name] = path + ": " + error.what();
            }
        }
      // More surfaces than ids: they are all known by name, the faces of the mesh have none.
      if (names.size() <= most_boundaries)
        name_surface_faces(mesh, names);
    }

    /** Stiffness and mass are made at the Gauss points: there no element may be inverted. */
    void check_shapes(const std::string &path, BodyMesh &mesh)
    {
      const MeshQuality  quality = compute_mesh_quality(mesh.triangulation);
      std::ostringstream message;
      message << path << ": ";
      if (!(quality.least_gauss_determinant > 0.))
        {
          message << "inverted hexahedron near " << quality.worst_gauss_centre.transpose() << " mm";
          throw InputError(message.str());
        }
      if (quality.least_determinant > 0.)
        return;
      message << quality.inverted_corners
              << " hexahedra are inverted at a corner but not inside; the worst near "
              << quality.worst_cell_centre.transpose() << " mm has the scaled Jacobian "
              << quality.least_scaled_jacobian
              << ". Stresses there are inaccurate. Improve the mesh";
      mesh.warnings.push_back(message.str());
    }

    /** The body of what stands in a file, of @p regions alone where there are any. */
    std::unique_ptr<BodyMesh>
    build_body(const std::string &path, FileMesh file, const std::vector<std::string> &wanted)
    {
      // 1. What a body can consist of, cells in deal.II's order of edges.
      if (!wanted.empty())
        file.keep_regions(path, wanted);
      if (!file.names_without_case) // Abaqus refuses them
        turn_inside_out(file);
      check_elements(path, file);
      orient(path, file);

      auto mesh                = std::make_unique<BodyMesh>();
      mesh->name               = path.substr(path.rfind('/') + 1);
      mesh->names_without_case = file.names_without_case;
      mesh->warnings           = file.warnings;
      mesh->notes              = file.notes;
      // 2. Regions are numbered from 1; an element belongs to the first one that has it.
      std::vector<unsigned int> regions(file.elements.size(), 0);
      for (unsigned int i = 0; i < file.regions.size(); ++i)
        {
          mesh->regions[i + 1] = file.regions[i].name;
          for (const unsigned int element : file.regions[i].members)
            if (regions[element] == 0)
              regions[element] = i + 1;
        }
      try
        {
          create_triangulation(*mesh, file.nodes, file.elements, regions);
        }
      catch (const dealii::ExceptionBase &)
        {
          throw InputError(path + ": the hexahedra cannot be joined to a mesh");
        }

      // 3. Named parts, and how good the elements are.
      add_node_sets(file, *mesh);
      add_surfaces(path, file, *mesh);
      check_shapes(path, *mesh);
      return mesh;
    }
  } // namespace

  std::unique_ptr<BodyMesh> read_body(const std::string              &path,
                                      const std::vector<std::string> &regions)
  {
    return build_body(path, read_file(path), regions);
  }

  std::unique_ptr<BodyMesh> make_body(const std::string              &name,
                                      const dealii::Triangulation<3> &triangulation)
  {
    return build_body(name, collect_file_mesh(name, triangulation), {});
  }

  CoincidentNodes find_coincident_nodes(const BodyMesh &mesh)
  {
    CoincidentNodes found;
    const double    least_edge = compute_mesh_quality(mesh.triangulation).least_edge;
    found.tolerance            = 1e-3 * least_edge;
    // Nodes by cubes of a tenth of the least edge, in which few lie, and by those that their
    // tolerance reaches.
    const double                                             size = 0.1 * least_edge;
    std::map<std::array<long, 3>, std::vector<unsigned int>> cubes;
    const auto &vertices = mesh.triangulation.get_vertices();
    for (unsigned int i = 0; i < vertices.size(); ++i)
      {
        std::array<long, 3> low, high;
        for (unsigned int c = 0; c < 3; ++c)
          {
            low[c]  = std::lround(std::floor((vertices[i][c] - found.tolerance) / size));
            high[c] = std::lround(std::floor((vertices[i][c] + found.tolerance) / size));
          }
        bool                coincides = false;
        std::array<long, 3> at;
        for (at[0] = low[0]; at[0] <= high[0]; ++at[0])
          for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
            for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
              {
                std::vector<unsigned int> &others = cubes[at];
                for (const unsigned int other : others)
                  coincides = coincides || vertices[i].distance(vertices[other]) <= found.tolerance;
                others.push_back(i);
              }
        if (coincides && found.n++ == 0)
          found.place = Vector3(vertices[i][0], vertices[i][1], vertices[i][2]);
      }
    return found;
  }

  std::string CoincidentNodes::describe() const
  {
    std::ostringstream text;
    text << n << " nodes lie within " << tolerance
         << " mm of another node, and no element contains both (the first at " << place.transpose()
         << " mm)";
    return text.str();
  }

  unsigned int count_parts(const BodyMesh &mesh)
  {
    // Every cell begins as a part of its own; faces join them.
    unsigned int                                         n = mesh.triangulation.n_active_cells();
    std::vector<unsigned int>                            rank(n), parent(n);
    boost::disjoint_sets<unsigned int *, unsigned int *> parts(rank.data(), parent.data());
    for (unsigned int cell = 0; cell < n; ++cell)
      parts.make_set(cell);
    unsigned int n_parts = n;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      for (unsigned int f = 0; f < 6; ++f)
        if (!cell->at_boundary(f))
          {
            const unsigned int one   = parts.find_set(cell->active_cell_index());
            const unsigned int other = parts.find_set(cell->neighbor(f)->active_cell_index());
            if (one == other)
              continue;
            parts.link(one, other);
            --n_parts;
          }
    return n_parts;
  }
} // namespace vfife
