// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/gear/sector/gear_web_builder.h>
#include <vfife/mesh/node_set_names.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  GearWebBuilder::GearWebBuilder(const GearBodyOptions          &options,
                                 const ConicalWeb               &web,
                                 const std::vector<GearSection> &sections,
                                 GearSectorCells                &cells)
    : options_(options)
    , web_(web)
    , sections_(sections)
    , cells_(cells)
  {
  }

  double
  GearWebBuilder::angle_at(const double u, const unsigned int layer, const double fraction) const
  {
    // At the toe all sections start from one spiral angle; on the underside each layer starts from
    // its own, which goes linearly on the way to the hub.
    const double across = fraction * sections_.front().pitch;
    if (options_.web_attachment == WebAttachment::toe)
      return sections_.front().left_angle + across;
    const double own = web_.wall_place(double(layer) / options_.web_layers);
    return (1. - u) * left_angle_at(sections_, own) +
           u * left_angle_at(sections_, web_.wall_place(.5)) + across;
  }

  double GearWebBuilder::foot_dip(const double x) const
  {
    // Without it cells where a fillet is tangent to the hub have a corner without an angle.
    constexpr double of_foot = .15, of_row = .5;
    if (options_.hub_fillet_radius == 0.)
      return 0.;
    const double row = (options_.hub_radius - options_.bore_radius) / options_.hub_rows;
    return std::min(of_foot * web_.foot_on_hub(), of_row * row) * 4. * x * (1. - x);
  }

  Vector3 GearWebBuilder::point(const double u, const unsigned int layer, const double angle) const
  {
    const double x   = double(layer) / options_.web_layers;
    Vector2      r_z = web_.point(u, x);
    if (u == 1.)
      r_z[0] -= foot_dip(x);
    return {r_z[0] * std::cos(angle), r_z[0] * std::sin(angle), r_z[1]};
  }

  NodeLayer GearWebBuilder::make_nodes(const double u, const unsigned int columns)
  {
    NodeLayer nodes(options_.web_layers + 1, std::vector<unsigned int>(columns + 1));
    for (unsigned int layer = 0; layer <= options_.web_layers; ++layer)
      {
        for (unsigned int c = 0; c < columns; ++c)
          nodes[layer][c] =
            cells_.add_node(point(u, layer, angle_at(u, layer, double(c) / columns)));
        nodes[layer][columns] = GearSector::next_sector(nodes[layer][0]);
      }
    return nodes;
  }

  void GearWebBuilder::add_coarsening_row(const NodeLayer &rim_side,
                                          const NodeLayer &hub_side,
                                          const double     u)
  {
    // Between the columns of the rim, not yet equally wide, and those of the web.
    const auto place = [&](const unsigned int layer, const unsigned int column) {
      const Vector3 x = cells_.position(rim_side[layer][column]);
      const double  even =
        angle_at(u, layer, (column / 3 + column % 3 / 3.) / (options_.columns() / 3));
      const double angle = even + .5 * std::remainder(polar_angle(x) - even, 2. * pi);
      return point(u, layer, angle);
    };
    const NodeLayer inner = cells_.add_coarsening_row(rim_side, hub_side, place);
    cells_.add_to_set(node_set::web_front, NodeLayer{inner.front()});
    cells_.add_to_set(node_set::web_back, NodeLayer{inner.back()});
  }

  std::vector<double> GearWebBuilder::make_stations(unsigned int &coarsening) const
  {
    // Fillet at the rim, straight part with the coarsening row first, fillet at the hub.
    const unsigned int  rows  = options_.web_rows;
    const double        start = web_.straight_start(), stop = web_.straight_end();
    std::vector<double> stations = {0.};
    if (options_.rim_fillet_radius > 0.)
      for (unsigned int row = 1; row <= options_.fillet_rows; ++row)
        stations.push_back(start * row / options_.fillet_rows);

    coarsening = options_.coarsens() ? stations.size() : 0;
    const double group_width =
      3. * sections_.front().pitch * web_.point(0., .5)[0] / options_.columns();
    const double straight = (stop - start) * web_.length();
    const double first =
      coarsening > 0 ? std::min(.5, coarsening_row_length * group_width / straight) : 1. / rows;
    for (unsigned int row = 1; row <= rows; ++row)
      {
        const double part = rows == 1 ? 1. : first + (1. - first) * (row - 1) / (rows - 1);
        stations.push_back(start + (stop - start) * part);
      }
    if (options_.hub_fillet_radius > 0.)
      for (unsigned int row = 1; row <= options_.fillet_rows; ++row)
        stations.push_back(
          row < options_.fillet_rows ? stop + (1. - stop) * row / options_.fillet_rows : 1.);
    return stations;
  }

  void GearWebBuilder::add_faces(const NodeLayer &nodes)
  {
    // First and last layer are the web's faces.
    cells_.add_to_set(node_set::web_front, NodeLayer{nodes.front()});
    cells_.add_to_set(node_set::web_back, NodeLayer{nodes.back()});
    const auto add_fillet =
      [this](const char *name, const MeridianArc &arc, const std::vector<unsigned int> &line) {
        if (!arc.contains(cells_.position(line.front())))
          return;
        cells_.add_to_set(name, NodeLayer{line});
        fillets_[name] = arc;
      };
    add_fillet(node_set::rim_fillet_front, web_.rim_fillet(0), nodes.front());
    add_fillet(node_set::hub_fillet_front, web_.hub_fillet(0), nodes.front());
    add_fillet(node_set::rim_fillet_back, web_.rim_fillet(1), nodes.back());
    add_fillet(node_set::hub_fillet_back, web_.hub_fillet(1), nodes.back());
  }

  NodeLayer GearWebBuilder::add(const NodeLayer &foot)
  {
    cells_.enter(GearRegion::web);
    unsigned int              coarsening = 0;
    const std::vector<double> stations   = make_stations(coarsening);
    NodeLayer                 previous   = foot;
    unsigned int              columns    = options_.columns();

    add_faces(previous);
    for (unsigned int row = 1; row < stations.size(); ++row)
      {
        const double u = stations[row], last = stations[row - 1];
        if (row == coarsening)
          columns /= 3;
        const NodeLayer next = make_nodes(u, columns);
        if (row == coarsening)
          add_coarsening_row(previous, next, last + coarsening_row_place * (u - last));
        else
          cells_.add_row(previous, next);
        add_faces(next);
        previous = next;
      }
    // node A: in the middle of the sector where the faces meet the hub
    cells_.add_to_set(node_set::node_A_front, previous.front()[columns / 2]);
    cells_.add_to_set(node_set::node_A_back, previous.back()[columns / 2]);
    return add_hub(previous);
  }

  NodeLayer GearWebBuilder::add_hub(const NodeLayer &web_end)
  {
    cells_.enter(GearRegion::hub);
    const unsigned int layers = options_.web_layers, side = options_.hub_side_cells;
    const unsigned int columns = web_end.front().size() - 1, lines = 2 * side + layers;
    const double       middle = web_.point(1., .5)[1];

    // Lines along the axis: side cells before the web, the web's layers, side cells behind it. At
    // the bore they stand as at the web.
    const auto height = [&](const unsigned int line) {
      const double front = web_.point(1., 0.)[1], back = web_.point(1., 1.)[1];
      const double low  = middle - .5 * options_.hub_length,
                   high = middle + .5 * options_.hub_length;
      if (line < side)
        return low + (front - low) * line / side;
      if (line <= side + layers)
        return web_.point(1., double(line - side) / layers)[1];
      return back + (high - back) * (line - side - layers) / side;
    };
    NodeLayer previous;
    for (unsigned int row = 0; row <= options_.hub_rows; ++row)
      {
        const double r = options_.hub_radius +
                         (options_.bore_radius - options_.hub_radius) * row / options_.hub_rows;
        NodeLayer nodes(lines + 1, std::vector<unsigned int>(columns + 1));
        for (unsigned int line = 0; line <= lines; ++line)
          {
            const bool on_web = row == 0 && line >= side && line <= side + layers;
            for (unsigned int c = 0; c < columns; ++c)
              {
                const double angle = angle_at(1., 0, double(c) / columns);
                nodes[line][c] =
                  on_web
                    ? web_end[line - side][c]
                    : cells_.add_node({r * std::cos(angle), r * std::sin(angle), height(line)});
                cells_.add_to_set(node_set::hub, nodes[line][c]);
                if (row == options_.hub_rows)
                  cells_.add_to_set(node_set::bore, nodes[line][c]);
              }
            nodes[line][columns] = GearSector::next_sector(nodes[line][0]);
          }
        if (row > 0)
          cells_.add_row(previous, nodes);
        previous = nodes;
      }
    return previous;
  }
} // namespace vfife
