// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pair_equilibrium_h
#define vfife_fem_pair_pair_equilibrium_h

#include <vfife/bearing/shaft_seat.h>
#include <vfife/fem/pair/pressed_pair.h>
#include <vfife/fem/statics/compliance.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class PairBodies;

  /** A contact point under pressure, for small motions u of points of the space: the
   * energy stiffness/2 (sum of direction . u)^2. */
  struct ContactTie
  {
    std::vector<std::pair<unsigned int, Vector3>> points; ///< and directions, axes of time zero
    double                                        stiffness = 0; ///< [N/mm]
  };

  /** A loaded gear pair at rest in its turning axes. */
  struct PairEquilibriumResult
  {
    double driver_turn = 0; ///< of the driver since time zero, in the drive direction [rad]
    double touch_turn  = 0; ///< beyond its kinematic turn, where the unloaded flanks touch [rad]
    double turn        = 0; ///< of the driven body beyond its kinematic turn, about its axis [rad]
    /** Of all points (3 a point) on top of the turns, axes of time zero [mm]. */
    std::vector<double> displacements;
    /** The same at the first touch, without contact and torque: spin and preloads of bearings. */
    std::vector<double> touch_displacements;

    double turn_slope = 0; ///< change of turn per unit of the load factor [rad]
    std::vector<double>
      displacement_slope; ///< change of displacements per unit of the load factor [mm]

    std::vector<SeatState>    bearings; ///< in the order of Model::bearings
    std::vector<ToothContact> teeth;
    std::vector<NodalForce>   contact_forces; ///< on all nodes that may touch, a node once
    std::vector<ContactTie>   ties;           ///< the linearized contact
    /** The linearized bearings over the displacements and turns of their rings, axes of time zero,
     * six rows each [N/mm, N, N mm]. */
    Eigen::MatrixXd bearing_tangent;
    double          contact_torque = 0; ///< on the driven body, resists the load [N mm]
    unsigned int    iterations     = 0;
    double          residual       = 0; ///< unbalanced over contact forces
  };

  /**
   * Static equilibrium of a gear pair whose driver stands at a given angle and whose driven body
   * carries the model's torques: the elastic bodies are reduced to the compliance of the nodes that
   * may touch and of the rings in bearings, the penalty contact of the explicit solver acts on the
   * moved flanks, bearings have their whole law, and the rotation of the driven body is the last
   * unknown (doc/theory/fem.md). Newton's method on the springs of the contact points and of the
   * bearings with a line search on the potential energy; every position is found from the
   * undeformed bodies. Only the first contact pair is looked at for the first touch.
   */
  class PairEquilibrium
  {
  public:
    /**
     * @p driver_turns: all turns that will be asked for. Throws InputError where the model is no
     * gear pair, and where its driven body cannot turn.
     */
    PairEquilibrium(const Model               &model,
                    Compliance                &compliance,
                    const std::vector<double> &driver_turns);
    ~PairEquilibrium();

    /** Under the torques times @p load_factor. Throws NumericalError, naming the position and the
     * history of residuals. */
    PairEquilibriumResult solve(double driver_turn, double load_factor);

    /**
     * Where the pair comes to rest when its bodies would have the displacements @p free (3 a point)
     * if they did not touch and bearings were linear; the forces that bearings have at the
     * displacements @p known are in @p free and in @p torque, which acts on the driven body [N mm].
     * Starts from the last equilibrium found by this function. Of the result, turns, displacements,
     * iterations and residual are set. Throws NumericalError as solve().
     */
    PairEquilibriumResult press(double                     driver_turn,
                                const std::vector<double> &known,
                                const std::vector<double> &free,
                                double                     torque);

    /** Placement of a body at the last position: at @p x in the axes of time zero, turned. */
    Vector3 place(unsigned int body, const Vector3 &x) const
    {
      return pair_.place(body, x);
    }

    /** How a body has turned there since time zero. */
    const Matrix3 &rotation(unsigned int body) const
    {
      return pair_.rotations()[body];
    }

    /** Groups of the first contact pair (slave's, master's) that may touch at the last position. */
    const std::vector<std::pair<unsigned int, unsigned int>> &candidate_teeth() const
    {
      return pair_.candidate_teeth();
    }
    /** Of the first contact pair: deepest penetration that is taken for contact [mm]. */
    double depth_limit() const
    {
      return pair_.depth_limit();
    }

  private:
    double       load(double load_factor) const;
    PressedState settle(const Eigen::VectorXd &base, double turn);
    PressedState find_unloaded(const Eigen::VectorXd &base);
    unsigned int balance(const Eigen::VectorXd &base, double load, PressedState &now);
    /** Says by how much bearings let the flanks leave what was looked at; empty: they do not. */
    std::string find_excess(const Eigen::VectorXd &u) const;
    void        check_reach(const Eigen::VectorXd &u) const;
    void        report(const Eigen::VectorXd &base,
                       const PressedState    &now,
                       double                 load_factor,
                       PairEquilibriumResult &result);

    const Model                  &model_;
    Compliance                   &compliance_;
    PressedPair                   pair_;
    std::unique_ptr<PairBodies>   bodies_;
    std::unique_ptr<PressedState> pressed_; ///< where press() has ended
  };

  /** Mass-weighted mean rotation of nodes of a body about its axis under a field of small
   * displacements of all points, + about the axis [rad]. */
  double mean_rotation(const FemSpace                  &space,
                       unsigned int                     body,
                       const std::vector<unsigned int> &nodes,
                       const std::vector<double>       &displacements);

  /** How far the driven member of the pair is ahead of its kinematic turn in the drive direction,
   * at its bore, less what the driver's bore is ahead of its prescribed turn makes of it [rad]:
   * theta_driven - ratio theta_driver but for their angles at time zero. @p turn: of the driven
   * body beyond its kinematic turn, about its axis; @p displacements of all points on top of the
   * turns.
   */
  double
  lead_of_driven(const FemSpace &space, double turn, const std::vector<double> &displacements);
} // namespace vfife

#endif
