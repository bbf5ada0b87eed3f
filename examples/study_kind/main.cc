// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "turning_energy.h"

#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/failure.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/output/files/output_folder.h>

#include <deal.II/base/parameter_handler.h>

#include <iostream>

using namespace vfife;

namespace
{
  /** The course of every study: declare, read, check, look or compute. */
  void run(const CommandLine &line, Communicator &world)
  {
    const ParameterFile file(line.parameter_file, line.overrides);
    try
      {
        const auto               study = make_turning_energy();
        dealii::ParameterHandler prm;
        study->declare(prm, file);
        file.read(prm);
        study->check();
        Log log(std::cout, world.is_root());
        if (line.check)
          {
            study->inspect(world, log);
            return;
          }
        OutputFolder folder(line.output_folder.empty() ? "results" : line.output_folder, world);
        folder.attach_log(log);
        folder.write_parameters(prm, file.path());
        study->run(folder, log);
      }
    catch (const InputError &error)
      {
        throw InputError(file.explain(error)); // with file and line
      }
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  Failure    failure;
  try
    {
      const CommandLine line = parse_command_line(argc, argv);
      if (!print_requested_text(line, std::cout))
        run(line, session.world());
    }
  catch (...)
    {
      failure = describe_failure(std::current_exception());
    }
  return session.finish(failure);
}
