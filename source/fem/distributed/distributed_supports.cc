// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "distributed_supports.h"

#include "boundary_set.h"

#include <set>

namespace vfife
{
  namespace
  {
    unsigned int largest_component(const Vector3 &direction)
    {
      Eigen::Index k = 0;
      direction.cwiseAbs().maxCoeff(&k);
      return static_cast<unsigned int>(k);
    }
  } // namespace

  DistributedSupports::DistributedSupports(const Model       &model,
                                           const unsigned int body,
                                           const DofLevel    &level)
    : model_(model)
    , body_(body)
    , level_(level)
    , lines_(level.make_lines())
  {
    // At the body's own nodes conflicts are found on all ranks.
    combine_constraints(model, body);
    lines_.merge(level.hanging());
    find_points();
    lines_.close();
    for (const dealii::types::global_dof_index i : level.owned())
      if (lines_.is_constrained(i))
        dependent_.push_back(i);
  }

  void DistributedSupports::find_points()
  {
    const Body                                             &body     = model_.bodies[body_];
    const DistributedMesh                                  &mesh     = level_.mesh();
    const std::vector<BoundaryFace>                         boundary = find_whole_boundary(body);
    std::vector<std::pair<const Constraint *, BoundarySet>> sets;
    for (const Constraint &constraint : model_.constraints)
      if (constraint.body == body_)
        sets.emplace_back(&constraint, BoundarySet(body, constraint.nodes, boundary));
    std::set<dealii::types::global_dof_index> seen;
    // Also points of neighbours' cells: lines of all relevant degrees of freedom are needed.
    level_.for_elements(
      [&](const DofLevel::Element &element) {
        for (std::size_t a = 0; a < element.points.size(); ++a)
          {
            const PointDofs &dofs  = element.points[a];
            const auto       nodes = mesh.nodes_around(element.place, level_.unit_points()[a]);
            if (nodes.size() == 8 || level_.hanging().is_constrained(dofs[0]))
              continue;
            const Vector3 place = value_at(dofs, level_.places());
            Point         point{dofs, place, NodeConstraints(body, place)};
            for (const auto &[constraint, set] : sets)
              if (set.contains(nodes))
                point.constraints.add(*constraint);
            if (point.constraints.constraints().empty() || !seen.insert(dofs[0]).second)
              continue;
            point.constraints.check();
            add_lines(point);
            if (level_.owned().is_element(dofs[0]))
              points_.push_back(std::move(point));
          }
      },
      true);
  }

  void DistributedSupports::add_lines(const Point &point)
  {
    const unsigned int n_held = point.constraints.n_held();
    const Matrix3      axes   = point.constraints.axes();
    if (n_held == 0)
      return;
    // The component that the others follow, or that follows them.
    const unsigned int k   = n_held == 3 ? 0 : largest_component(axes.col(n_held == 1 ? 0 : 2));
    const auto         add = [&](const unsigned int c, const unsigned int on, const double weight) {
      if (weight != 0.)
        lines_.add_entry(point.dofs[c], point.dofs[on], weight);
    };
    for (unsigned int c = 0; c < 3; ++c)
      {
        const bool follows = n_held == 3 || (n_held == 1) == (c == k);
        if (!follows)
          continue;
        lines_.add_line(point.dofs[c]);
        // n . u = 0 with u_k alone on the left side; u along the free direction t by u_k.
        if (n_held == 1)
          for (unsigned int j = 0; j < 3; ++j)
            {
              if (j != k)
                add(k, j, -axes(j, 0) / axes(k, 0));
            }
        else if (n_held == 2)
          add(c, k, axes(c, 2) / axes(k, 2));
      }
  }

  DistributedVector
  DistributedSupports::compute_prescribed(const NodeConstraints::Factor &factor) const
  {
    for (const auto &node : combine_constraints(model_, body_))
      node.second.compute_displacement(factor);
    DistributedVector u = level_.make_vector();
    for (const Point &point : points_)
      {
        const Vector3 displacement = point.constraints.compute_displacement(factor);
        for (unsigned int c = 0; c < 3; ++c)
          u(point.dofs[c]) = displacement[c];
      }
    level_.hanging().distribute(u);
    u.update_ghost_values();
    return u;
  }

  void DistributedSupports::condense(DistributedVector &forces) const
  {
    for (const Point &point : points_)
      for (const dealii::types::global_dof_index dof : point.dofs)
        if (const auto *const entries = lines_.get_constraint_entries(dof))
          for (const auto &[on, weight] : *entries)
            forces(on) += weight * forces(dof);
    clear_dependent(forces);
  }

  void DistributedSupports::clear_dependent(DistributedVector &q) const
  {
    for (const dealii::types::global_dof_index i : dependent_)
      q(i) = 0.;
  }

  std::vector<std::vector<double>>
  DistributedSupports::unknowns_of(std::vector<DistributedVector> fields) const
  {
    std::vector<std::vector<double>> unknowns;
    for (DistributedVector &field : fields)
      {
        clear_dependent(field);
        unknowns.push_back(owned_part(field));
      }
    return unknowns;
  }
} // namespace vfife
