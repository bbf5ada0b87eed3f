// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loop_explicit_solver_h
#define vfife_dynamics_loop_explicit_solver_h

#include <vfife/dynamics/dynamics_options.h>
#include <vfife/dynamics/loads/contact_system.h>
#include <vfife/dynamics/loads/nodal_loads.h>
#include <vfife/dynamics/loads/rigid_walls.h>
#include <vfife/dynamics/loads/torque_loads.h>
#include <vfife/dynamics/motion/constraint_motion.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/dynamics/watch/approach_energy.h>
#include <vfife/dynamics/watch/contact_watch.h>
#include <vfife/dynamics/watch/energy_watch.h>
#include <vfife/model/observer.h>

#include <functional>

namespace vfife
{
  class ByteStream;
  class Log;
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

    VfifeOperator &vfife_operator();
    ContactSystem &contact();
    RigidWalls    &walls();

    /** Largest stable step times safety, after the contact's vote [s]; penalties are set for
     * set_step(). */
    double stable_step();

    /** Stable step of the elements by Dynamics/step bound, without safety and contact [s]. */
    double element_step() const;

    /** The step of the run [s], at most stable_step(). Sets the penalties that follow from it. */
    void set_step(double dt);

    /** Undeformed bodies at time zero, turning as rigid bodies at their rates (velocities at
     * -dt/2). */
    void start(State &state);

    /** Replaces velocities by those of rigid turning at the bodies' rates, positions unchanged
     * (after a preload). */
    void set_rigid_velocities(State &state) const;

    /** Called with the state before each step; may throw to end a run there. All ranks. */
    using BeforeStep = std::function<void(State &)>;

    /**
     * Integrates from state.time (after exchange() with a reading stream: goes on) to @p end_time,
     * counted from where the run began. Throws NumericalError (non-finite or runaway
     * energy, runaway penetration, inverted element) after observers have seen the last state.
     */
    void run(State            &state,
             double            end_time,
             Observers        &observers,
             const BeforeStep &before_step = nullptr);

    /**
     * Passes all that a run needs to go on to the last digit, from BeforeStep or to a state that
     * start() has set up. @p common does not depend on the ranks and is equal on all of them;
     * @p own is this rank's, and of use to the same number of ranks only: nullptr when reading for
     * another one, where the run agrees to round-off. Collective.
     */
    void exchange(ByteStream &common, ByteStream *own, State &state);

    /** Fills State::measured of a state at rest (no energies of motion, no work). Collective. */
    void measure_at_rest(State &state);

    /** Of each body in the last run(). */
    const std::vector<DampingAudit> &damping_audit() const;

    /** Of the last run(). */
    const ContactLosses &contact_losses() const;

    /** The rigid motion of each body that follows from its momentum. */
    std::vector<RigidVelocity> compute_rigid_rates(const State &state) const;

    /** Steps between broad searches of the contact. */
    static constexpr unsigned int search_interval = 40;

  private:
    struct StepPowers
    {
      double drive = 0, torque = 0, damping = 0, mesh = 0, contact = 0;
    };

    void begin_run(State &state);
    void allocate();
    void compute_forces(State &state, bool measured);
    void set_damping(const State &state);
    void update_nodes(State &state);
    void advance_bodies(State &state);

    void add_work(double factor);
    void update_ledger(double strain, bool first);
    /** Copies the state for the observers, measures it, and returns the strain energy [mJ]. */
    double take_measurements(const State &state);
    void   show(Observers &observers, bool last);
    void   measure_contact();
    void   check(const State &state, bool measured);
    void   add_audit();
    void   add_rate_difference(const State &state);
    void   finish_audit();

    const Model           &model_;
    const DynamicsOptions &options_;
    const Communicator    &communicator_;
    Log                   &log_;
    Timers                &timers_;
    VfifeOperator          operator_;
    ContactSystem          contact_;
    ConstraintMotion       constraints_;
    TorqueLoads            torques_;
    NodalLoads             loads_;
    RigidWalls             walls_;
    double                 dt_ = 0;

    NodeField                  forces_;
    ElementMeasures            measures_; ///< of the state measured last
    std::vector<RigidVelocity> rigid_;
    std::vector<BodyDamping>   damping_;
    std::vector<BodySums>      sums_; ///< of the last update, over all ranks
    StepPowers                 powers_;
    double                     drive_torque_ = 0;
    EnergyLedger               ledger_, ledger_at_start_;
    ApproachEnergy             approach_;
    double                     largest_approach_ = 0; ///< at the samples so far [mJ]
    bool                       has_touched_      = false;
    std::vector<DampingAudit>  audit_;
    unsigned int               audited_steps_ = 0, audited_samples_ = 0;
    ContactWatch               contact_watch_;
    State                      observed_;
    std::uint64_t              first_step_ = 0; ///< of the run
    double                     start_time_ = 0; ///< of the run [s]
    std::vector<RigidVelocity> rates_at_start_;
    bool                       goes_on_       = false; ///< from a checkpoint
    bool                       energy_warned_ = false;
    EnergyWatch                warning_watch_, failure_watch_;
    bool                       search_now_ = false; ///< whatever the step
    double                     element_step_;       ///< [s]
  };
} // namespace vfife

#endif
