// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_bearing_springs_h
#define vfife_fem_pair_bearing_springs_h

#include <vfife/bearing/bearing_system.h>
#include <vfife/bearing/shaft_seat.h>
#include <vfife/fem/pair/pressed_bodies.h>

#include <vector>

namespace vfife
{
  struct Model;

  /**
   * What the bearings of a pair's bodies do beyond the linear springs K0 that the bodies' answers
   * have for them (doc/theory/fem.md, Pair in bearings): springs on the motion d = B u of their
   * rings in axes that turn with the body, with the energy
   *
   *   E(q) - (d - d0) . K0 (d - d0)/2 + w0 . d,     q = P R d
   *
   * of the law's E at the displacements q in the bearing's axes. R is the rotation of the body
   * since time zero, whose part psi about the axis is an unknown for the driven body. d0 is a state
   * whose forces w0 somebody else has; without one both are zero.
   *
   * Turns are counted as ways at an arm and moments as forces there: all entries in mm and N.
   *
   * In a step of motion dampers add -C (q - q_0)/h, q_0 at the step's begin and h its length: the
   * mean force of the step, which loses what it does (doc/theory/reduced.md, On bearings).
   */
  class BearingSprings
  {
  public:
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    using Matrix6 = Eigen::Matrix<double, 6, 6>;

    /** In the order of Model::bearings: undeformed @p centres of the rings, fixed frame [mm], and
     * K0 over displacements and turns of all rings, six rows each [N/mm, N, N mm]; @p arm [mm]. */
    BearingSprings(const Model                &model,
                   const std::vector<Vector3> &centres,
                   const Eigen::MatrixXd      &linear,
                   double                      arm);

    double arm() const
    {
      return arm_;
    }

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
      /** The same for a turn of each body about its axis, by body [N mm]. */
      std::vector<double> torques;
      /** Slope of the energy with the turns that take the cages along, by body [N mm]. */
      std::vector<double>    cage_slopes;
      Eigen::VectorXd        by_turn;        ///< second derivative with d and psi [N]
      double                 turn_twice = 0; ///< second derivative with psi [N mm]
      std::vector<SeatState> states;         ///< of the bearings themselves

      /** Adds forces, energy and torque; the springs' rows begin with @p row. */
      void add_to(PressedForces &sum, Eigen::Index row) const;
      /** Adds the springs, whose rows are the first; @p turning: with the turn, otherwise it is
       * given. */
      void add_to(PressedSprings &springs, bool turning) const;
    };

    /** At the motions @p d of the rings, six rows each, when the bodies have turned by @p
     * rotations. Cages that roll stand where the kinematic @p turns of the bodies about their axes
     * [rad] have taken them: what psi is more moves none. */
    Response evaluate(const Eigen::VectorXd      &d,
                      const std::vector<Matrix3> &rotations,
                      const std::vector<double>  &turns) const;

    /** From now on dampers act in steps of the length @p step [s] from the bearings' displacements
     * as evaluated in @p from; 0: they do not. Their forces are counted twice, as forces at the end
     * of a step whose mean force has one half of them. */
    void set_dampers(const Response &from, double step);
    /** Whether any bearing has a damper. */
    bool has_dampers() const;

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
      unsigned int                body;
      Vector3                     axis;         ///< of the body
      Vector3                     eccentricity; ///< of the ring's centre from the axis [mm]
      Eigen::Matrix<double, 5, 6> reading;      ///< P
      Matrix5                     damping;      ///< C
    };

    /** Adds what dampers do in the step to loads and stiffness over all displacements. */
    void add_dampers(const std::vector<Vector5> &displacements,
                     Eigen::VectorXd            &loads,
                     Eigen::MatrixXd            &stiffness,
                     Response                   &r) const;

    std::vector<Spring>  springs_; ///< in the order of Model::bearings
    BearingSystem        system_;
    double               arm_;
    unsigned int         n_bodies_, driven_;
    Eigen::MatrixXd      linear_;                       ///< K0
    Eigen::VectorXd      motions_known_, forces_known_; ///< d0, w0
    std::vector<Vector5> before_;                       ///< q_0
    double               step_ = 0;
  };
} // namespace vfife

#endif
