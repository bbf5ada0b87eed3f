// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/failure.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/study/parameter_reference.h>
#include <vfife/study/study.h>

#include <exception>
#include <iostream>

namespace
{
  /** Everything between start and end of MPI. */
  void run(const int argc, const char *const *argv, vfife::Communicator &world)
  {
    const vfife::CommandLine line = vfife::parse_command_line(argc, argv);
    if (line.parameter_reference)
      {
        if (world.is_root())
          vfife::write_parameter_reference(std::cout);
        return;
      }
    vfife::Log log(std::cout, world.is_root());
    vfife::run_study(line, world, log);
  }
} // namespace

/** What vfife becomes for everything that is computed (main.cc).
 * Exit codes: 0 done, 1 the input cannot be used, 2 the computation failed, 3 stopped by a signal.
 */
int main(int argc, char **argv)
{
  vfife::MpiSession session(argc, argv);
  vfife::Failure    failure;
  try
    {
      run(argc, argv, session.world());
    }
  catch (...)
    {
      failure = vfife::describe_failure(std::current_exception());
    }
  return session.finish(failure);
}
