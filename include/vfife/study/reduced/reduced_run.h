// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_reduced_run_h
#define vfife_study_reduced_reduced_run_h

#include <vfife/output/measures/body_ring.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/study/run/pair_preload.h>
#include <vfife/study/run/stepping.h>

namespace vfife
{
  /** Where the bores of the members have gone; an ideal one stays on its axis. What is given must
   * outlive it. */
  RingMotions bore_motions(const Model &model, const ReducedPair &pair);

  /** The steps of a reduced pair from its equilibrium. */
  class ReducedRun : public Stepping
  {
  public:
    /** @p pair must outlive the object. @p dt: the pair's step [s]. */
    ReducedRun(const RunMeans &means, ReducedPair &pair, double dt);

    /** The motion begins in the steady vibration of the swing, damped by @p mesh_damping [1/s],
     * instead of at rest (find_steady_swing()). */
    void start_swinging(const double mesh_damping)
    {
      mesh_damping_ = mesh_damping;
    }

    /** What the equilibrium has told; zeros before it is found. */
    PairPreload preload() const;

  private:
    /** What the equilibrium has told, as checkpoints have it. */
    struct Start
    {
      ReducedEquilibrium found;
      double             transmission_error = 0; ///< [rad]
      double             contact_energy     = 0; ///< [mJ]
      double             torque             = 0; ///< on the driven body [N mm]
      Mounting           misalignment;           ///< of members on shafts
    };

    void        serialize(ByteStream &common, ByteStream *own) override;
    void        prepare() override;
    void        take_steps(RunSignals &signals, bool resumed) override;
    void        end() override;
    std::string describe(const NumericalError &error) const override;
    void        show(bool last);
    /** Follows the equilibrium over one gear mesh, then starts anew. */
    void start_swing();

    ReducedPair &pair_;
    Start        start_;
    double       mesh_damping_ = not_known;
  };
} // namespace vfife

#endif
