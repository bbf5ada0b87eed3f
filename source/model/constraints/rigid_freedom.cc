// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/bearing/bearing_law.h>
#include <vfife/model/constraints/node_constraints.h>
#include <vfife/model/constraints/rigid_freedom.h>
#include <vfife/model/load_shares.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>

namespace vfife
{
  namespace
  {
    /** Stiffness of a bearing below this part of its largest is none. */
    constexpr double least_stiffness = 1e-9;

    /** In units of one length, so that velocities and turns of a body are alike. */
    Vector6 scaled(Vector6 w, const double length)
    {
      w.tail<3>() /= length;
      return w;
    }

    /** The motions that a bearing resists, of its seat at @p place. */
    void add_bearing(const Bearing              &bearing,
                     const Vector3              &place,
                     const double                length,
                     std::vector<OpposedMotion> &all)
    {
      Vector5 scale;
      scale << 1., 1., 1., length, length;
      // Within a clearance there is no stiffness; the bearing opposes what it opposes beyond it.
      Matrix5 K = bearing.law->linearized().stiffness;
      if (K.isZero(0.))
        K = bearing.law->stiffness_bound();
      const Matrix5 pure =
        scale.cwiseInverse().asDiagonal() * K * scale.cwiseInverse().asDiagonal();
      const Eigen::SelfAdjointEigenSolver<Matrix5> parts(.5 * (pure + pure.transpose()));
      const double largest = parts.eigenvalues().cwiseAbs().maxCoeff();
      for (unsigned int k = 0; k < 5; ++k)
        if (std::abs(parts.eigenvalues()[k]) > least_stiffness * largest)
          {
            const Vector5 part = parts.eigenvectors().col(k).cwiseProduct(scale);
            OpposedMotion motion;
            motion.held.direction = bearing.axes * part.head<3>();
            motion.tilt           = bearing.axes.leftCols<2>() * part.tail<2>();
            motion.place          = place;
            all.push_back(motion);
          }
    }
  } // namespace

  RigidFreedom::RigidFreedom(const Model &model, const unsigned int body)
    : model_(&model)
    , b_(body)
  {
    const Body &of = model.bodies[b_];
    for (unsigned int i = 0; i < of.n_nodes(); ++i)
      centre_ += of.node_masses()[i] / of.mass() * of.placement(of.node_positions()[i]);
    for (unsigned int i = 0; i < of.n_nodes(); ++i)
      {
        const Vector3 r = of.placement(of.node_positions()[i]) - centre_;
        inertia_ +=
          of.node_masses()[i] * (r.squaredNorm() * Matrix3::Identity() - r * r.transpose());
      }
    length_ = std::sqrt(.5 * inertia_.trace() / of.mass());

    std::vector<OpposedMotion> all = list_constraints();
    find_prescribed(all);
    add_springs(all);
    add_seats(all);
    find_independent(all);
  }

  std::vector<OpposedMotion> RigidFreedom::list_constraints() const
  {
    std::vector<OpposedMotion> all;
    const Body                &body = model_->bodies[b_];
    for (const auto &[node, constraints] : combine_constraints(*model_, b_))
      {
        const ConstraintKind kind  = constraints.leading().kind;
        const bool           stays = kind == ConstraintKind::held ||
                           (kind == ConstraintKind::directions && constraints.n_held() == 3);
        for (const HeldDirection &held : constraints.held())
          {
            OpposedMotion motion;
            motion.held  = held;
            motion.place = body.placement(body.node_positions()[node]);
            motion.stays = stays;
            all.push_back(motion);
          }
      }
    return all;
  }

  void RigidFreedom::add_springs(std::vector<OpposedMotion> &all) const
  {
    const Body &body = model_->bodies[b_];
    for (const Load &load : model_->loads)
      {
        if (load.kind != LoadKind::spring || load.body != b_)
          continue;
        const std::vector<double> shares = compute_load_shares(load, body);
        for (std::size_t i = 0; i < shares.size(); ++i)
          for (unsigned int c = 0; c < 3; ++c)
            if (shares[i] * load.vector[c] > 0)
              {
                OpposedMotion motion;
                motion.held.direction = Vector3::Unit(c);
                motion.place          = body.placement(body.node_positions()[load.nodes[i]]);
                all.push_back(motion);
              }
      }
  }

  void RigidFreedom::add_seats(std::vector<OpposedMotion> &all) const
  {
    const Body &body = model_->bodies[b_];
    for (const Bearing &bearing : model_->bearings)
      {
        if (bearing.body != b_)
          continue;
        const std::vector<double>  shares = compute_area_shares(body, bearing.nodes);
        const std::vector<Vector3> places = find_undeformed_places(body, bearing.nodes);
        Vector3                    centre = Vector3::Zero();
        for (std::size_t i = 0; i < shares.size(); ++i)
          centre += shares[i] * places[i];
        add_bearing(bearing, centre, length_, all);
      }
    for (const Coupling &coupling : model_->couplings)
      if (coupling.body == b_)
        {
          OpposedMotion motion;
          motion.coupling = &coupling;
          motion.place    = centre_;
          all.push_back(motion);
        }
  }

  Vector6 RigidFreedom::coefficients(const OpposedMotion &motion,
                                     const RigidMotion   &moved,
                                     const Vector3       &point) const
  {
    const Axis   &axis = model_->bodies[b_].axis;
    const Vector3 x    = motion.stays ? motion.place : moved(motion.place);
    const Vector3 n    = present_direction(motion.held, axis, x);
    // The bearing's z lies along the axis of its body.
    const Vector3 &z     = axis.direction;
    const Vector3  now_z = moved.rotation * z;
    Vector6        w;
    w << n, (x - point).cross(n) + now_z.cross(motion.tilt.cross(z));
    if (motion.coupling != nullptr)
      w.tail<3>() += (z + now_z) / (1. + z.dot(now_z));
    return w;
  }

  void RigidFreedom::find_independent(const std::vector<OpposedMotion> &all)
  {
    // Gram-Schmidt, the row that is farthest from those before it first: where a support is wide
    // and where it is narrow, the widest arms count.
    std::vector<Vector6> rest;
    for (const OpposedMotion &motion : all)
      rest.push_back(scaled(coefficients(motion, RigidMotion(), centre_), length_).normalized());
    const Axis   &axis = model_->bodies[b_].axis;
    const Vector3 arm  = axis.direction.cross(centre_ - axis.point);
    Vector6       turn;
    turn << arm, length_ * axis.direction;
    turn.normalize();
    turn_is_free_ = std::all_of(rest.begin(), rest.end(), [&turn](const Vector6 &w) {
      return std::abs(w.dot(turn)) < parallel_angle;
    });
    while (opposed_.size() < 6 && !rest.empty())
      {
        std::size_t farthest = 0;
        // The first of several that are equally far, whatever round-off says.
        for (std::size_t i = 1; i < rest.size(); ++i)
          if (rest[i].norm() > rest[farthest].norm() + 1e-9)
            farthest = i;
        if (!(rest[farthest].norm() > parallel_angle))
          break;
        opposed_.push_back(all[farthest]);
        const Vector6 axis_of_it = rest[farthest].normalized();
        for (Vector6 &w : rest)
          w -= axis_of_it.dot(w) * axis_of_it;
      }
  }

  void RigidFreedom::find_prescribed(const std::vector<OpposedMotion> &of_constraints)
  {
    // The rigid motion nearest to what the constraints prescribe: least squares of all their
    // equations, constraint by constraint, as each has a history of its own.
    Eigen::Matrix<double, 6, 6>           gram = Eigen::Matrix<double, 6, 6>::Zero();
    std::map<const Constraint *, Vector6> right;
    for (const OpposedMotion &motion : of_constraints)
      {
        const Vector6 w = scaled(coefficients(motion, RigidMotion(), centre_), length_);
        gram += w * w.transpose();
        if (const double value = motion.held.value + motion.held.rate; value != 0)
          right.emplace(motion.held.constraint, Vector6::Zero()).first->second += value * w;
      }
    if (right.empty())
      return;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> parts(gram);
    const double  least = parallel_angle * parallel_angle * parts.eigenvalues()[5];
    const Vector6 inverse =
      (parts.eigenvalues().array() > least).select(parts.eigenvalues().cwiseInverse(), 0.);
    for (const Constraint &constraint : model_->constraints) // in their order
      if (const auto found = right.find(&constraint); found != right.end())
        {
          Vector6 motion = parts.eigenvectors() * inverse.asDiagonal() *
                           parts.eigenvectors().transpose() * found->second;
          motion.tail<3>() /= length_;
          prescribed_.push_back({&constraint, motion});
        }
  }
} // namespace vfife
