// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/motion/damping_reference.h>
#include <vfife/model/state.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>

namespace vfife
{
  DampingReference::DampingReference(const Model &model, const unsigned int body)
    : body_(&model.bodies[body])
    , freedom_(model, body)
    , axis_(UpdateAxis::of(*body_))
    , b_(body)
  {
    axis_.use_axis = axis_.use_axis && freedom_.is_held_across();
  }

  bool DampingReference::turns() const
  {
    const auto &prescribed = freedom_.prescribed();
    return freedom_.turn_is_free() ||
           std::any_of(prescribed.begin(), prescribed.end(), [](const PrescribedMotion &one) {
             return one.constraint->kind == ConstraintKind::prescribed_rotation;
           });
  }

  void DampingReference::take_place(const State               &state,
                                    const std::vector<double> &masses,
                                    const Communicator        &communicator)
  {
    if (axis_.use_axis || freedom_.opposed().empty())
      return;
    // The rotation R nearest to the nodes' places, least sum m |x - x_0 - R (X - X_0)|^2: the polar
    // factor of sum m x (X - X_0)^T.
    std::vector<double> sums(15, 0.);
    for (const std::uint32_t i : state.partition->owned_nodes(b_))
      {
        const Vector3 &X =
          body_->node_positions()[state.partition->global_node[i] - body_->first_node];
        const Vector3 x = state.node_position(i) - body_->axis.point;
        Eigen::Map<Vector3>(sums.data()) += masses[i] * x;
        Eigen::Map<Vector3>(sums.data() + 3) += masses[i] * X;
        Eigen::Map<Matrix3>(sums.data() + 6) += masses[i] * x * X.transpose();
      }
    communicator.sum(sums);
    const Vector3 x0 = Eigen::Map<const Vector3>(sums.data()) / body_->mass(),
                  X0 = Eigen::Map<const Vector3>(sums.data() + 3) / body_->mass();
    const Matrix3 second =
      Eigen::Map<const Matrix3>(sums.data() + 6) - body_->mass() * x0 * X0.transpose();
    const Eigen::JacobiSVD<Matrix3> svd(second, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Matrix3                   rotation = svd.matrixU() * svd.matrixV().transpose();
    const RigidMotion              &now      = state.body_motion[b_];
    offset_.rotation                         = now.rotation.transpose() * rotation;
    offset_.translation =
      now.rotation.transpose() * (body_->axis.point + x0 - rotation * X0 - now.translation);
  }

  void DampingReference::serialize(ByteStream &stream)
  {
    stream.pass(offset_);
  }

  double DampingReference::rate_of(const PrescribedMotion &prescribed,
                                   const double            time,
                                   const double            dt) const
  {
    const Constraint &constraint = *prescribed.constraint;
    if (constraint.kind == ConstraintKind::prescribed_rotation && !constraint.angle)
      return body_->rate_history.value(time);
    // The mean of the chords before and after; a history begins at time zero.
    const double first = std::max(0., time - dt);
    return (constraint.history.value(time + dt) - constraint.history.value(first)) /
           (time + dt - first);
  }

  Vector6 DampingReference::find_prescribed(const double time, const double dt) const
  {
    Vector6 motion = Vector6::Zero();
    for (const PrescribedMotion &one : freedom_.prescribed())
      motion += rate_of(one, time, dt) * one.motion;
    return motion;
  }

  RigidVelocity DampingReference::find(const double         time,
                                       const double         dt,
                                       const RigidMotion   &now,
                                       const RigidVelocity &own) const
  {
    // 1. What a body on its axis does beside its turn is opposed.
    const Vector3 &axis = body_->axis.direction;
    if (freedom_.opposed().empty() || (axis_.use_axis && freedom_.turn_is_free()))
      return own;
    RigidVelocity result;
    const Vector6 prescribed = find_prescribed(time, dt);
    if (axis_.use_axis)
      {
        result.omega    = axis.dot(prescribed.tail<3>()) * axis;
        result.velocity = -result.omega.cross(body_->axis.point);
        return result;
      }

    // 2. Equations W t = g for t = (velocity of the centre, omega), at the present place.
    RigidMotion moved;
    moved.rotation       = now.rotation * offset_.rotation * body_->placement.rotation.transpose();
    moved.translation    = now(offset_.translation) - moved.rotation * body_->placement.translation;
    const Vector3 centre = moved(freedom_.centre());
    const Vector6 led    = [&] {
      Vector6 t = prescribed;
      t.head<3>() += Vector3(prescribed.tail<3>()).cross(centre - freedom_.centre());
      return t;
    }();
    Vector6 t;
    t << own.at(centre), own.omega;
    using Rows           = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor, 6, 6>;
    using Square         = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
    using Column         = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
    const Eigen::Index n = freedom_.opposed().size();
    Rows               W(n, 6);
    Column             g = Column::Zero(n);
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const OpposedMotion &motion = freedom_.opposed()[k];
        W.row(k)                    = freedom_.coefficients(motion, moved, centre).transpose();
        if (motion.held.constraint != nullptr)
          g[k] = W.row(k).dot(led);
        else if (motion.coupling != nullptr)
          g[k] = body_->rate * body_->rate_history.value(time);
      }

    // 3. Of all t that meet them the one whose difference from the body's own has the least kinetic
    // energy: t = own - M^-1 W^T (W M^-1 W^T)^-1 (W own - g).
    Eigen::Matrix<double, 6, 6> inverse = Eigen::Matrix<double, 6, 6>::Zero();
    inverse.topLeftCorner<3, 3>()       = Matrix3::Identity() / body_->mass();
    inverse.bottomRightCorner<3, 3>() =
      moved.rotation * freedom_.inertia().inverse() * moved.rotation.transpose();
    const Square compliance = W * inverse * W.transpose();
    const Column beyond     = W * t - g;
    t -=
      inverse * W.transpose() * Square(compliance).completeOrthogonalDecomposition().solve(beyond);
    result.omega    = t.tail<3>();
    result.velocity = t.head<3>() - result.omega.cross(centre);
    return result;
  }
} // namespace vfife
