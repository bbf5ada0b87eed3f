// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_stress_shoulder_bar_h
#define vfife_tests_stress_shoulder_bar_h

#include <vfife/fem/statics/static_solver.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>

#include <cmath>
#include <memory>
#include <vector>

/**
 * Upper half of a flat bar whose height falls from 15 to 10 mm over quarter circles of 2.5 mm, one
 * layer of cells thick: n cells along the quarter circle, 3 n along either part of the bar. Columns
 * of cells lead from the middle of the bar to its upper side, rows along it.
 */
class ShoulderBar
{
public:
  static constexpr double wide = 15., narrow = 10., radius = 2.5, thickness = .5;

  explicit ShoulderBar(const unsigned int n)
    : n_(n)
    , columns_(7 * n)
    , rows_(3 * n)
  {
    std::vector<vfife::Vector3> nodes;
    for (unsigned int layer = 0; layer < 2; ++layer)
      for (unsigned int i = 0; i <= columns_; ++i)
        for (unsigned int j = 0; j <= rows_; ++j)
          {
            const double         part = 1. - graded(1. - double(j) / rows_);
            const vfife::Vector2 p    = part * upper(i) + (1. - part) * middle(i);
            nodes.emplace_back(p[0], p[1], layer * thickness);
          }
    std::vector<vfife::CellNodes> cells;
    for (unsigned int i = 0; i < columns_; ++i)
      for (unsigned int j = 0; j < rows_; ++j)
        {
          vfife::CellNodes cell;
          for (unsigned int v = 0; v < 8; ++v)
            cell[v] = node(v / 4, i + v % 2, j + v / 2 % 2);
          cells.push_back(cell);
        }
    auto mesh  = std::make_unique<vfife::BodyMesh>();
    mesh->name = "bar";
    create_triangulation(*mesh, nodes, cells);
    model_.add_body(vfife::Body("bar", std::move(mesh), vfife::Material()));
  }

  /** The bar under a nominal stress of 1 MPa at the narrow part's surface, in tension or bending;
   * planes of symmetry held. */
  vfife::Model &load(const bool bending, std::vector<vfife::Vector3> &forces)
  {
    using namespace vfife;
    model_.constraints.clear();
    std::vector<unsigned int> symmetry, end, front;
    for (unsigned int layer = 0; layer < 2; ++layer)
      {
        for (unsigned int i = 0; i <= columns_; ++i)
          symmetry.push_back(node(layer, i, 0));
        for (unsigned int j = 0; j <= rows_; ++j)
          end.push_back(node(layer, 0, j));
      }
    for (unsigned int k = 0; k < node(1, 0, 0); ++k)
      front.push_back(k);
    hold("middle", symmetry, {{bending, !bending, false}});
    hold("end", end, {{true, bending, false}});
    hold("front", front, {{false, false, true}});
    // Work-equivalent forces of a linear traction over cells of the end.
    const std::vector<Vector3> &x = model_.bodies[0].node_positions();
    const auto traction = [bending](const double y) { return bending ? 2. * y / narrow : 1.; };
    forces.assign(x.size(), Vector3::Zero());
    for (unsigned int j = 0; j < rows_; ++j)
      for (unsigned int layer = 0; layer < 2; ++layer)
        {
          const unsigned int low = node(layer, columns_, j), high = low + 1;
          const double       y0 = x[low][1], y1 = x[high][1];
          const double       area = .5 * thickness * (y1 - y0);
          forces[low][0] += area * (traction(y0) / 3. + traction(y1) / 6.);
          forces[high][0] += area * (traction(y0) / 6. + traction(y1) / 3.);
        }
    return model_;
  }

  /** Corners of the facets along the quarter circle. */
  std::vector<std::array<unsigned int, 4>> fillet_facets() const
  {
    std::vector<std::array<unsigned int, 4>> facets;
    for (unsigned int i = 3 * n_; i < 4 * n_; ++i)
      facets.push_back(
        {{node(0, i, rows_), node(1, i, rows_), node(1, i + 1, rows_), node(0, i + 1, rows_)}});
    return facets;
  }

private:
  unsigned int node(const unsigned int layer, const unsigned int i, const unsigned int j) const
  {
    return (layer * (columns_ + 1) + i) * (rows_ + 1) + j;
  }

  void
  hold(const char *name, std::vector<unsigned int> nodes, const std::array<bool, 3> &directions)
  {
    std::sort(nodes.begin(), nodes.end());
    vfife::Constraint constraint;
    constraint.name       = name;
    constraint.kind       = vfife::ConstraintKind::directions;
    constraint.nodes      = nodes;
    constraint.prescribed = directions;
    model_.constraints.push_back(constraint);
  }

  /** Places in [0, 1] that are denser towards 0. */
  static double graded(const double x)
  {
    return .15 * x + .85 * x * x;
  }

  vfife::Vector2 upper(const unsigned int i) const
  {
    if (i < 3 * n_)
      return {-20. * graded(1. - i / (3. * n_)), .5 * wide};
    if (i > 4 * n_)
      return {radius + 25. * graded((i - 4. * n_) / (3. * n_)), .5 * narrow};
    const double angle = .5 * vfife::pi * (i - 3. * n_) / n_;
    return {radius - radius * std::cos(angle), .5 * wide - radius * std::sin(angle)};
  }

  vfife::Vector2 middle(const unsigned int i) const
  {
    if (i < 3 * n_)
      return {-20. + 18. * (1. - graded(1. - i / (3. * n_))), 0.};
    if (i > 4 * n_)
      return {4.5 + 23. * graded((i - 4. * n_) / (3. * n_)), 0.};
    return {-2. + 6.5 * (i - 3. * n_) / n_, 0.};
  }

  unsigned int n_, columns_, rows_;
  vfife::Model model_;
};

#endif
