// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/files/mesh_import.h>
#include <vfife/mesh/mesh_quality.h>

#include "file_mesh.h"

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace vfife
{
  namespace
  {
    using GridInput = dealii::GridIn<3>;
    /** Names of physical groups: [dimension][number]. */
    using GroupNames = std::map<unsigned int, std::map<unsigned int, std::string>>;

    void sort_unique(std::vector<unsigned int> &members)
    {
      std::sort(members.begin(), members.end());
      members.erase(std::unique(members.begin(), members.end()), members.end());
    }

    /** Names in the section $PhysicalNames of a Gmsh file. */
    GroupNames read_group_names(const std::string &path)
    {
      std::ifstream in(path);
      std::string   line;
      GroupNames    names;
      while (std::getline(in, line) && line.rfind("$Nodes", 0) != 0)
        {
          //   dimension number "name"
          std::istringstream words(line);
          unsigned int       dimension, number;
          const auto         quote = line.find('"'), end = line.rfind('"');
          if (quote != end && words >> dimension >> number)
            names[dimension][number] = line.substr(quote + 1, end - quote - 1);
        }
      return names;
    }

    /** Hexahedra, ids and names of what deal.II has read. */
    FileMesh take_over(const dealii::Triangulation<3> &triangulation, GroupNames names)
    {
      FileMesh                                     mesh;
      std::map<std::string, std::vector<unsigned>> surfaces, regions;
      // place of each vertex among the nodes that are used
      std::vector<unsigned int> index(triangulation.n_vertices(), -1);
      // physical names where the file has them
      const auto name_of = [&](const unsigned int dimension, const unsigned int id) {
        const auto &of_dimension = names[dimension];
        const auto  found        = of_dimension.find(id);
        return found != of_dimension.end()
                 ? found->second
                 : (dimension == 2 ? "boundary " : "region ") + std::to_string(id);
      };
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          CellNodes nodes;
          for (unsigned int v = 0; v < 8; ++v)
            {
              unsigned int &i = index[cell->vertex_index(v)];
              if (i == static_cast<unsigned int>(-1))
                {
                  i = mesh.nodes.size();
                  mesh.nodes.emplace_back(cell->vertex(v)[0],
                                          cell->vertex(v)[1],
                                          cell->vertex(v)[2]);
                }
              nodes[v] = i;
            }
          regions[name_of(3, cell->material_id())].push_back(mesh.elements.size());
          mesh.elements.push_back(nodes);
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() != 0)
              for (unsigned int v = 0; v < 4; ++v)
                surfaces[name_of(2, face->boundary_id())].push_back(index[face->vertex_index(v)]);
        }
      for (auto &surface : surfaces)
        mesh.surfaces.push_back({surface.first, surface.second});
      for (auto &region : regions)
        mesh.regions.push_back({region.first, region.second});
      return mesh;
    }

    /** Formats that deal.II reads. */
    FileMesh read_by_deal_ii(const std::string &path, const GridInput::Format format)
    {
      dealii::Triangulation<3> triangulation;
      try
        {
          std::ifstream in(path);
          GridInput     grid_in(triangulation);
          grid_in.read(in, format);
        }
      catch (const dealii::ExceptionBase &error)
        {
          std::string what = error.get_exc_name();
          if (what.empty())
            what = "unknown content";
          throw InputError(path + ": cannot be read as a mesh of hexahedra in the format " +
                           GridInput::default_suffix(format) + " (deal.II says " + what + ")");
        }
      if (triangulation.n_active_cells() == 0 ||
          !triangulation.all_reference_cells_are_hyper_cube())
        throw InputError(path + ": has other volume elements than hexahedra, or none");
      if (format != GridInput::msh)
        return take_over(triangulation, GroupNames());
      // what deal.II passes over: names of groups, and physical points
      GroupNames names = read_group_names(path);
      FileMesh   mesh  = take_over(triangulation, names);
      add_gmsh_points(path, names[0], mesh);
      return mesh;
    }

    using ReadMesh = FileMesh (*)(const std::string &path);

    /** All formats, by the end of the file's name. */
    const Choices<ReadMesh> formats = {
      {"msh", [](const std::string &path) { return read_by_deal_ii(path, GridInput::msh); }},
      {"inp", &read_abaqus},
      {"vtk", [](const std::string &path) { return read_by_deal_ii(path, GridInput::vtk); }},
      {"ucd", [](const std::string &path) { return read_by_deal_ii(path, GridInput::ucd); }}};

    FileMesh read_file(const std::string &path)
    {
      if (!std::ifstream(path))
        throw InputError("mesh file " + path + " cannot be opened");
      const auto               dot = path.rfind('.');
      const std::string        end = dot == std::string::npos ? "" : path.substr(dot + 1);
      std::vector<std::string> ends;
      for (const auto &format : formats)
        {
          if (format.first == end)
            return format.second(path);
          ends.push_back("." + format.first);
        }
      throw InputError("mesh file " + path + ": the end of the name must be one of " +
                       list_of(ends));
    }

    /** deal.II wants opposite edges of a cell to point the same way in all cells. */
    void orient(const std::string &path, FileMesh &mesh)
    {
      // an inverted element is told by its volume, before the order of its edges is touched
      std::vector<dealii::Point<3>> points;
      for (const Vector3 &x : mesh.nodes)
        points.emplace_back(x[0], x[1], x[2]);
      std::vector<dealii::CellData<3>> cells(mesh.elements.size());
      for (std::size_t e = 0; e < cells.size(); ++e)
        {
          std::copy(mesh.elements[e].begin(), mesh.elements[e].end(), cells[e].vertices.begin());
          if (!(dealii::GridTools::cell_measure<3>(points, cells[e].vertices) > 0.))
            throw InputError(path + ": element " + std::to_string(e + 1) +
                             " (in the order of the file) is inverted");
        }
      dealii::GridTools::consistently_order_cells(cells);
      for (std::size_t e = 0; e < cells.size(); ++e)
        std::copy(cells[e].vertices.begin(), cells[e].vertices.end(), mesh.elements[e].begin());
    }
  } // namespace

  std::unique_ptr<BodyMesh> read_body(const std::string &path)
  {
    // 1. What stands in the file, cells in deal.II's order of edges.
    FileMesh file = read_file(path);
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
    create_triangulation(*mesh, file.nodes, file.elements, regions);
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
        mesh->surfaces[group.name] =
          surface_of_boundary(mesh->triangulation, group.name, mesh->node_sets.at(group.name));
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
} // namespace vfife
