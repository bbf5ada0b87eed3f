// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loop_explicit_solver_h
#define vfife_dynamics_loop_explicit_solver_h

#include <vfife/contact/contact_impulse.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/dynamics/loads/bearing_loads.h>
#include <vfife/dynamics/loads/contact/contact_system.h>
#include <vfife/dynamics/loads/nodal_loads.h>
#include <vfife/dynamics/loads/rigid_walls.h>
#include <vfife/dynamics/loads/torque_loads.h>
#include <vfife/dynamics/loop/body_motions.h>
#include <vfife/dynamics/loop/state_stream.h>
#include <vfife/dynamics/motion/constraint_motion.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/dynamics/watch/contact_watch.h>
#include <vfife/dynamics/watch/damping_watch.h>
#include <vfife/dynamics/watch/energy_book.h>
#include <vfife/dynamics/watch/stability_watch.h>
#include <vfife/dynamics/watch/transmission_measurement.h>
#include <vfife/model/observer.h>

#include <functional>
#include <optional>

namespace vfife
{
  class ByteStream;
  class Log;
  class NumericalError;
  class Timers;

  /**
   * Explicit VFIFE dynamics of a model: central differences of mass points under the forces of
   * massless hexahedra, contact, loads, damping relative to the turning bodies, and constraints.
   */
  class ExplicitSolver
  {
  public:
    ExplicitSolver(const Model           &model,
                   const DynamicsOptions &options,
                   const Communicator    &communicator,
                   Log                   &log,
                   Timers                &timers);

    VfifeOperator &vfife_operator()
    {
      return operator_;
    }
    ContactSystem &contact()
    {
      return contact_;
    }
    RigidWalls &walls()
    {
      return walls_;
    }

    /** Largest stable step times safety, after the contact's vote [s]; penalties are set for
     * set_step(). */
    double stable_step();

    /** Stable step of the elements by Dynamics/time step estimate, without safety and contact [s].
     */
    double element_step() const
    {
      return element_step_;
    }

    /** The step of the run [s], at most stable_step(). Sets the stiffness of points that stick. */
    void set_step(double dt);

    /** Undeformed bodies at time zero, turning as rigid bodies at their rates (velocities at
     * -dt/2). */
    void start(State &state);

    /** Replaces velocities by those of rigid motion at the bodies' rates plus the initial
     * velocities of their nodes, positions unchanged (after a preload). */
    void set_initial_velocities(State &state) const;

    /** Of the couplings in the state that a run begins with, whole turns counted [rad]. */
    void set_windings(const std::vector<double> &windings);

    /** Called with the state before each step; may throw to end a run there. All ranks. */
    using BeforeStep = std::function<void(State &)>;

    /** Called when the run has failed; returns whether it is to go on from the state that it has
     * been taken back to, by serialize(). All ranks. */
    using Recover = std::function<bool(const NumericalError &)>;

    /**
     * Integrates from state.time (after serialize() with a reading stream: goes on) to @p end_time,
     * counted from where the run began; @p state is then the one that was measured last. Throws
     * NumericalError (non-finite or runaway energy, runaway penetration, inverted element) after
     * observers have seen that state.
     */
    void run(State            &state,
             double            end_time,
             Observers        &observers,
             const BeforeStep &before_step = nullptr,
             const Recover    &recover     = nullptr);

    /** Whether the step may be too long for the bodies, which are stable with that of the worst
     * element. */
    bool may_be_unstable() const
    {
      return stability_.may_be_unstable(dt_);
    }

    /** Energy that alternates from step to step over the elastic energy at the last sample, looked
     * at while may_be_unstable(): 1 and more where a mode grows. */
    double alternating_share() const
    {
      return stability_.alternating_share();
    }

    /** Steps that are made in the place of one, see divide_step(). */
    unsigned int n_substeps() const
    {
      return n_substeps_;
    }

    /**
     * From here on makes @p n steps in the place of one, which go on being counted, sampled and
     * shown as one; penalties stay as they are. Velocities move from half of the earlier step
     * before the state to half of the new one. Collective.
     */
    void divide_step(State &state, unsigned int n);

    /**
     * Passes all that a run needs to go on to the last digit, from BeforeStep or to a state that
     * start() has set up. @p common does not depend on the ranks and is equal on all of them;
     * @p own is this rank's, and of use to the same number of ranks only: nullptr when reading for
     * another one, where the run agrees to round-off. Collective.
     */
    void serialize(ByteStream &common, ByteStream *own, State &state);

    /** Fills State::measured of a state at rest (no energies of motion, no work). Collective. */
    void measure_at_rest(State &state);

    /** Of each body in the last run(). */
    std::vector<DampingAudit> damping_audit() const;

    /** Of the last run(). */
    const ContactLosses &contact_losses() const
    {
      return contact_watch_.losses();
    }

    /** Of a gear pair in the run so far. */
    const ContactImpulse &contact_impulse() const
    {
      return contact_impulse_;
    }

    /** Steps between broad searches of the contact. */
    static constexpr unsigned int search_interval = 40;

  private:
    /** After the votes of contact and loads [s]. */
    double vote_on_step(double element_step);
    void   begin_run(State &state);
    /** Steps of the loop up to and with @p last_step. */
    void            integrate(State            &state,
                              std::uint64_t     last_step,
                              Observers        &observers,
                              const BeforeStep &before_step);
    ElementMeasures compute_forces(const State &state, bool measured);
    void            watch_contact(const State &state);
    /** Of the state before the update; State::measured. */
    void take_measurements(State &state);
    /** @p keeps: the state before becomes the one that observers see. */
    StepWork update_nodes(State &state, bool keeps);
    /** Of drives, dampers and contact, from sums over all ranks. */
    void add_powers(double time, StepWork &work) const;
    void keep_for_observers(State &state);
    /** Observers see this state until there is a sample. */
    void observe_from(const State &state);
    /** What needs the velocities after the update. */
    void take_motion();
    void take_energies(const ElementMeasures &measures);
    void take_reactions(const State &state);
    void show(Observers &observers, bool last);
    void check(const State &state, bool measured, const ElementMeasures &measures);

    const Model          &model_;
    const DynamicsOptions options_;
    const Communicator   &communicator_;
    Log                  &log_;
    Timers               &timers_;

    // What acts, and what holds.
    VfifeOperator           operator_;
    ContactSystem           contact_;
    RigidWalls              walls_;
    TorqueLoads             torques_;
    NodalLoads              loads_;
    BearingLoads            bearings_;
    ConstraintMotion        constraints_;
    TransmissionMeasurement transmission_;
    double                  element_step_;   ///< [s]
    double                  dt_         = 0; ///< of a substep [s]
    unsigned int            n_substeps_ = 1; ///< in State::dt

    // One step.
    NodeField                forces_;
    BodyMotions              motions_;
    std::vector<NodalMotion> sampled_motions_; ///< of the last sample, of this rank

    // The run in progress, and what is kept of it.
    std::optional<RunBeginning> beginning_;
    EnergyBook                  energy_;
    DampingWatch                damping_watch_;
    ContactWatch                contact_watch_;
    ContactImpulse              contact_impulse_;
    StabilityWatch              stability_;
    State                       observed_; ///< measured last
  };
} // namespace vfife

#endif
