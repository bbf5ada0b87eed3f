// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_run_length_h
#define vfife_study_cases_run_length_h

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

  /** The end of a run that is to last for @p time, with samples in intervals of @p sample [s]: of
   * a gear pair the first sample that is not before it. @p pair may be nullptr. */
  double find_end(const Transmission *pair, double time, double sample);

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
