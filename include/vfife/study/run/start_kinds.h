// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_start_kinds_h
#define vfife_study_run_start_kinds_h

#include <memory>

namespace vfife
{
  class Communicator;
  class Compliance;
  class ExplicitSolver;
  class Log;
  class RunStart;
  struct DynamicsOptions;
  struct Model;

  /** The start that Dynamics/start asks for. Everything given must outlive it. @p compliance: of
   * the model, as PairStart asks for, or nullptr. */
  std::unique_ptr<RunStart> make_start(const Model                &model,
                                       const DynamicsOptions      &options,
                                       ExplicitSolver             &solver,
                                       std::shared_ptr<Compliance> compliance,
                                       const Communicator         &communicator,
                                       Log                        &log);
} // namespace vfife

#endif
