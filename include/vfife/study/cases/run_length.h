// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_run_length_h
#define vfife_study_cases_run_length_h

#include <cstdint>
#include <functional>
#include <optional>

namespace vfife
{
  class Case;
  class Log;
  class OutputFolder;
  struct Checkpoint;
  struct DynamicsOptions;
  struct OutputOptions;
  struct Transmission;

  /** How often a run is sampled and when it ends. */
  struct RunTimes
  {
    std::uint64_t sample_steps = 1; ///< from sample to sample of the histories
    double        whole        = 0; ///< when the whole run ends [s]
    double        end          = 0; ///< when this one does, by Dynamics/maximum number of steps [s]
  };

  /** Those of a run with steps of @p dt [s]: with a gear pair, @p pair, the whole run ends with
   * the first sample that is not before the case's end. @p pair may be nullptr. */
  RunTimes plan_times(const Case            &run_case,
                      const DynamicsOptions &dynamics,
                      const OutputOptions   &output,
                      const Transmission    *pair,
                      double                 dt);

  /** Whole mesh cycles up to a time. */
  unsigned int count_meshes(const Transmission &pair, double time);

  /**
   * Mesh cycles that a run needs before its ripple can be steady; 0 where vibrations do not fall.
   * Elastic vibrations fall as exp(-zeta t/2), the swing as exp(-zeta_k t/2): the slower of both to
   * a tenth, within which the ripple is judged (Ripple). The steady part is at least the second
   * half of the record, and two swing periods, @p swing_period mesh cycles each.
   */
  unsigned int
  count_steady_meshes(double mesh_frequency, double swing_period, const DynamicsOptions &dynamics);

  /** Throws InputError where a case has lengths (Case::list_lengths()) and its run no checkpoints.
   */
  void
  check_lengths(const Case &run_case, const DynamicsOptions &dynamics, const OutputOptions &output);

  /**
   * Does a run by @p once, which goes on from @p checkpoint where there is one and returns whether
   * its ripple is steady. Where the case has lengths (Case::list_lengths()), one after the other
   * until it is, each from the checkpoint at the end of the one before; a run that goes on does so
   * with the length that it was stopped in. Collective.
   */
  void run_lengths(Case                        &run_case,
                   const DynamicsOptions       &dynamics,
                   const OutputFolder          &folder,
                   std::optional<Checkpoint>   &checkpoint,
                   const std::function<bool()> &once,
                   Log                         &log);
} // namespace vfife

#endif
