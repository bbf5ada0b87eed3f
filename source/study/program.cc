// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/study/parameter_reference.h>
#include <vfife/study/program.h>
#include <vfife/study/study.h>

#include <iostream>

namespace vfife
{
  void run_program(const int argc, const char *const *argv, Communicator &communicator)
  {
    const CommandLine line = parse_command_line(argc, argv);
    if (line.help || line.version)
      {
        if (communicator.is_root())
          print_requested_text(line, std::cout);
        return;
      }
    if (line.parameter_reference)
      {
        if (communicator.is_root())
          write_parameter_reference(std::cout);
        return;
      }
    Log log(std::cout, communicator.is_root());
    run_study(line, communicator, log);
  }
} // namespace vfife
