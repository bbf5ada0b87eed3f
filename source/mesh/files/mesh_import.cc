// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/files/mesh_import.h>
#include <vfife/mesh/mesh_quality.h>

#include "file_mesh.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
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

    using ReadMesh = FileMesh (*)(const std::string &path);

    /** All formats, by the end of the file's name. */
    const Choices<ReadMesh> read_formats = {{"msh", &read_gmsh},
                                            {"inp", &read_abaqus},
                                            {"vtk", &read_vtk},
                                            {"ucd", &read_ucd}};

    FileMesh read_file(const std::string &path, const std::vector<std::string> &regions)
    {
      if (!std::ifstream(path) || std::filesystem::is_directory(path))
        throw InputError("mesh file " + path + " cannot be opened");
      const auto               dot = path.rfind('.');
      const std::string        end = dot == std::string::npos ? "" : path.substr(dot + 1);
      std::vector<std::string> ends;
      for (const auto &format : read_formats)
        {
          if (format.first == end)
            {
              FileMesh mesh = format.second(path);
              if (!regions.empty())
                mesh.keep_regions(path, regions);
              if (end != "inp")
                turn_inside_out(mesh);
              check_elements(path, mesh);
              return mesh;
            }
          ends.push_back("." + format.first);
        }
      throw InputError("mesh file " + path + ": the end of the name must be one of " +
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
  } // namespace

  std::unique_ptr<BodyMesh> read_body(const std::string              &path,
                                      const std::vector<std::string> &regions_wanted)
  {
    // 1. What stands in the file, cells in deal.II's order of edges.
    FileMesh file = read_file(path, regions_wanted);
    orient(path, file);

    auto mesh  = std::make_unique<BodyMesh>();
    mesh->name = path.substr(path.rfind('/') + 1);
    // 2. Regions are numbered from 1; an element belongs to the first one that has it. Their nodes
    // are node sets as well.
    std::vector<unsigned int> regions(file.elements.size(), 0);
    for (unsigned int i = 0; i < file.regions.size(); ++i)
      {
        mesh->regions[i + 1] = file.regions[i].name;
        auto &nodes          = mesh->node_sets[file.regions[i].name];
        for (const unsigned int element : file.regions[i].members)
          {
            if (regions[element] == 0)
              regions[element] = i + 1;
            nodes.insert(nodes.end(), file.elements[element].begin(), file.elements[element].end());
          }
      }
    try
      {
        create_triangulation(*mesh, file.nodes, file.elements, regions);
      }
    catch (const dealii::ExceptionBase &)
      {
        throw InputError(path + ": the hexahedra cannot be joined to a mesh");
      }
    mesh->sector.assign(file.elements.size(), 0);

    // 3. Node sets, and surfaces with their node sets.
    for (const auto &groups : {file.node_sets, file.surfaces})
      for (const auto &group : groups)
        mesh->node_sets[group.name].insert(mesh->node_sets[group.name].end(),
                                           group.members.begin(),
                                           group.members.end());
    for (auto &set : mesh->node_sets)
      sort_unique(set.second);
    std::vector<std::string> names;
    for (const auto &group : file.surfaces)
      {
        names.push_back(group.name);
        try
          {
            mesh->surfaces[group.name] =
              surface_of_boundary(mesh->triangulation, group.name, mesh->node_sets.at(group.name));
          }
        catch (const InputError &error)
          {
            throw InputError(path + ": " + error.what());
          }
      }
    // More surfaces than ids: they are all known by name, the faces of the mesh have none.
    if (names.size() <= most_boundaries)
      name_boundaries(*mesh, names);

    // 4. Corners may be right-handed where the middle is inverted: Gauss points are looked at too.
    const MeshQuality quality = compute_mesh_quality(mesh->triangulation);
    if (!(quality.least_determinant > 0.))
      {
        std::ostringstream message;
        message << path << ": inverted hexahedron near " << quality.worst_cell_centre.transpose()
                << " mm";
        throw InputError(message.str());
      }
    return mesh;
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
