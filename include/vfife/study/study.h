// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_study_h
#define vfife_study_study_h

#include <memory>

namespace vfife
{
  struct CommandLine;
  class CaseRunner;
  class Communicator;
  class GearPair;
  class Log;
  class ParameterFile;
  class ResultKeeper;

  /** Knows all kinds of studies. */
  std::unique_ptr<CaseRunner> make_case_runner();

  /**
   * Does what the parameter file's section Study asks for: one explicit table of kinds. Throws
   * InputError (complete message) and NumericalError. Collective.
   */
  void run_study(const CommandLine &command_line, Communicator &communicator, Log &log);

  /**
   * Does the study of @p file and hands its files to @p keeper: nothing is written, Study/output
   * folder is not looked at. For kinds that compute first and write at the end; those that write as
   * they go, as `run`, throw std::logic_error. Throws as run_study(). Collective.
   */
  void compute_study(const ParameterFile &file,
                     ResultKeeper        &keeper,
                     Communicator        &communicator,
                     Log                 &log);

  /** The gear pair of a file that run_study() would take, with everything derived. Throws
   * InputError (complete message). */
  GearPair read_gear_pair(const ParameterFile &file);
} // namespace vfife

#endif
