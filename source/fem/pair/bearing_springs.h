// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_bearing_springs_h
#define vfife_fem_pair_bearing_springs_h

#include <vfife/bearing/bearing_system.h>
#include <vfife/fem/system/bearing_rings.h>

#include <vector>

namespace vfife
{
  /**
   * What the bearings of a pair's bodies do beyond the linear springs K0 that a compliance has for
   * them (doc/fem.md, On bearings): springs on the motion d = B u of their rings in axes that turn
   * with the body, with the energy
   *
   *   E(q) - (d - d0) . K0 (d - d0)/2 + w0 . d,     q = P R d
   *
   * of the law's E at the displacements q in the bearing's axes. R is the rotation of the body
   * since time zero, whose part psi about the axis is an unknown for the driven body. d0 is a state
   * whose forces w0 somebody else has; without one both are zero.
   *
   * Turns are counted as ways at an arm and moments as forces there: all entries in mm and N.
   */
  class BearingSprings
  {
  public:
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    using Matrix6 = Eigen::Matrix<double, 6, 6>;

    /** @p rings: those of the compliance; @p arm [mm]. */
    BearingSprings(const Model &model, const BearingRings &rings, double arm);

    /** Of each ring, for the compliance to watch. */
    std::vector<PointMotion> motions() const;

    std::size_t size() const
    {
      return springs_.size();
    }

    /** Of all springs, six rows each in their order. */
    struct Response
    {
      Eigen::VectorXd force;      ///< minus the slope of the energy with d [N]
      Eigen::MatrixXd stiffness;  ///< its second derivative [N/mm]; a housing couples the springs
      double          energy = 0; ///< [mJ]
      double          torque = 0; ///< minus the slope with psi [N mm]
      Eigen::VectorXd by_turn;    ///< second derivative with d and psi [N]
      double          turn_twice = 0; ///< second derivative with psi [N mm]
      std::vector<SeatState> states;  ///< of the bearings themselves
    };

    /** At the motions @p d of the rings, six rows each, when the bodies have turned by @p
     * rotations. Cages that roll stand where the kinematic @p turns of the bodies about their axes
     * [rad] have taken them: what psi is more moves none. */
    Response evaluate(const Eigen::VectorXd      &d,
                      const std::vector<Matrix3> &rotations,
                      const std::vector<double>  &turns) const;

    /** The tangent of the bearings' whole law in the state of @p response, over displacements and
     * turns of their rings [N/mm, N, N mm]. */
    Eigen::MatrixXd tangent(const Response &response) const;

    /** Takes the state at the motions @p d as known, its forces being in what else acts; returns
     * the torque that the bearings have there on the driven body about its axis [N mm]. */
    double set_known(const Eigen::VectorXd      &d,
                     const std::vector<Matrix3> &rotations,
                     const std::vector<double>  &turns);

  private:
    struct Spring
    {
      unsigned int body;
      PointMotion  motion; ///< turns as ways at the arm
      Vector3      axis;   ///< of the body
      bool         is_driven;
      Vector3      eccentricity;           ///< of the undeformed ring's centre from the axis [mm]
      Matrix6      linear;                 ///< K0
      Eigen::Matrix<double, 5, 6> reading; ///< P
      // What is known:
      Vector6 motion_known = Vector6::Zero(), force_known = Vector6::Zero();
    };

    std::vector<Spring> springs_; ///< in the order of Model::bearings
    BearingSystem       system_;
    double              arm_;
  };
} // namespace vfife

#endif
