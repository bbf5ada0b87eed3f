// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_pair_preload_h
#define vfife_study_run_pair_preload_h

#include <vfife/dynamics/equilibrium/relaxation.h>
#include <vfife/output/measures/mounting.h>
#include <vfife/study/run/deflection_parts.h>
#include <vfife/study/run/run_start.h>
#include <vfife/study/run/steady_swing.h>

#include <functional>
#include <memory>

namespace vfife
{
  class PairStart;
  class StandingPattern;
  struct RunSummary;

  /** What the equilibrium of a loaded gear pair before the start tells; parts that its solver does
   * not know are NaN. */
  struct PairPreload
  {
    DeflectionParts parts;
    SupportParts    supports;     ///< of pairs on shafts
    Mounting        misalignment; ///< of these, under load
    Swing           swing;
    double          penalty_lag = 0; ///< [rad], compute_penalty_lag()
    /** DeflectionProbe::rim_bending() [rad]; NaN of runs that were begun by a version without it,
     * whose `teeth` contain it. */
    double rim_bending = not_known;
  };

  /**
   * Lag that the penalty springs of the contact add to a pair at rest [rad], positive. With
   * pressures p they give way by p/penalty; by virtual work under the torque T the gear yields by
   * int p (p/penalty) dA/T = 2 E/T, E their energy [mJ] and T in N mm: the mean penetration
   * weighted with force, over the arm.
   */
  double compute_penalty_lag(double contact_energy, double torque);

  /** Adds parts of the transmission error that are known, of a pair @p on_shafts those of its
   * supports as well, and the swing to @p summary in the units of users (1e-3 kg m^2 are 1 t mm^2).
   */
  void add_preload(const PairPreload &preload, bool on_shafts, RunSummary &summary);

  /**
   * Start of a gear pair (doc/theory/equilibrium.md, The preloaded start): equilibrium in the
   * turning frames, spun, then under a part of the torque, then under all of it, each telling a
   * part of the transmission error. A run with `static equilibrium` begins in the loaded one, with
   * the deformation standing still in space; one with `steady torsional vibration` there as well,
   * but where the steady vibration of the swing has it, unless the pair is on shafts; one with
   * `ramp` where the flanks of the spun shapes just touch.
   */
  class PreloadedPair : public RunStart
  {
  public:
    explicit PreloadedPair(const StartMeans &means);

    void               prepare(State &state) override;
    void               serialize(ByteStream &stream) override;
    void               serialize_later(ByteStream &stream) override;
    const PairPreload *preload() const override;

  private:
    using Relax = std::function<void(const char *name, const Relaxation::Loads &loads)>;

    /** That of `steady torsional vibration`, or none; @p torque: the load [N mm]. */
    SwingMotion find_swing(const PairStart *factors, double torque) const;
    /** From the loaded state to where the run begins; @p pattern: of that. */
    void begin(const SwingMotion &swing,
               double             torque,
               const Relax       &relax,
               StandingPattern   &pattern,
               State             &state) const;
    void log_preload() const;

    StartMeans  means_;
    PairPreload preload_;
  };
} // namespace vfife

#endif
