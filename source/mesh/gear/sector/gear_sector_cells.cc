// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/gear/sector/gear_sector_cells.h>

#include <Eigen/LU>

#include <algorithm>
#include <sstream>
#include <utility>

namespace vfife
{
  namespace
  {
    /** One face of a hexahedron, in lexicographic order. */
    using HalfHexahedron = std::array<unsigned int, 4>;
  } // namespace

  GearSectorCells::GearSectorCells(std::string name, const double pitch)
    : name_(std::move(name))
    , to_next_(rotation_about(Vector3::UnitZ(), pitch))
  {
  }

  void GearSectorCells::enter(const GearRegion region)
  {
    region_ = region;
  }

  unsigned int GearSectorCells::add_node(const Vector3 &position)
  {
    sector_.nodes.push_back(position);
    return sector_.nodes.size() - 1;
  }

  Vector3 GearSectorCells::position(const unsigned int node) const
  {
    const Vector3 &x = sector_.nodes[GearSector::index_of(node)];
    return GearSector::is_next(node) ? Vector3(to_next_ * x) : x;
  }

  void GearSectorCells::add_hexahedron(CellNodes nodes)
  {
    // volume spanned by the three edges that leave a corner
    const auto determinant = [&](const unsigned int corner) {
      Matrix3 edges;
      for (unsigned int d = 0; d < 3; ++d)
        edges.col(d) = position(nodes[corner | (1u << d)]) - position(nodes[corner & ~(1u << d)]);
      return edges.determinant();
    };
    // The blocks are indexed as suits them: one rule makes their cells right-handed.
    if (determinant(0) < 0.)
      for (unsigned int v = 0; v < 4; ++v)
        std::swap(nodes[v], nodes[v + 4]);
    for (unsigned int v = 0; v < 8; ++v)
      if (!(determinant(v) > 0.))
        {
          std::ostringstream message;
          message << name_ << ": inverted cell at " << position(nodes[v]).transpose()
                  << " mm (body frame): change the web, the rim or the number of cells";
          throw NumericalError(message.str());
        }
    sector_.hexahedra.push_back(nodes);
    sector_.regions.push_back(static_cast<unsigned int>(region_));
  }

  void GearSectorCells::add_row(const NodeLayer &first, const NodeLayer &second)
  {
    for (unsigned int row = 0; row + 1 < first.size(); ++row)
      for (unsigned int c = 0; c + 1 < first[row].size(); ++c)
        add_hexahedron({{first[row][c],
                         second[row][c],
                         first[row + 1][c],
                         second[row + 1][c],
                         first[row][c + 1],
                         second[row][c + 1],
                         first[row + 1][c + 1],
                         second[row + 1][c + 1]}});
  }

  // Seen along the layers:
  //
  //    a0-----a1-----a2-----a3     fine side
  //    |       |      |      |
  //    |      c1-----c2      |     four cells: a0 a1 c1 b0, a1 a2 c2 c1, a2 a3 b1 c2, c1 c2 b1 b0
  //    |    .'          '.   |
  //    b0-------------------b1     coarse side
  NodeLayer GearSectorCells::add_coarsening_row(const NodeLayer  &fine,
                                                const NodeLayer  &coarse,
                                                const InnerPlace &inner_place)
  {
    const unsigned int layers = fine.size(), groups = coarse.front().size() - 1;
    NodeLayer          inner(layers);
    for (unsigned int g = 0; g < groups; ++g)
      {
        // the four quadrilaterals on every layer; two neighbouring layers bound a cell each
        std::vector<std::array<HalfHexahedron, 4>> faces;
        for (unsigned int layer = 0; layer < layers; ++layer)
          {
            const unsigned int *a = &fine[layer][3 * g], *b = &coarse[layer][g];
            const unsigned int  c1 = add_node(inner_place(layer, 3 * g + 1));
            const unsigned int  c2 = add_node(inner_place(layer, 3 * g + 2));
            faces.push_back({{{{a[0], b[0], a[1], c1}},
                              {{a[1], c1, a[2], c2}},
                              {{a[2], c2, a[3], b[1]}},
                              {{c1, b[0], c2, b[1]}}}});
            inner[layer].insert(inner[layer].end(), {c1, c2});
          }
        for (unsigned int layer = 0; layer + 1 < layers; ++layer)
          for (unsigned int k = 0; k < 4; ++k)
            {
              CellNodes nodes;
              std::copy_n(faces[layer][k].begin(), 4, nodes.begin());
              std::copy_n(faces[layer + 1][k].begin(), 4, nodes.begin() + 4);
              add_hexahedron(nodes);
            }
      }
    return inner;
  }

  void GearSectorCells::add_to_set(const char *name, const unsigned int node)
  {
    if (!GearSector::is_next(node))
      sector_.node_sets[name].push_back(node);
  }

  void GearSectorCells::add_to_set(const char *name, const NodeLayer &layer)
  {
    for (const auto &row : layer)
      for (const unsigned int node : row)
        add_to_set(name, node);
  }

  void GearSectorCells::add_flank(const FlankGrid &flank)
  {
    sector_.flanks.push_back(flank);
  }

  GearSector GearSectorCells::finish()
  {
    for (auto &set : sector_.node_sets)
      {
        auto &nodes = set.second;
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      }
    return std::move(sector_);
  }
} // namespace vfife
