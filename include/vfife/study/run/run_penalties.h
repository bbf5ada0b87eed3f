// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_run_penalties_h
#define vfife_study_run_run_penalties_h

#include <vector>

namespace vfife
{
  class Communicator;
  class GearCase;
  class Log;
  struct DynamicsOptions;

  /** Penalty of each contact pair in an explicit run of the same case [N/mm^3], with @p samples of
   * the history in a tooth mesh, so that other kinds have the same contact. Collective. */
  std::vector<double> find_run_penalties(const GearCase        &gear_case,
                                         const DynamicsOptions &dynamics,
                                         unsigned int           samples,
                                         const Communicator    &communicator,
                                         Log                   &log);
} // namespace vfife

#endif
