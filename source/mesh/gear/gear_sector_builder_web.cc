// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/gear/gear_sector_builder.h>
#include <vfife/mesh/node_set_names.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** One face of a hexahedron, in lexicographic order. */
    using HalfHexahedron = std::array<unsigned int, 4>;
  } // namespace

  double GearSectorBuilder::web_angle(const double       u,
                                      const unsigned int layer,
                                      const double       fraction) const
  {
    // At the toe all sections start from one spiral angle; on the underside each layer starts from
    // its own, which goes linearly on the way to the hub.
    const double across = fraction * gear_.pitch();
    if (at_toe_)
      return sections_.front().left_angle + across;
    const double own = web_.wall_place(double(layer) / options_.web_layers);
    return (1. - u) * left_angle_at(own) + u * left_angle_at(web_.wall_place(.5)) + across;
  }

  Vector3
  GearSectorBuilder::web_point(const double u, const unsigned int layer, const double angle) const
  {
    const Vector2 r_z = web_.point(u, double(layer) / options_.web_layers);
    return {r_z[0] * std::cos(angle), r_z[0] * std::sin(angle), r_z[1]};
  }

  GearSectorBuilder::NodeLayer GearSectorBuilder::make_web_nodes(const double       u,
                                                                 const unsigned int columns)
  {
    NodeLayer nodes(options_.web_layers + 1, std::vector<unsigned int>(columns + 1));
    for (unsigned int layer = 0; layer <= options_.web_layers; ++layer)
      {
        for (unsigned int c = 0; c < columns; ++c)
          nodes[layer][c] = add_node(web_point(u, layer, web_angle(u, layer, double(c) / columns)));
        nodes[layer][columns] = GearSector::next_sector(nodes[layer][0]);
      }
    return nodes;
  }

  // A row in which three columns of the rim's side become one of the hub's, seen along the layers:
  //
  //    a0-----a1-----a2-----a3     rim side
  //    |       |      |      |
  //    |      c1-----c2      |     four cells: a0 a1 c1 b0, a1 a2 c2 c1, a2 a3 b1 c2, c1 c2 b1 b0
  //    |    .'          '.   |
  //    b0-------------------b1     hub side
  void GearSectorBuilder::add_coarsening_row(const NodeLayer &rim_side,
                                             const NodeLayer &hub_side,
                                             const double     u)
  {
    const unsigned int layers = options_.web_layers, groups = options_.columns() / 3;
    for (unsigned int g = 0; g < groups; ++g)
      {
        // the four quadrilaterals on every layer; two neighbouring layers bound a cell each
        std::vector<std::array<HalfHexahedron, 4>> faces;
        for (unsigned int layer = 0; layer <= layers; ++layer)
          {
            const unsigned int *a = &rim_side[layer][3 * g], *b = &hub_side[layer][g];
            // Between the columns of the rim, not yet equally wide, and those of the web.
            const auto angle = [&](const unsigned int k) {
              const Vector3 x    = position(a[k]);
              const double  even = web_angle(u, layer, (g + k / 3.) / groups);
              return even + .5 * std::remainder(std::atan2(x[1], x[0]) - even, 2. * pi);
            };
            const unsigned int c1 = add_node(web_point(u, layer, angle(1)));
            const unsigned int c2 = add_node(web_point(u, layer, angle(2)));
            faces.push_back({{{{a[0], b[0], a[1], c1}},
                              {{a[1], c1, a[2], c2}},
                              {{a[2], c2, a[3], b[1]}},
                              {{c1, b[0], c2, b[1]}}}});
            if (layer == 0 || layer == layers)
              for (const unsigned int c : {c1, c2})
                add_to_set(layer == 0 ? node_set::web_front : node_set::web_back, c);
          }
        for (unsigned int layer = 0; layer < layers; ++layer)
          for (unsigned int k = 0; k < 4; ++k)
            {
              CellNodes nodes;
              std::copy_n(faces[layer][k].begin(), 4, nodes.begin());
              std::copy_n(faces[layer + 1][k].begin(), 4, nodes.begin() + 4);
              add_hexahedron(nodes);
            }
      }
  }

  GearSectorBuilder::NodeLayer GearSectorBuilder::web_foot() const
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

  std::vector<double> GearSectorBuilder::web_stations(unsigned int &coarsening) const
  {
    // Fillet at the rim, straight part with the coarsening row first, fillet at the hub.
    const unsigned int  rows  = options_.web_rows;
    const double        start = web_.straight_start(), stop = web_.straight_end();
    std::vector<double> stations = {0.};
    if (options_.rim_fillet_radius > 0.)
      for (unsigned int row = 1; row <= options_.fillet_rows; ++row)
        stations.push_back(start * row / options_.fillet_rows);

    // The coarsening row is 0.8 of its three columns' width long: best of the lengths tried for the
    // least scaled Jacobian over all webs of the paper.
    coarsening               = options_.coarsens() ? stations.size() : 0;
    const double group_width = 3. * gear_.pitch() * web_.point(0., .5)[0] / options_.columns();
    const double straight    = (stop - start) * web_.length();
    const double first = coarsening > 0 ? std::min(.5, .8 * group_width / straight) : 1. / rows;
    for (unsigned int row = 1; row <= rows; ++row)
      {
        const double part = rows == 1 ? 1. : first + (1. - first) * (row - 1) / (rows - 1);
        stations.push_back(start + (stop - start) * part);
      }
    if (options_.hub_fillet_radius > 0.)
      for (unsigned int row = 1; row <= options_.fillet_rows; ++row)
        stations.push_back(stop + (1. - stop) * row / options_.fillet_rows);
    return stations;
  }

  void GearSectorBuilder::add_web()
  {
    unsigned int              coarsening = 0;
    const std::vector<double> stations   = web_stations(coarsening);
    NodeLayer                 previous   = web_foot();
    unsigned int              columns    = options_.columns();

    // first and last layer are the web's faces
    const auto add_faces = [&](const NodeLayer &nodes) {
      for (const unsigned int node : nodes.front())
        add_to_set(node_set::web_front, node);
      for (const unsigned int node : nodes.back())
        add_to_set(node_set::web_back, node);
    };
    add_faces(previous);
    for (unsigned int row = 1; row < stations.size(); ++row)
      {
        const double u = stations[row], last = stations[row - 1];
        if (row == coarsening)
          columns /= 3;
        const NodeLayer next = make_web_nodes(u, columns);
        if (row == coarsening)
          add_coarsening_row(previous, next, last + .6 * (u - last));
        else
          add_row(previous, next);
        add_faces(next);
        previous = next;
      }
    // node A: in the middle of the sector where the faces meet the hub
    add_to_set(node_set::node_A_front, previous.front()[columns / 2]);
    add_to_set(node_set::node_A_back, previous.back()[columns / 2]);
    add_hub(previous);
  }

  void GearSectorBuilder::add_hub(const NodeLayer &web_end)
  {
    region_                   = GearRegion::hub;
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
                const double angle = web_angle(1., 0, double(c) / columns);
                nodes[line][c] =
                  on_web ? web_end[line - side][c]
                         : add_node({r * std::cos(angle), r * std::sin(angle), height(line)});
                add_to_set(node_set::hub, nodes[line][c]);
                if (row == options_.hub_rows)
                  add_to_set(node_set::bore, nodes[line][c]);
              }
            nodes[line][columns] = GearSector::next_sector(nodes[line][0]);
          }
        if (row > 0)
          add_row(previous, nodes);
        previous = nodes;
      }
  }

} // namespace vfife
