// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/gear/gear_sector_builder.h>

namespace vfife
{
  std::vector<unsigned int> GearSectorBuilder::SurfaceNodes::around_tooth() const
  {
    // The corners of the tip are ends of both profiles.
    std::vector<unsigned int> nodes(lower.begin() + 1, lower.end());
    nodes.insert(nodes.end(), tip.begin() + 1, tip.end() - 1);
    nodes.insert(nodes.end(), upper.rbegin(), upper.rend() - 1);
    return nodes;
  }

  std::vector<unsigned int> GearSectorBuilder::SurfaceNodes::above() const
  {
    return {upper[1], upper[0], GearSector::next_sector(slot)};
  }

  GearSectorBuilder::SurfaceNodes GearSectorBuilder::outline_of_blocks(const unsigned int i) const
  {
    const auto  &root = rim_[i].front();
    SurfaceNodes nodes;
    nodes.slot  = root[0];
    nodes.lower = {root[1]};
    nodes.upper = {root[options_.columns() - 1]};
    for (const auto &row : tooth_[i])
      {
        nodes.lower.push_back(row.front());
        nodes.upper.push_back(row.back());
      }
    nodes.tip = tooth_[i].back();
    return nodes;
  }

  GearSectorBuilder::SurfaceNodes GearSectorBuilder::make_surface_nodes(const unsigned int i)
  {
    const GearSection &section = sections_[i];
    const auto         add     = [&](const Vector2 &point) {
      return cells_.add_node(position_of(gear_.blank(), section.cone_distance, point[0], point[1]));
    };
    SurfaceNodes nodes;
    nodes.slot = add({section.root_height, section.left_angle});
    for (const Vector2 &point : section.lower)
      nodes.lower.push_back(add(point));
    for (const Vector2 &point : section.upper)
      nodes.upper.push_back(add(point));
    nodes.tip = {nodes.lower.back()};
    for (unsigned int c = 1; c < options_.cells_across; ++c)
      nodes.tip.push_back(add(tooth_point(section, options_.flank_rows + 1, c)));
    nodes.tip.push_back(nodes.upper.back());
    return nodes;
  }

  void GearSectorBuilder::add_surface_layer()
  {
    std::vector<SurfaceNodes> blocks;
    for (unsigned int i = 0; i < sections_.size(); ++i)
      blocks.push_back(outline_of_blocks(i));
    if (!(options_.surface_layer > 0.))
      {
        surface_ = blocks;
        return;
      }
    for (unsigned int i = 0; i < sections_.size(); ++i)
      surface_.push_back(make_surface_nodes(i));
    for (unsigned int i = 0; i + 1 < sections_.size(); ++i)
      {
        const SurfaceNodes &outer = surface_[i], &next_outer = surface_[i + 1];
        const SurfaceNodes &inner = blocks[i], &next_inner = blocks[i + 1];
        cells_.enter(GearRegion::rim);
        cells_.add_row({outer.below(), inner.below()}, {next_outer.below(), next_inner.below()});
        cells_.add_row({outer.above(), inner.above()}, {next_outer.above(), next_inner.above()});
        cells_.enter(GearRegion::tooth);
        cells_.add_row({outer.around_tooth(), inner.around_tooth()},
                       {next_outer.around_tooth(), next_inner.around_tooth()});
      }
  }
} // namespace vfife
