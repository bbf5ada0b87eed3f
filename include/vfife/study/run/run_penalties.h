// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_run_penalties_h
#define vfife_study_run_run_penalties_h

#include <memory>
#include <vector>

namespace vfife
{
  class Case;
  class Communicator;
  class Compliance;
  class GearCase;
  class Log;
  struct DynamicsOptions;
  struct Model;

  /** Finds the penalties that a case leaves open (calibrate_penalty()) and returns the stiffness of
   * the pair that was factorized for them; nullptr where nothing is open. Collective. */
  std::shared_ptr<Compliance> settle_penalties(const Case            &the_case,
                                               const DynamicsOptions &dynamics,
                                               const Communicator    &communicator,
                                               Log                   &log,
                                               Model                 &model);

  /** Penalty of each contact pair of the @p model [N/mm^3]; those from the step are those of an
   * explicit run of the same case with @p samples of the history in a tooth mesh. Collective. */
  std::vector<double> find_run_penalties(const Model           &model,
                                         const GearCase        &gear_case,
                                         const DynamicsOptions &dynamics,
                                         unsigned int           samples,
                                         const Communicator    &communicator,
                                         Log                   &log);
} // namespace vfife

#endif
