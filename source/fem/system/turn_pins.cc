// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/system_matrices.h>
#include <vfife/fem/system/turn_pins.h>

#include <algorithm>
#include <set>

namespace vfife
{
  bool has_turning_hub(const Model &model, const unsigned int body)
  {
    return std::any_of(model.constraints.begin(),
                       model.constraints.end(),
                       [body](const Constraint &constraint) {
                         return constraint.body == body &&
                                (constraint.kind == ConstraintKind::free_rotation ||
                                 constraint.kind == ConstraintKind::rigid_hub);
                       });
  }

  bool is_turn(const FemSpace &space, const FemSpace::Part &part, const std::vector<double> &motion)
  {
    // What is left of it without its part along the turn a x (X - c).
    const Axis &axis  = space.model().bodies[part.body].axis;
    double      whole = 0, along = 0, turn = 0;
    for (unsigned int p = part.first_point; p < part.first_point + part.n_points; ++p)
      {
        const Eigen::Map<const Vector3> u(motion.data() + 3 * std::size_t(p));
        const Vector3                   way = axis.direction.cross(space.points()[p] - axis.point);
        whole += u.squaredNorm();
        along += u.dot(way);
        turn += way.squaredNorm();
      }
    return whole - along * along / turn < 1e-8 * whole;
  }

  FemMatrix
  add_turn_pins(const FemSystem &system, const std::vector<unsigned int> &bodies, FemMatrix K)
  {
    if (bodies.empty())
      return K;
    const FemSpace        &d         = system.space();
    const double           stiffness = system.mean_diagonal(K);
    std::set<unsigned int> done;
    // The points of a ring are coupled anyway.
    const std::vector<BearingRing> &rings = system.rings().list();
    Eigen::MatrixXd pins = Eigen::MatrixXd::Zero(6 * rings.size(), 6 * rings.size());
    for (std::size_t r = 0; r < rings.size(); ++r)
      {
        const BearingRing &ring = rings[r];
        if (std::find(bodies.begin(), bodies.end(), ring.body) == bodies.end() ||
            !done.insert(ring.body).second)
          continue;
        const Axis &axis   = d.model().bodies[ring.body].axis;
        double      square = 0;
        for (const unsigned int p : ring.points)
          square +=
            axis.direction.cross(d.points()[p] - axis.point).squaredNorm() / ring.points.size();
        pins.block<3, 3>(6 * r + 3, 6 * r + 3) =
          stiffness * square * axis.direction * axis.direction.transpose();
      }
    return add_scaled(std::move(K), 1., system.ring_matrix(pins));
  }
} // namespace vfife
