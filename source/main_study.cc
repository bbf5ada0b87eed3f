// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/failure.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/study/program.h>

#include <exception>
#include <iostream>

/** What vfife becomes for everything that is computed (main.cc).
 * Exit codes: 0 done, 1 the input cannot be used, 2 the computation failed, 3 stopped by a signal.
 */
int main(int argc, char **argv)
{
  if (const vfife::Failure obstacle = vfife::find_start_obstacle(); obstacle.exit_code != 0)
    {
      std::cerr << "vfife: " << obstacle.message << std::endl;
      return obstacle.exit_code;
    }
  vfife::MpiSession       session(argc, argv);
  const vfife::StopNotice notice(session.world().is_root());
  vfife::Failure          failure;
  try
    {
      vfife::run_program(argc, argv, session.world());
    }
  catch (...)
    {
      failure = vfife::describe_failure(std::current_exception());
    }
  return session.finish(failure);
}
