// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/system_matrices.h>
#include <vfife/fem/system/turn_pins.h>

#include <algorithm>
#include <cmath>
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

  Eigen::MatrixXd make_turn_pins(const FemSpace                  &space,
                                 const BearingRings              &rings,
                                 const std::vector<unsigned int> &bodies)
  {
    const std::size_t      n    = 6 * rings.list().size();
    Eigen::MatrixXd        pins = Eigen::MatrixXd::Zero(n, n);
    std::set<unsigned int> done;
    for (std::size_t r = 0; r < rings.list().size(); ++r)
      {
        const BearingRing &ring = rings.list()[r];
        if (std::find(bodies.begin(), bodies.end(), ring.body) == bodies.end() ||
            !done.insert(ring.body).second)
          continue;
        const Axis &axis   = space.model().bodies[ring.body].axis;
        double      square = 0; // of the radius, the mean
        // A sector's ring counts points of both copies.
        for (const unsigned int p : ring.points)
          square +=
            axis.direction.cross(space.points()[p % space.n_points()] - axis.point).squaredNorm() /
            ring.points.size();
        const Material &material = space.material(space.find_part(ring.body)->first_element);
        pins.block<3, 3>(6 * r + 3, 6 * r + 3) =
          material.mu() * std::pow(square, 1.5) * axis.direction * axis.direction.transpose();
      }
    return pins;
  }

  FemMatrix
  add_turn_pins(const FemSystem &system, const std::vector<unsigned int> &bodies, FemMatrix K)
  {
    if (bodies.empty())
      return K;
    // The points of a ring are coupled anyway.
    return add_scaled(std::move(K),
                      1.,
                      system.ring_matrix(make_turn_pins(system.space(), system.rings(), bodies)));
  }
} // namespace vfife
