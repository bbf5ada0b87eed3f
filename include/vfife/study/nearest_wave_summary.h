// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_nearest_wave_summary_h
#define vfife_study_nearest_wave_summary_h

#include <functional>
#include <optional>

namespace vfife
{
  class Communicator;
  class Log;
  struct DynamicsOptions;
  struct Model;
  struct NearestWave;
  struct RunSummary;

  /** Says in log and summary which wave in contact is nearest to the speed of operation. */
  void report_nearest_wave(const NearestWave &nearest, Log &log, RunSummary &summary);
  /** The same of what @p find finds, and in how long; or why it is not known. */
  void report_nearest_wave(const std::function<std::optional<NearestWave>()> &find,
                           Log                                               &log,
                           RunSummary                                        &summary);

  /** Of a run whose bodies are reduced for this alone; nothing where the pair has no constant
   * speed. @p ring_rate: PairCase::ring_rate() [rad/s], for the cut-off of waves. Collective. */
  void report_nearest_wave_of_run(const Model           &model,
                                  double                 ring_rate,
                                  const DynamicsOptions &dynamics,
                                  const Communicator    &communicator,
                                  Log                   &log,
                                  RunSummary            &summary);
} // namespace vfife

#endif
