// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_study_h
#define vfife_study_study_h

#include <memory>

namespace vfife
{
  struct CommandLine;
  class CaseRunner;
  class Communicator;
  class Log;

  /** Knows all kinds of studies. */
  std::unique_ptr<CaseRunner> make_case_runner();

  /**
   * Does what the parameter file's section Study asks for: one explicit table of kinds. Throws
   * InputError (complete message) and NumericalError. Collective.
   */
  void run_study(const CommandLine &command_line, Communicator &communicator, Log &log);
} // namespace vfife

#endif
