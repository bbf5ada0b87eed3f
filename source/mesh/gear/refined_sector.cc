// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/gear/gear_manifolds.h>
#include <vfife/mesh/gear/refined_sector.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>

#include <algorithm>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Node set of the sector's upper side face, which belongs to the next sector. */
    constexpr char upper_side[] = "upper side";

    /** Far below any cell's size, far above round-off. */
    constexpr double matching_tolerance = 1e-6;

    std::vector<std::string> sector_boundaries()
    {
      auto names = gear_boundaries();
      names.push_back(upper_side);
      return names;
    }

    Vector3 vertex(const BodyMesh &mesh, const unsigned int i)
    {
      const auto &x = mesh.triangulation.get_vertices()[i];
      return {x[0], x[1], x[2]};
    }

    /** The sector as a body of its own, with nodes on its upper side face. */
    std::unique_ptr<BodyMesh> open_sector(const GearGeometry &gear, const GearSector &sector)
    {
      auto mesh  = std::make_unique<BodyMesh>();
      mesh->name = gear.name();

      // Nodes that belong to the next sector are copied onto the upper side face; the copies are
      // members of the same sets, and of one more by which they are known after refinement.
      std::vector<Vector3>      nodes = sector.nodes;
      std::vector<CellNodes>    cells = sector.hexahedra;
      const unsigned int        none  = -1;
      const Matrix3             turn  = rotation_about(Vector3::UnitZ(), gear.pitch());
      std::vector<unsigned int> copies(nodes.size(), none);
      mesh->node_sets = sector.node_sets;
      for (CellNodes &cell : cells)
        for (unsigned int &node : cell)
          {
            if (!GearSector::is_next(node))
              continue;
            unsigned int &copy = copies[GearSector::index_of(node)];
            if (copy == none)
              {
                copy = nodes.size();
                nodes.push_back(turn * sector.nodes[GearSector::index_of(node)]);
                mesh->node_sets[upper_side].push_back(copy);
              }
            node = copy;
          }
      for (auto &set : mesh->node_sets)
        {
          if (set.first == upper_side)
            continue;
          const auto originals = set.second;
          for (const unsigned int node : originals)
            if (copies[node] != none)
              set.second.push_back(copies[node]);
        }
      // boundaries by these sets, true surfaces by manifolds
      create_triangulation(*mesh, nodes, cells, sector.regions);
      name_boundaries(*mesh, sector_boundaries());
      attach_gear_manifolds(*mesh, gear, sector.web_fillets);
      return mesh;
    }

    /** For each vertex the node of the refined sector: numbers in the order of vertices, those of
     * the upper side being the next sector's. */
    std::vector<unsigned int> number_nodes(const GearGeometry &gear, const BodyMesh &mesh)
    {
      // vertices on the upper side face, and on other unnamed faces, among them the lower side
      const unsigned int upper_id = sector_boundaries().size(), n = mesh.triangulation.n_vertices();
      std::vector<bool>  is_upper(n, false), is_side(n, false);
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && (face->boundary_id() == upper_id || face->boundary_id() == 0))
            for (unsigned int v = 0; v < 4; ++v)
              (face->boundary_id() == upper_id ? is_upper : is_side)[face->vertex_index(v)] = true;

      // all but the upper side's are nodes of this sector
      std::vector<unsigned int> number(n), side_nodes;
      unsigned int              count = 0;
      for (unsigned int i = 0; i < n; ++i)
        {
          if (is_upper[i])
            continue;
          number[i] = count++;
          if (is_side[i])
            side_nodes.push_back(i);
        }
      // an upper vertex is, turned back by a pitch, that node of the next sector's lower side
      const Matrix3 back = rotation_about(Vector3::UnitZ(), -gear.pitch());
      for (unsigned int i = 0; i < n; ++i)
        if (is_upper[i])
          {
            const Vector3 x = back * vertex(mesh, i);
            const auto    match =
              std::find_if(side_nodes.begin(), side_nodes.end(), [&](const unsigned int candidate) {
                return (vertex(mesh, candidate) - x).squaredNorm() <
                       matching_tolerance * matching_tolerance;
              });
            if (match == side_nodes.end())
              throw NumericalError(gear.name() + ": the refined sides of a sector do not match");
            number[i] = GearSector::next_sector(number[*match]);
          }
      return number;
    }

    /** Sets of the refined sector: faces of named boundaries, cells of regions; node A stays. */
    void add_sets(const BodyMesh                  &mesh,
                  const GearSector                &coarse,
                  const std::vector<unsigned int> &number,
                  GearSector                      &sector)
    {
      const auto add = [&](const std::string &name, const unsigned int vertex_index) {
        if (!GearSector::is_next(number[vertex_index]))
          sector.node_sets[name].push_back(number[vertex_index]);
      };
      for (const char *name : {node_set::node_A_front, node_set::node_A_back})
        if (coarse.node_sets.count(name) != 0)
          for (const unsigned int node : coarse.node_sets.at(name))
            add(name, node);
      const std::pair<GearRegion, const char *> parts[] = {{GearRegion::rim, node_set::rim},
                                                           {GearRegion::hub, node_set::hub},
                                                           {GearRegion::shaft, node_set::shaft}};
      constexpr auto shaft = static_cast<unsigned int>(GearRegion::shaft);
      const auto     names = gear_boundaries();
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        {
          for (const auto &part : parts)
            if (cell->material_id() == static_cast<unsigned int>(part.first))
              for (const unsigned int v : cell->vertex_indices())
                add(part.second, cell->vertex_index(v));
          for (const unsigned int f : cell->face_indices())
            {
              const auto         face = cell->face(f);
              const unsigned int id   = face->at_boundary() ? face->boundary_id() : 0;
              // with a shaft the bore is inside, between it and the rest
              const bool on_shaft = !face->at_boundary() && cell->material_id() == shaft &&
                                    cell->neighbor(f)->material_id() != shaft;
              if (on_shaft || (id > 0 && id <= names.size()))
                for (unsigned int v = 0; v < 4; ++v)
                  add(on_shaft ? node_set::bore : names[id - 1], face->vertex_index(v));
            }
        }
      for (const auto &[name, arc] : coarse.web_fillets)
        for (const auto &cell : mesh.triangulation.active_cell_iterators())
          for (const unsigned int v : cell->vertex_indices())
            if (arc.contains(vertex(mesh, cell->vertex_index(v))))
              add(name, cell->vertex_index(v));
      for (auto &set : sector.node_sets)
        {
          auto &nodes = set.second;
          std::sort(nodes.begin(), nodes.end());
          nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        }
    }

    /** Nodes and facets of a refined flank, first sides along the tooth. */
    FlankGrid make_grid(const GearGeometry              &gear,
                        const BodyMesh                  &mesh,
                        const FlankSide                  side,
                        const std::vector<unsigned int> &number)
    {
      const char *name = side == FlankSide::concave ? surface_name::concave : surface_name::convex;
      // the flank's boundary faces
      unsigned int id = 0;
      for (const auto &boundary : mesh.boundaries)
        if (boundary.second == name)
          id = boundary.first;
      const FacetSurface surface = surface_of_boundary(mesh.triangulation, name, id);

      FlankGrid grid;
      grid.side = side;
      for (unsigned int i = 0; i < surface.nodes.size(); ++i)
        {
          const Vector3 &x = surface.positions[i];
          grid.nodes.push_back(number[surface.nodes[i]]);
          grid.L_h.push_back(gear.blank().coordinates_of(x));
        }
      // Along L on the upper flank, against it on the lower, as in the unrefined grid.
      const double along = side == gear.upper_side() ? 1. : -1.;
      for (auto facet : surface.facets)
        {
          const auto rise = [&](const unsigned int k) {
            return along * (grid.L_h[facet[(k + 1) % 4]][0] - grid.L_h[facet[k]][0]);
          };
          // The side on which L rises most runs along the tooth.
          unsigned int first = 0;
          for (unsigned int k = 1; k < 4; ++k)
            if (rise(k) > rise(first))
              first = k;
          std::rotate(facet.begin(), facet.begin() + first, facet.end());
          grid.facets.push_back(facet);
        }
      return grid;
    }
  } // namespace

  GearSector
  refine_gear_sector(const GearGeometry &gear, const GearSector &sector, const unsigned int times)
  {
    // 1. The sector alone, refined on its manifolds, which may invert cells.
    const auto mesh = open_sector(gear, sector);
    mesh->triangulation.refine_global(times);

    const MeshQuality quality = compute_mesh_quality(mesh->triangulation);
    if (!(quality.least_determinant > 0.))
      {
        std::ostringstream message;
        message << gear.name() << ": refinement inverts a cell at "
                << quality.worst_cell_centre.transpose() << " mm (body frame)";
        throw NumericalError(message.str());
      }

    // 2. Its vertices as nodes of this sector or the next, cells with their regions.
    const std::vector<unsigned int> number = number_nodes(gear, *mesh);
    GearSector                      refined;
    refined.web_fillets = sector.web_fillets;
    for (unsigned int i = 0; i < number.size(); ++i)
      if (!GearSector::is_next(number[i]))
        refined.nodes.push_back(vertex(*mesh, i));
    for (const auto &cell : mesh->triangulation.active_cell_iterators())
      {
        CellNodes nodes;
        for (unsigned int v = 0; v < 8; ++v)
          nodes[v] = number[cell->vertex_index(v)];
        refined.hexahedra.push_back(nodes);
        refined.regions.push_back(cell->material_id());
      }
    // 3. Sets and flanks by boundary and region.
    add_sets(*mesh, sector, number, refined);
    for (const FlankSide side : {FlankSide::concave, FlankSide::convex})
      refined.flanks.push_back(make_grid(gear, *mesh, side, number));
    return refined;
  }
} // namespace vfife
