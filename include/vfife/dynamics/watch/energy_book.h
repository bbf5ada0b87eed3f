// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_energy_book_h
#define vfife_dynamics_watch_energy_book_h

#include <vfife/dynamics/rigid_velocity.h>
#include <vfife/dynamics/watch/approach_energy.h>
#include <vfife/dynamics/watch/energy_watch.h>
#include <vfife/model/energy_ledger.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vfife
{
  class ByteStream;
  class Log;
  struct Model;

  /** What acts on all bodies in one step, over all ranks [mJ/s]: work done on them, and losses. Of
   * what the driven speed damping takes `swing` comes from the motion relative to the kinematic
   * rotation.
   */
  struct StepPowers
  {
    double drive = 0, torque = 0, damping = 0, mesh = 0, swing = 0, contact = 0;
  };

  /** What acts at an instant does it on the ways before and after: powers with either velocity. */
  struct StepWork
  {
    StepPowers before, after;
  };

  /**
   * Keeps the energy ledger of a run (doc/theory/dynamics.md, Energy ledger): adds up work and
   * losses step by step, takes the energies of each sample, knows the scale that the error is
   * divided by, and tells an error that lasts and grows.
   */
  class EnergyBook
  {
  public:
    explicit EnergyBook(const Model &model);

    /** The lines that moments of the bodies are about, where they are not UpdateAxis::of(). */
    void set_axes(const std::vector<UpdateAxis> &axes);

    /** Forgets everything: a new run begins. */
    void reset();

    /** Energy of the round-off of one step [mJ], of which the scale is at least as much as the
     * steps so far have: what is smaller is no energy. */
    void set_round_off(double of_step);

    /** That of @p n_steps [mJ]. */
    double round_off(std::uint64_t n_steps) const;

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
     * of the contact springs [mJ], @p n_steps after the beginning. Changes are counted from the
     * first sample on.
     */
    void take_sample(const std::vector<RigidVelocity> &before,
                     const std::vector<BodySums>      &sums,
                     double                            strain,
                     double                            contact,
                     std::uint64_t                     n_steps);

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
    std::vector<UpdateAxis> axes_; ///< by body
    ApproachEnergy          approach_;
    EnergyLedger            ledger_, at_start_;
    double                  round_off_        = 0; ///< of one step [mJ]
    double                  largest_approach_ = 0; ///< at the samples so far [mJ]
    bool                    has_touched_      = false;
    bool                    has_sample_       = false;
    bool                    has_warned_       = false;
    EnergyWatch             warning_watch_, failure_watch_;
  };
} // namespace vfife

#endif
