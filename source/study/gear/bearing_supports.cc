// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/bearing/shaft_seat.h>
#include <vfife/model/constraints/supports.h>
#include <vfife/model/load_shares.h>
#include <vfife/output/measures/body_ring.h>
#include <vfife/study/gear/bearing_supports.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace vfife
{
  namespace
  {
    using Matrix6x5 = Eigen::Matrix<double, 6, 5>;

    /** A member as a rigid body: where it is and what it weighs, along axes x, y, z with z along
     * its axis. */
    struct RigidMember
    {
      Vector3 centre = Vector3::Zero(); ///< of mass, fixed frame
      Matrix3 axes;
      Vector5 masses; ///< of ways along x, y, z [t], of tilts about x, y [t mm^2]

      explicit RigidMember(const Body &body)
        : axes(axes_along(body.axis.direction))
      {
        double sum = 0;
        for (unsigned int i = 0; i < body.n_nodes(); ++i)
          {
            sum += body.node_masses()[i];
            centre += body.node_masses()[i] * body.placement(body.node_positions()[i]);
          }
        centre /= sum;
        masses << sum, sum, sum, 0., 0.;
        for (unsigned int i = 0; i < body.n_nodes(); ++i)
          {
            const Vector3 r =
              axes.transpose() * (body.placement(body.node_positions()[i]) - centre);
            masses[3] += body.node_masses()[i] * (r[1] * r[1] + r[2] * r[2]);
            masses[4] += body.node_masses()[i] * (r[0] * r[0] + r[2] * r[2]);
          }
      }

      /** Displacement and turn at a place, fixed frame, of the five motions. */
      Matrix6x5 motion_at(const Vector3 &place) const
      {
        Matrix6x5 motion = Matrix6x5::Zero();
        for (unsigned int c = 0; c < 3; ++c)
          motion.col(c).head<3>() = axes.col(c);
        for (unsigned int c = 0; c < 2; ++c)
          {
            motion.col(3 + c).head<3>() = axes.col(c).cross(place - centre);
            motion.col(3 + c).tail<3>() = axes.col(c);
          }
        return motion;
      }
    };
  } // namespace

  std::vector<LumpedSupport> find_bearing_supports(const Model &model)
  {
    const Transmission         &t   = *model.only_transmission();
    const BearingSystem::Linear law = make_bearing_system(model).linearized();
    std::vector<LumpedSupport>  supports;
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body &body = model.bodies[b];
        if (!body.floats)
          continue;
        // 1. K and C over the five motions, in units in which the masses are one.
        const RigidMember member(body);
        const Vector5     scale = member.masses.cwiseSqrt().cwiseInverse();
        Matrix5           C     = Matrix5::Zero();
        // Of all seats of a model; those of the other member are held.
        Eigen::MatrixXd ways = Eigen::MatrixXd::Zero(6 * model.bearings.size(), 5);
        for (std::size_t s = 0; s < model.bearings.size(); ++s)
          if (model.bearings[s].body == b)
            {
              const Bearing  &bearing = model.bearings[s];
              const ShaftSeat seat(bearing.axes);
              const BodyRing  ring(body,
                                  bearing.nodes,
                                  compute_area_shares(body, bearing.nodes, bearing.faces),
                                  "bearing \"" + bearing.name + "\"");
              const Matrix6x5 D         = member.motion_at(ring.centre()) * scale.asDiagonal();
              ways.middleRows<6>(6 * s) = D;
              C += D.transpose() * seat.in_space(bearing.law->damping(), 0.) * D;
            }
        const Matrix5                                K = ways.transpose() * law.stiffness * ways;
        const Eigen::SelfAdjointEigenSolver<Matrix5> modes(K);
        if (!(modes.eigenvalues().minCoeff() > 1e-9 * modes.eigenvalues().maxCoeff()))
          throw InputError(
            "Lumped/bearings",
            "the bearings of the " + body.name() +
              " do not support it without load. Give rolling bearings a working load");
        // 2. Each mode moves the contact point by d: compression of the mesh over the arm.
        const Matrix6x5 at_contact = member.motion_at(t.contact_point) * scale.asDiagonal();
        for (unsigned int k = 0; k < 5; ++k)
          {
            const Vector5 shape = modes.eigenvectors().col(k);
            const Vector3 d     = (at_contact * shape).head<3>();
            const double  rate  = std::sqrt(modes.eigenvalues()[k]);
            LumpedSupport support;
            support.name          = body.name() + " in bearings " + std::to_string(k + 1);
            support.lever         = (b == t.driven ? 1. : -1.) * t.contact_normal.dot(d) / t.arm;
            support.inertia       = 1.;
            support.stiffness     = rate * rate;
            support.damping_ratio = shape.dot(C * shape) / (2 * rate);
            supports.push_back(support);
          }
      }
    return supports;
  }
} // namespace vfife
