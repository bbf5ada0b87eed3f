// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_cases_region_meshes_h
#define vfife_tests_study_cases_region_meshes_h

#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/hexahedron_corners.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/** Boxes of hexahedra as another program would write them: several volumes in one file. */
namespace region_meshes
{
  using vfife::CellNodes;
  using vfife::Vector3;

  struct Box
  {
    long                        region; ///< number of the volume
    std::string                 name;
    Vector3                     corner, size; ///< [mm]
    std::array<unsigned int, 3> cells;
    long                        bottom, top; ///< numbers of the surfaces z- and z+
  };

  /** Nodes from 0, hexahedra and quadrilaterals with the number of their volume or surface. */
  struct Mesh
  {
    std::vector<Vector3>                                      nodes;
    std::vector<std::pair<CellNodes, long>>                   elements;
    std::vector<std::pair<std::array<unsigned int, 4>, long>> faces; ///< in turn
    std::map<long, std::string>                               volumes, surfaces;
  };

  /** With @p joins nodes at the same place are one. */
  inline Mesh make(const std::vector<Box> &boxes, const bool joins = false)
  {
    Mesh       mesh;
    const auto find_node = [&](const Vector3 &x) {
      for (unsigned int i = 0; joins && i < mesh.nodes.size(); ++i)
        if (mesh.nodes[i] == x)
          return i;
      mesh.nodes.push_back(x);
      return static_cast<unsigned int>(mesh.nodes.size() - 1);
    };
    for (const Box &box : boxes)
      {
        const auto               &n = box.cells;
        std::vector<unsigned int> index;
        for (unsigned int k = 0; k <= n[2]; ++k)
          for (unsigned int j = 0; j <= n[1]; ++j)
            for (unsigned int i = 0; i <= n[0]; ++i)
              index.push_back(find_node(box.corner + Vector3(i * box.size[0] / n[0],
                                                             j * box.size[1] / n[1],
                                                             k * box.size[2] / n[2])));
        const auto node = [&](const unsigned int i, const unsigned int j, const unsigned int k) {
          return index[i + (n[0] + 1) * (j + (n[1] + 1) * k)];
        };
        for (unsigned int k = 0; k < n[2]; ++k)
          for (unsigned int j = 0; j < n[1]; ++j)
            for (unsigned int i = 0; i < n[0]; ++i)
              {
                CellNodes element;
                for (unsigned int v = 0; v < 8; ++v)
                  element[v] = node(i + v % 2, j + v / 2 % 2, k + v / 4);
                mesh.elements.emplace_back(element, box.region);
              }
        for (const unsigned int k : {0u, n[2]})
          for (unsigned int j = 0; j < n[1]; ++j)
            for (unsigned int i = 0; i < n[0]; ++i)
              mesh.faces.push_back(
                {{{node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)}},
                 k == 0 ? box.bottom : box.top});
        mesh.volumes[box.region]  = box.name;
        mesh.surfaces[box.bottom] = box.name + " bottom";
        mesh.surfaces[box.top]    = box.name + " top";
      }
    return mesh;
  }

  inline std::array<unsigned int, 8> in_order_of_files(const CellNodes &element)
  {
    std::array<unsigned int, 8> nodes;
    for (unsigned int v = 0; v < 8; ++v)
      nodes[v] = element[vfife::corner_of_files[v]];
    return nodes;
  }

  template <typename Nodes>
  void write_nodes(std::ostream &out, const Nodes &nodes, const unsigned int first)
  {
    for (const unsigned int node : nodes)
      out << " " << node + first;
    out << "\n";
  }

  inline void write_coordinates(std::ostream &out, const Vector3 &x)
  {
    out << x[0] << " " << x[1] << " " << x[2] << "\n";
  }

  inline void write_names(std::ostream &out, const Mesh &mesh)
  {
    out << "$PhysicalNames\n" << mesh.volumes.size() + mesh.surfaces.size() << "\n";
    for (const auto &[number, name] : mesh.surfaces)
      out << "2 " << number << " \"" << name << "\"\n";
    for (const auto &[number, name] : mesh.volumes)
      out << "3 " << number << " \"" << name << "\"\n";
    out << "$EndPhysicalNames\n";
  }

  inline void write_gmsh_2(std::ostream &out, const Mesh &mesh)
  {
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    write_names(out, mesh);
    out << "$Nodes\n" << mesh.nodes.size() << "\n";
    for (unsigned int i = 0; i < mesh.nodes.size(); ++i)
      {
        out << i + 1 << " ";
        write_coordinates(out, mesh.nodes[i]);
      }
    out << "$EndNodes\n$Elements\n" << mesh.elements.size() + mesh.faces.size() << "\n";
    unsigned int n = 0;
    for (const auto &[nodes, number] : mesh.faces)
      {
        out << ++n << " 3 2 " << number << " " << number;
        write_nodes(out, nodes, 1);
      }
    for (const auto &[nodes, number] : mesh.elements)
      {
        out << ++n << " 5 2 " << number << " " << number;
        write_nodes(out, in_order_of_files(nodes), 1);
      }
    out << "$EndElements\n";
  }

  /** An entity for each group, with the tag 100 + its number. */
  inline void write_gmsh_4(std::ostream &out, const Mesh &mesh)
  {
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_names(out, mesh);
    out << "$Entities\n0 0 " << mesh.surfaces.size() << " " << mesh.volumes.size() << "\n";
    for (const auto *groups : {&mesh.surfaces, &mesh.volumes})
      for (const auto &group : *groups)
        out << 100 + group.first << " 0 0 0 1 1 1 1 " << group.first << " 0\n";
    const std::size_t n_nodes = mesh.nodes.size();
    out << "$EndEntities\n$Nodes\n1 " << n_nodes << " 1 " << n_nodes << "\n3 101 0 " << n_nodes
        << "\n";
    for (unsigned int i = 0; i < n_nodes; ++i)
      out << i + 1 << "\n";
    for (const Vector3 &x : mesh.nodes)
      write_coordinates(out, x);
    // A block of one element for each: allowed, if wasteful.
    const std::size_t n_all = mesh.elements.size() + mesh.faces.size();
    out << "$EndNodes\n$Elements\n" << n_all << " " << n_all << " 1 " << n_all << "\n";
    unsigned int n = 0;
    for (const auto &[nodes, number] : mesh.faces)
      {
        out << "2 " << 100 + number << " 3 1\n" << ++n;
        write_nodes(out, nodes, 1);
      }
    for (const auto &[nodes, number] : mesh.elements)
      {
        out << "3 " << 100 + number << " 5 1\n" << ++n;
        write_nodes(out, in_order_of_files(nodes), 1);
      }
    out << "$EndElements\n";
  }

  inline void write_vtk(std::ostream &out, const Mesh &mesh)
  {
    const std::size_t n = mesh.elements.size() + mesh.faces.size();
    out << "# vtk DataFile Version 3.0\nboxes\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS "
        << mesh.nodes.size() << " double\n";
    for (const Vector3 &x : mesh.nodes)
      write_coordinates(out, x);
    out << "CELLS " << n << " " << 9 * mesh.elements.size() + 5 * mesh.faces.size() << "\n";
    for (const auto &element : mesh.elements)
      {
        out << "8";
        write_nodes(out, in_order_of_files(element.first), 0);
      }
    for (const auto &face : mesh.faces)
      {
        out << "4";
        write_nodes(out, face.first, 0);
      }
    out << "CELL_TYPES " << n << "\n";
    for (std::size_t i = 0; i < n; ++i)
      out << (i < mesh.elements.size() ? 12 : 9) << "\n";
    out << "CELL_DATA " << n << "\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n";
    for (const auto &element : mesh.elements)
      out << element.second << "\n";
    for (const auto &face : mesh.faces)
      out << face.second << "\n";
  }

  inline void write_ucd(std::ostream &out, const Mesh &mesh)
  {
    out << mesh.nodes.size() << " " << mesh.elements.size() + mesh.faces.size() << " 0 0 0\n";
    for (unsigned int i = 0; i < mesh.nodes.size(); ++i)
      {
        out << i + 1 << " ";
        write_coordinates(out, mesh.nodes[i]);
      }
    unsigned int n = 0;
    for (const auto &[nodes, number] : mesh.elements)
      {
        // UCD begins with the side y = 0.
        std::array<unsigned int, 8> ucd;
        const unsigned int          order[8] = {0, 1, 5, 4, 2, 3, 7, 6};
        for (unsigned int v = 0; v < 8; ++v)
          ucd[v] = nodes[order[v]];
        out << ++n << " " << number << " hex";
        write_nodes(out, ucd, 1);
      }
    for (const auto &[nodes, number] : mesh.faces)
      {
        out << ++n << " " << number << " quad";
        write_nodes(out, nodes, 1);
      }
  }

  /** Groups with numbers as names, as Salome writes them; exponents as I-DEAS writes them. */
  inline void write_unv(std::ostream &out, const Mesh &mesh)
  {
    out << "    -1\n   164\n 1 SI: Meter (newton) 2\n    -1\n    -1\n  2411\n";
    for (unsigned int i = 0; i < mesh.nodes.size(); ++i)
      {
        std::ostringstream x;
        x.precision(17);
        x << std::scientific;
        write_coordinates(x, mesh.nodes[i]);
        std::string text = x.str();
        std::replace(text.begin(), text.end(), 'e', 'D');
        out << i + 1 << " 1 1 11\n" << text;
      }
    out << "    -1\n    -1\n  2412\n";
    unsigned int                              n = 0;
    std::map<long, std::vector<unsigned int>> groups;
    for (const auto &[nodes, number] : mesh.faces)
      {
        groups[number].push_back(++n);
        out << n << " 44 1 1 7 4\n";
        write_nodes(out, nodes, 1);
      }
    for (const auto &[nodes, number] : mesh.elements)
      {
        groups[number].push_back(++n);
        out << n << " 115 1 1 7 8\n";
        write_nodes(out, in_order_of_files(nodes), 1);
      }
    out << "    -1\n    -1\n  2467\n";
    for (const auto &[number, members] : groups)
      {
        out << number << " 0 0 0 0 0 0 " << members.size() << "\n" << number << "\n";
        for (std::size_t i = 0; i < members.size(); ++i)
          out << "8 " << members[i] << " 0 0"
              << (i % 2 == 1 || i + 1 == members.size() ? "\n" : " ");
      }
    out << "    -1\n";
  }

  /** Without the groups: the format has no ids. */
  inline void write_xda(std::ostream &out, const Mesh &mesh)
  {
    out << "DEAL 003:003\n"
        << mesh.elements.size() << " # Num. Elements\n"
        << mesh.nodes.size() << " # Num. Nodes\n"
        << 8 * mesh.elements.size() << " # Sum of Element Weights\n0\n65536\n1\n8\n"
        << mesh.elements.size() << "\nId String\nTitle String\n";
    for (const auto &element : mesh.elements)
      write_nodes(out, in_order_of_files(element.first), 0);
    for (const Vector3 &x : mesh.nodes)
      write_coordinates(out, x);
  }

  /** In the format that the end of the name says; "gmsh4.msh": Gmsh 4.1. */
  inline void write(const std::string &path, const Mesh &mesh)
  {
    std::ofstream     out(path);
    const std::string end = path.substr(path.rfind('.') + 1);
    out.precision(17);
    if (end == "vtk")
      write_vtk(out, mesh);
    else if (end == "ucd")
      write_ucd(out, mesh);
    else if (end == "unv")
      write_unv(out, mesh);
    else if (end == "xda")
      write_xda(out, mesh);
    else if (path.find("gmsh4") != std::string::npos)
      write_gmsh_4(out, mesh);
    else
      write_gmsh_2(out, mesh);
  }
} // namespace region_meshes

#endif
