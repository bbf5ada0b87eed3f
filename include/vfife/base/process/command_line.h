// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_command_line_h
#define vfife_base_process_command_line_h

#include <iosfwd>
#include <string>
#include <vector>

namespace vfife
{
  /** What the user asked for on the command line. */
  struct CommandLine
  {
    std::string              parameter_file;
    std::string              output_folder;   ///< empty: the one of the parameter file
    std::vector<std::string> overrides;       ///< "Section/Sub/name=value"
    bool                     restart = false; ///< go on from the checkpoint in the output folder
    bool                     check   = false; ///< read and check everything, compute nothing
    bool print_parameters            = false; ///< print the parameters in force, compute nothing
    bool parameter_reference         = false; ///< print all parameters of all kinds of studies
    bool version                     = false;
    bool help                        = false;
  };

  /**
   * Reads the arguments of main().
   * @throws InputError for an unknown option (with the nearest known one), a missing value, an
   * empty output folder, no parameter file or several of them. With --restart an argument that is a
   * folder is the output folder, and without a parameter file the one that the run has left there
   * is taken.
   */
  CommandLine parse_command_line(int argc, const char *const *argv);

  /** What --help prints. */
  std::string help_text();

  /** What --version prints: version, git revision, version of deal.II. */
  std::string version_text();

  /** Prints what --help or --version ask for; false where neither is asked for. */
  bool print_requested_text(const CommandLine &line, std::ostream &out);
} // namespace vfife

#endif
