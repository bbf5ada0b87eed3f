// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/gear/flank_surface.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_body_check.h>
#include <vfife/mesh/gear/gear_body_sizes.h>
#include <vfife/mesh/gear/gear_manifolds.h>
#include <vfife/mesh/gear/gear_shaft_check.h>
#include <vfife/mesh/gear/refined_sector.h>
#include <vfife/mesh/gear/sector/gear_sector_builder.h>
#include <vfife/mesh/mesh_size.h>
#include <vfife/mesh/node_set_names.h>

namespace vfife
{
  namespace
  {
    /** Names of the cells' material ids, as they stand in files. */
    std::map<unsigned int, std::string> gear_region_names()
    {
      return {{static_cast<unsigned int>(GearRegion::tooth), "teeth"},
              {static_cast<unsigned int>(GearRegion::rim), "rim"},
              {static_cast<unsigned int>(GearRegion::web), "web"},
              {static_cast<unsigned int>(GearRegion::hub), "hub"},
              {static_cast<unsigned int>(GearRegion::shaft), "shaft"}};
    }

    /** The template, refined as often as asked for. */
    GearSector make_gear_sector(const GearGeometry &gear, const GearBodyOptions &options)
    {
      const GearSector sector = GearSectorBuilder(gear, options).build();
      return options.refinements == 0 ? sector
                                      : refine_gear_sector(gear, sector, options.refinements);
    }
  } // namespace

  std::unique_ptr<BodyMesh> make_gear_body(const GearGeometry &gear, const GearBodyOptions &asked)
  {
    check_gear_body(gear.name(), asked, gear.blank());
    check_gear_shaft(gear.name() + "/Shaft", gear, asked);
    check_surface_layer(gear.name() + "/Mesh", gear, asked.fillet_corner, asked.surface_layer);
    // 1. The template of one sector.
    const GearBodyOptions options = with_counts_of_size(asked, gear);
    check_mesh_size(gear.name(), options.n_cells(gear.blank()));
    const GearSector   sector    = make_gear_sector(gear, options);
    const unsigned int n_sectors = gear.blank().teeth, n_nodes = sector.nodes.size();

    // 2. Its copies, turned about the axis; a node of the next sector is that of sector k + 1.
    auto mesh  = std::make_unique<BodyMesh>();
    mesh->name = gear.name();

    std::vector<Vector3>   nodes;
    std::vector<CellNodes> hexahedra;
    nodes.reserve(std::size_t(n_sectors) * n_nodes);
    hexahedra.reserve(n_sectors * sector.hexahedra.size());
    for (unsigned int k = 0; k < n_sectors; ++k)
      {
        const Matrix3 rotation = rotation_about(Vector3::UnitZ(), 2. * pi * k / n_sectors);
        for (const Vector3 &node : sector.nodes)
          nodes.push_back(rotation * node);
        for (CellNodes hexahedron : sector.hexahedra)
          {
            for (unsigned int &node : hexahedron)
              node = GearSector::index_of(node) +
                     (GearSector::is_next(node) ? (k + 1) % n_sectors : k) * n_nodes;
            hexahedra.push_back(hexahedron);
          }
      }
    // 3. The triangulation, with material ids.
    std::vector<unsigned int> regions;
    for (unsigned int k = 0; k < n_sectors; ++k)
      regions.insert(regions.end(), sector.regions.begin(), sector.regions.end());
    create_triangulation(*mesh, nodes, hexahedra, regions, n_sectors);
    mesh->regions = gear_region_names();

    // 4. Sets and surfaces of all sectors, then boundary ids and manifolds, which need the sets.
    for (const auto &set : sector.node_sets)
      for (unsigned int k = 0; k < n_sectors; ++k)
        for (const unsigned int node : set.second)
          mesh->node_sets[set.first].push_back(node + k * n_nodes);
    for (const FlankGrid &grid : sector.flanks)
      {
        FacetSurface surface         = make_flank_surface(gear, grid, n_nodes);
        mesh->surfaces[surface.name] = std::move(surface);
      }
    name_boundaries(*mesh, gear_boundaries());
    attach_gear_manifolds(*mesh, gear, sector.web_fillets);
    return mesh;
  }
} // namespace vfife
