// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_reduced_run_h
#define vfife_study_reduced_reduced_run_h

#include <vfife/model/state.h>
#include <vfife/output/files/run_checkpoints.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/measures/body_ring.h>
#include <vfife/output/measures/mounting.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/study/run/run_observers.h>

#include <cstdint>
#include <functional>

namespace vfife
{
  class Log;
  class OutputFolder;
  struct Checkpoint;
  struct Swing;

  /** What the equilibrium before a reduced run has told. */
  struct ReducedStart
  {
    ReducedEquilibrium found;
    double             transmission_error = 0; ///< [rad]
    double             contact_energy     = 0; ///< [mJ]
    double             torque             = 0; ///< on the driven body [N mm]
    Mounting           misalignment;           ///< of members on shafts
  };

  /** Where the bores of the members have gone; an ideal one stays on its axis. What is given must
   * outlive it. */
  RingMotions bore_motions(const Model &model, const ReducedPair &pair);

  /** The pair's swing about it. */
  Swing swing_of(const ReducedStart &start);

  /** What the equilibrium has told, where there was one. */
  void describe_start(const ReducedStart &start, bool on_shafts, RunSummary &summary);

  /** The steps of a reduced pair from its equilibrium, or a checkpoint, to the end, with observers,
   * checkpoints, signals and the figures of the summary that any run has. */
  class ReducedRun
  {
  public:
    /** Everything given must outlive the object. */
    ReducedRun(
      OutputFolder &folder, Log &log, Model &model, ReducedPair &pair, const OutputOptions &output);

    RunObservers &observers()
    {
      return observers_;
    }
    const State &state() const
    {
      return state_;
    }
    /** Known in `prepared` but for what that sets, and in `complete`. */
    ReducedStart &start()
    {
      return start_;
    }

    /** The motion begins in the steady vibration of the swing, damped by @p mesh_damping [1/s],
     * instead of at rest (find_steady_swing()). */
    void start_swinging(const double mesh_damping)
    {
      mesh_damping_ = mesh_damping;
    }

    /**
     * Finds the equilibrium and calls @p prepared in it, or goes on from @p checkpoint (nullptr:
     * none), and does the steps up to @p n_steps; @p complete fills in @p summary, also of a run
     * that has failed, before it is written. @p step [s]; @p sample_steps from sample to sample.
     * Throws NumericalError after that, Interrupted after a checkpoint.
     */
    void run(const Checkpoint            *checkpoint,
             std::uint64_t                n_steps,
             double                       step,
             std::uint64_t                sample_steps,
             const std::function<void()> &prepared,
             const std::function<void()> &complete,
             RunSummary                  &summary);

  private:
    void serialize(ByteStream &stream);
    void show(bool last);
    /** Follows the equilibrium over one gear mesh, then starts anew. */
    void start_swing(double step);

    const OutputFolder &folder_;
    Log                &log_;
    const Model        &model_;
    ReducedPair        &pair_;
    RunObservers        observers_;
    State               state_;
    ReducedStart        start_;
    double              mesh_damping_ = not_known;
    RunCheckpoints      checkpoints_;
  };
} // namespace vfife

#endif
