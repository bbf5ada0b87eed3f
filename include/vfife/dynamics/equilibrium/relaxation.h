// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_equilibrium_relaxation_h
#define vfife_dynamics_equilibrium_relaxation_h

#include <vfife/dynamics/dynamics_options.h>
#include <vfife/dynamics/equilibrium/small_displacements.h>
#include <vfife/dynamics/loads/bearing_loads.h>
#include <vfife/dynamics/loads/contact/contact_system.h>
#include <vfife/dynamics/loads/nodal_loads.h>
#include <vfife/dynamics/loads/rigid_walls.h>
#include <vfife/dynamics/loads/torque_loads.h>
#include <vfife/dynamics/motion/constraint_motion.h>
#include <vfife/dynamics/operator/vfife_operator.h>

#include <string>

namespace vfife
{
  class Log;
  class StandingPattern;

  /** How a relaxation went. */
  struct RelaxationReport
  {
    unsigned int steps = 0;
    /** Norm of unbalanced forces over the norm of applied ones, of the reactions where nothing is
     * applied. */
    double residual = 0;
    /** It is that of round-off, above the tolerance. */
    bool at_round_off = false;

    /** Steps and residual in words. */
    std::string describe() const;
  };

  /**
   * Static equilibrium of a model by the traditional VFIFE, i.e. explicit steps with virtual
   * damping, M a + c M v = F   (Eq. (1) of the paper), in the frames that turn with the bodies:
   * prescribed rotations stand still and the centrifugal force m omega^2 r, r in the deformed
   * state, is applied. The masses M are fictitious, scaled element by element to one common stable
   * step, and the damping follows the lowest frequency that the motion itself shows (Rayleigh
   * quotient of the last step; Underwood 1983). Or, with a given virtual damping, masses and step
   * are the true ones and the damping is constant. It stops on the residual, not on a time.
   */
  class Relaxation
  {
  public:
    Relaxation(const Model             &model,
               const RelaxationOptions &options,
               VfifeOperator           &vfife,
               ContactSystem           &contact,
               RigidWalls              &walls,
               const Communicator      &communicator,
               Log                     &log);

    /** What acts beside internal forces. */
    struct Loads
    {
      bool                   centrifugal   = true;
      double                 torque        = 1; ///< part of the full torque
      bool                   contact       = true;
      bool                   hold_rotation = false;   ///< free rotations are held
      const StandingPattern *pattern       = nullptr; ///< forces of inertia to add
      double looseness = 1; ///< factor of the tolerance, for states that are passed through
      /** Part of Model::loads and prescribed displacements; none: their histories at time zero. */
      std::optional<double> part;
    };

    /**
     * Moves the positions of @p state into equilibrium; velocities are left alone. Throws
     * NumericalError when the residual does not fall below the tolerance, with its history.
     */
    RelaxationReport solve(State &state, const Loads &loads);

    /**
     * What constraints leave of the forces at all local nodes [N] in the frames that turn with the
     * bodies: internal and applied ones and, where @p loads asks for it, those of the contact,
     * which is searched before. Collective.
     */
    NodeField compute_forces(State &state, const Loads &loads);

    /** What constraints and springs exert in the state that solve() has reached with @p loads.
     * Collective. */
    std::vector<Reaction> compute_reactions(State &state, const Loads &loads);

    /** Norm of these @p forces over the norm of the applied ones, but what is round-off stays below
     * the tolerance. Collective. */
    double compute_residual(const State &state, const Loads &loads, const NodeField &forces);

    /** Puts the constrained nodes where they belong, free rotations on their circles. Collective.
     */
    void constrain(State &state) const;

    /** Of the couplings at the state looked at last, whole turns counted [rad]. */
    std::vector<double> windings() const
    {
      return bearings_.windings();
    }

    const RelaxationOptions &options() const
    {
      return options_;
    }

  private:
    void set_friction_mode(FrictionMode mode);
    /** Internal and applied ones and, where asked for, those of the contact. */
    NodeField           compute_all_forces(State &state, const Loads &loads);
    void                add_contact(State &state, bool search, NodeField &forces);
    std::vector<double> compute_masses(const Loads &loads, double dt);
    /** Round-off of the forces under these masses [N]. */
    double find_round_off(const State &state, const std::vector<double> &masses, double scale);
    void   add_applied(const State &state, const Loads &loads, NodeField &forces);
    void   place(State &state, ConstraintMotion &constraints) const;
    double norm(const NodeField &forces, const Partition &partition) const;
    /** Log and history of a residual that is above the tolerance; throws where it diverges or takes
     * too long. */
    void watch(const RelaxationReport &report, double damping, std::string &history);
    void move(State                     &state,
              const std::vector<double> &masses,
              double                     damping,
              ConstraintMotion          &constraints,
              NodeField                 &velocity);

    const Model            &model_;
    const RelaxationOptions options_;
    VfifeOperator          &operator_;
    ContactSystem          &contact_;
    RigidWalls             &walls_;
    const Communicator     &communicator_;
    Log                    &log_;
    TorqueLoads             torques_;
    NodalLoads              loads_;
    BearingLoads            bearings_;
    SmallDisplacements      small_;
    NodeField               forces_, no_velocity_;
  };
} // namespace vfife

#endif
