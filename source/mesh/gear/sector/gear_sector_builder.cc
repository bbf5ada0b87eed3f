// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/gear/grading.h>
#include <vfife/mesh/gear/sector/gear_sector_builder.h>
#include <vfife/mesh/gear/sector/gear_shaft_builder.h>
#include <vfife/mesh/gear/sector/gear_web_builder.h>
#include <vfife/mesh/node_set_names.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Depth of the dip in the base of the tooth block, over the mean transverse module. */
    constexpr double base_dip = .09;
    /** Depth under the root at which the columns of the rim are equally wide, over the circular
     * pitch. */
    constexpr double blend_depth = .2;

    /** From 0 to 1 with zero slope at both ends. */
    double smooth_step(const double x)
    {
      const double c = std::min(1., std::max(0., x));
      return c * c * (3. - 2. * c);
    }
  } // namespace

  GearSectorBuilder::GearSectorBuilder(const GearGeometry &gear, const GearBodyOptions &options)
    : gear_(gear)
    , options_(options)
    , at_toe_(options.web == WebKind::conical && options.web_attachment == WebAttachment::toe)
    , at_underside_(options.web == WebKind::conical && options.web_attachment != WebAttachment::toe)
    , sections_(compute_gear_sections(gear,
                                      options.cells_lengthwise,
                                      options.flank_rows,
                                      options.grading_towards_fillet,
                                      options.fillet_corner))
    , across_(graded_places_from_both_ends(options.cells_across, options.grading_towards_flank))
    , rim_parts_(graded_places(options.rim_rows, at_toe_ ? 1. : options.grading_towards_fillet))
    , web_(gear.blank(), options, sections_.front().root_height, sections_.back().root_height)
    , cells_(gear.name(), gear.pitch())
  {
    for (const GearSection &section : sections_)
      inner_.push_back(options.surface_layer > 0.
                         ? move_inward(gear, section, options.fillet_corner, options.surface_layer)
                         : section);
  }

  // A section L = const of the sector: rows and columns of the tooth, columns 0 ... last of the rim
  // below it, which share the row between the points P in the fillets.
  //
  //                   o----o----o----o         tip: tooth row flank_rows + 1
  //                  /     |    |     \        flanks
  //                 o------o----o------o       start of the flanks: tooth row 1
  //                /       |    |       \      fillets
  //               P--------o----o--------P     tooth row 0, which dips: rim columns 2 ... last - 2
  //    o----o---'          |    |          '---o----o
  //    |    |              |    |              |    |
  //    0    1              rim row 0      last - 1  last: column 0 of the next sector
  //
  // A chamfer of the tip is one more tooth row, between the end of the flanks and the tip.
  // Column 0 is the centre of the slot, 1 the bottom of the fillet; rim rows go down from there to
  // the underside or the bore. With a surface layer these are the blocks under the layer, whose
  // outline is that of inner_; the layer has one cell between each of its sides and the surface.
  GearSector GearSectorBuilder::build()
  {
    add_tooth();
    cells_.enter(GearRegion::rim);
    add_rim();
    add_surface_layer();
    WebFillets web_fillets;
    if (at_toe_ || at_underside_)
      {
        GearWebBuilder web(options_, web_, sections_, cells_);
        bore_       = web.add(web_foot());
        web_fillets = web.fillets();
      }
    add_named_ends();
    if (options_.shaft.present())
      GearShaftBuilder(options_.shaft, cells_, bore_).add();
    add_flank_grid(FlankSide::concave);
    add_flank_grid(FlankSide::convex);
    GearSector sector  = cells_.finish();
    sector.web_fillets = std::move(web_fillets);
    return sector;
  }

  Vector2 GearSectorBuilder::tooth_point(const GearSection &section,
                                         const unsigned int row,
                                         const unsigned int column) const
  {
    const double x     = across_[column];
    Vector2      point = (1. - x) * section.lower[row + 1] + x * section.upper[row + 1];
    if (row == 0)
      // a parabola between the two P
      point[0] -= base_dip * gear_.blank().mean_module() * 4. * x * (1. - x);
    return point;
  }

  void GearSectorBuilder::add_tooth()
  {
    const unsigned int rows = last_tooth_row(), across = options_.cells_across;
    for (const GearSection &section : inner_)
      {
        NodeLayer layer(rows + 1, std::vector<unsigned int>(across + 1));
        for (unsigned int row = 0; row <= rows; ++row)
          for (unsigned int c = 0; c <= across; ++c)
            {
              const Vector2 point = tooth_point(section, row, c);
              layer[row][c]       = cells_.add_node(
                position_of(gear_.blank(), section.cone_distance, point[0], point[1]));
            }
        tooth_.push_back(layer);
      }
    // cells between neighbouring sections
    for (unsigned int i = 0; i + 1 < sections_.size(); ++i)
      cells_.add_row(tooth_[i], tooth_[i + 1]);
  }

  Vector2 GearSectorBuilder::rim_top(const GearSection &section, const unsigned int column) const
  {
    // centre of the slot, bottom of the fillet, and between these the tooth's lowest row
    const unsigned int last = options_.columns();
    if (column == 0 || column == last)
      return {section.root_height, section.left_angle + (column == 0 ? 0. : section.pitch)};
    if (column == 1)
      return section.lower.front();
    if (column == last - 1)
      return section.upper.front();
    return tooth_point(section, 0, column - 2);
  }

  double GearSectorBuilder::rim_depth(const unsigned int i, const unsigned int row) const
  {
    const GearSection &section = sections_[i];
    const double       part    = rim_parts_[row];
    const double       start   = options_.surface_layer;
    if (options_.web == WebKind::solid)
      {
        const Vector2 root =
          gear_.blank().meridian_point({section.cone_distance, section.root_height});
        const double to_bore =
          (root[0] - options_.bore_radius) / std::cos(gear_.blank().pitch_angle);
        return start + part * (to_bore - start);
      }
    // a rim with an underside: even or graded rows, unless the web places them
    const double even = start + part * (options_.rim_thickness - start);
    if (!at_toe_)
      return even;
    // At the toe the rows stand at the layers of the web, towards the heel they spread evenly.
    const unsigned int above = rows_above_web(), below = above + options_.web_layers;
    double             at_toe;
    if (row < above)
      at_toe = start + (web_.wall_place(0.) - start) * row / above;
    else if (row <= below)
      at_toe = web_.wall_place(double(row - above) / options_.web_layers);
    else
      {
        const double end = web_.wall_place(1.);
        at_toe = end + (options_.rim_thickness - end) * (row - below) / (options_.rim_rows - below);
      }
    const double to_heel = smooth_step(double(i) / options_.cells_lengthwise);
    return (1. - to_heel) * at_toe + to_heel * even;
  }

  Vector3 GearSectorBuilder::rim_point(const unsigned int i,
                                       const unsigned int row,
                                       const unsigned int column) const
  {
    const BlankOutline &blank   = gear_.blank();
    const GearSection  &section = sections_[i];
    const Vector2       top     = rim_top(inner_[i], column);
    if (row == 0)
      return position_of(blank, section.cone_distance, top[0], top[1]);

    // Under the root the columns lose the widths that fillet and land give them: equally wide from
    // the blend depth on.
    const double depth          = rim_depth(i, row);
    const double circular_pitch = blank.circular_pitch(section.cone_distance);
    const double even           = section.pitch * column / options_.columns();
    const double blend          = smooth_step(depth / (blend_depth * circular_pitch));
    const double angle          = (1. - blend) * (top[1] - section.left_angle) + blend * even;
    if (at_underside_)
      {
        // Straight lines from the root to places on the underside that leave room for the web.
        const double  part   = depth / options_.rim_thickness;
        const double  place  = underside_place(i);
        const Vector2 bottom = blank.cone_coordinates(web_.wall_point(place));
        const double  L      = (1. - part) * section.cone_distance + part * place;
        return position_of(blank,
                           L,
                           (1. - part) * section.root_height + part * bottom[1],
                           left_angle_at(sections_, L) + angle);
      }
    // Straight down (along -h), or leaning by the mitre at the toe, less and less towards the heel.
    const double to_heel = double(i) / options_.cells_lengthwise;
    const double L =
      section.cone_distance + (at_toe_ ? (1. - to_heel) * web_.mitre_slope() * depth : 0.);
    return position_of(blank, L, section.root_height - depth, section.left_angle + angle);
  }

  unsigned int GearSectorBuilder::first_web_section() const
  {
    const unsigned int free = options_.cells_lengthwise - options_.web_layers;
    return options_.web_attachment == WebAttachment::heel ? free : free / 2;
  }

  double GearSectorBuilder::underside_place(const unsigned int i) const
  {
    const unsigned int first = first_web_section(), last = first + options_.web_layers;
    const double       inner = gear_.blank().inner_cone_distance(),
                 outer       = gear_.blank().outer_cone_distance;
    // sections spread evenly on either side of the web's foot
    if (i < first)
      return inner + (web_.wall_place(0.) - inner) * i / first;
    if (i <= last)
      return web_.wall_place(double(i - first) / options_.web_layers);
    return outer + (web_.wall_place(1.) - outer) * (options_.cells_lengthwise - i) /
                     (options_.cells_lengthwise - last);
  }

  void GearSectorBuilder::add_rim()
  {
    const unsigned int rows = options_.rim_rows, columns = options_.columns();
    for (unsigned int i = 0; i < sections_.size(); ++i)
      {
        NodeLayer layer(rows + 1, std::vector<unsigned int>(columns + 1));
        for (unsigned int row = 0; row <= rows; ++row)
          {
            for (unsigned int c = 0; c < columns; ++c)
              layer[row][c] = row == 0 && c >= 2 && c + 2 <= columns
                                ? tooth_[i][0][c - 2]
                                : cells_.add_node(rim_point(i, row, c));
            layer[row][columns] = GearSector::next_sector(layer[row][0]);
          }
        rim_.push_back(layer);
        if (options_.web == WebKind::solid)
          bore_.push_back(layer.back());
      }
    for (unsigned int i = 0; i + 1 < sections_.size(); ++i)
      cells_.add_row(rim_[i], rim_[i + 1]);
  }

  NodeLayer GearSectorBuilder::web_foot() const
  {
    const unsigned int layers = options_.web_layers;
    if (at_toe_)
      {
        const auto first = rim_.front().begin() + rows_above_web();
        return NodeLayer(first, first + layers + 1);
      }
    // the lowest rows of the sections that stand between the web's faces
    NodeLayer foot;
    for (unsigned int layer = 0; layer <= layers; ++layer)
      foot.push_back(rim_[first_web_section() + layer].back());
    return foot;
  }

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
      nodes.tip.push_back(add(tooth_point(section, last_tooth_row(), c)));
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

  void GearSectorBuilder::add_named_ends()
  {
    // toe and heel: faces of tooth and rim
    cells_.add_to_set(node_set::toe, tooth_.front());
    // The web covers the rows between its faces.
    const unsigned int above = at_toe_ ? rows_above_web() : options_.rim_rows,
                       below = at_toe_ ? above + options_.web_layers : above;
    for (unsigned int row = 0; row <= options_.rim_rows; ++row)
      if (row <= above || row >= below)
        cells_.add_to_set(node_set::toe, {rim_.front()[row]});
    cells_.add_to_set(node_set::heel, tooth_.back());
    cells_.add_to_set(node_set::heel, rim_.back());
    for (const auto &[surface, name] : {std::make_pair(&surface_.front(), node_set::toe),
                                        std::make_pair(&surface_.back(), node_set::heel)})
      cells_.add_to_set(name, {surface->below(), surface->around_tooth(), surface->above()});
    // underside or bore, rim, root land and tip by sections
    for (unsigned int i = 0; i < rim_.size(); ++i)
      {
        const NodeLayer &layer = rim_[i];
        // what lies between the faces of a web on the underside is inside
        if (!at_underside_ || i <= first_web_section() ||
            i >= first_web_section() + options_.web_layers)
          cells_.add_to_set(options_.web == WebKind::solid ? node_set::bore
                                                           : node_set::rim_underside,
                            {layer.back()});
        cells_.add_to_set(node_set::rim, layer);
        const SurfaceNodes &surface = surface_[i];
        cells_.add_to_set(node_set::rim, {surface.below(), surface.above()});
        cells_.add_to_set(node_set::root_land,
                          {{surface.slot, surface.lower[0], surface.upper[0]}});
        cells_.add_to_set(node_set::tip, {surface.tip});
      }
  }

  void GearSectorBuilder::add_flank_grid(const FlankSide side)
  {
    const bool upper = side == gear_.upper_side();
    FlankGrid  grid;
    grid.side               = side;
    const unsigned int rows = options_.flank_rows;
    for (unsigned int i = 0; i < sections_.size(); ++i)
      for (unsigned int row = 0; row <= rows; ++row)
        {
          const auto &profile = upper ? sections_[i].upper : sections_[i].lower;
          grid.nodes.push_back((upper ? surface_[i].upper : surface_[i].lower)[row + 2]);
          grid.L_h.emplace_back(sections_[i].cone_distance, profile[row + 2][0]);
          cells_.add_to_set(side == FlankSide::concave ? surface_name::concave
                                                       : surface_name::convex,
                            grid.nodes.back());
          if (i + 1 == sections_.size() || row == rows)
            continue;
          // (L, h, polar angle) is right-handed: seen from outside, xi runs along L on the upper
          // flank, against it on the lower.
          const unsigned int here = grid.nodes.size() - 1, there = here + rows + 1;
          if (upper)
            grid.facets.push_back({{here, there, there + 1, here + 1}});
          else
            grid.facets.push_back({{there, here, here + 1, there + 1}});
        }
    // fillet: bottom, P and start of the flank of every section; chamfer: end of the flank and tip
    const bool  concave = side == FlankSide::concave;
    const char *fillet  = concave ? node_set::concave_fillet : node_set::convex_fillet,
               *chamfer = concave ? node_set::concave_chamfer : node_set::convex_chamfer;
    for (const SurfaceNodes &surface : surface_)
      {
        const auto &profile = upper ? surface.upper : surface.lower;
        cells_.add_to_set(fillet, {{profile[0], profile[1], profile[2]}});
        if (tip_rows(gear_.blank()) > 0)
          cells_.add_to_set(chamfer, {{profile.begin() + rows + 2, profile.end()}});
      }
    cells_.add_flank(grid);
  }
} // namespace vfife
