// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_energy_book_h
#define vfife_dynamics_watch_energy_book_h

#include <vfife/dynamics/rigid_velocity.h>
#include <vfife/dynamics/watch/approach_energy.h>
#include <vfife/dynamics/watch/energy_watch.h>
#include <vfife/model/energy_ledger.h>

#include <string>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Log;
  struct Model;

  /** What acts on all bodies in one step, over all ranks [mJ/s]: work done on them, and losses. Of
   * what the mesh damping takes `swing` comes from the motion relative to the kinematic rotation.
   */
  struct StepPowers
  {
    double drive = 0, torque = 0, damping = 0, mesh = 0, swing = 0, contact = 0;
  };

  /**
   * Keeps the energy ledger of a run (doc/dynamics.md, Energy ledger): adds up work and losses step
   * by step, takes the energies of each sample, knows the scale that the error is divided by, and
   * tells an error that lasts and grows.
   */
  class EnergyBook
  {
  public:
    explicit EnergyBook(const Model &model);

    /** Forgets everything: a new run begins. */
    void reset();

    /** Adds what @p powers do in @p time [s]. */
    void add_work(const StepPowers &powers, double time);

    /** Adds what friction has taken since the step before [mJ], over all ranks: a whole increment,
     * as forces of both ends of the step are in it. */
    void add_friction_loss(double loss);

    /** Looks at a step in which contact presses, or does not: from the first touch on the energy of
     * approach counts in the scale. */
    void observe_contact(bool touching);

    /**
     * Takes the energies of a state: kinetic ones from the bodies' @p sums over all ranks and their
     * rigid motions @p before the update, @p strain of bodies and springs to the ground, @p contact
     * of the contact springs [mJ]. Changes are counted from the first sample on.
     */
    void take_sample(const std::vector<RigidVelocity> &before,
                     const std::vector<BodySums>      &sums,
                     double                            strain,
                     double                            contact);

    /**
     * At every sample: warns once of an error that has lasted beyond two fifths of @p limit; throws
     * NumericalError for one that is not finite, or has lasted beyond the limit and grows.
     * @p instant: when, in words.
     */
    void check(double limit, const std::string &instant, Log &log);

    const EnergyLedger &ledger() const;

    /** For checkpoints. */
    void serialize(ByteStream &stream);

  private:
    const Model   &model_;
    ApproachEnergy approach_;
    EnergyLedger   ledger_, at_start_;
    double         largest_approach_ = 0; ///< at the samples so far [mJ]
    bool           has_touched_      = false;
    bool           has_sample_       = false;
    bool           has_warned_       = false;
    EnergyWatch    warning_watch_, failure_watch_;
  };
} // namespace vfife

#endif
