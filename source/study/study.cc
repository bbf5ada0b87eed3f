// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/command_line.h>
#include <vfife/base/communicator.h>
#include <vfife/base/errors.h>
#include <vfife/base/log.h>
#include <vfife/base/parameter_file.h>
#include <vfife/output/output_folder.h>
#include <vfife/study/study.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <iostream>
#include <memory>

namespace vfife
{
  namespace
  {
    void read_and_run(const CommandLine   &command_line,
                      const ParameterFile &file,
                      Communicator        &communicator,
                      Log                 &log)
    {
      StudyOptions options;
      {
        // The kind decides what else may stand in the file.
        dealii::ParameterHandler first;
        options.declare(first);
        file.read_known(first);
      }
      const std::unique_ptr<StudyKind> study = options.kind(file);

      dealii::ParameterHandler prm;
      options.declare(prm);
      study->declare(prm, file);
      file.read(prm);
      if (command_line.print_parameters)
        {
          if (communicator.is_root())
            print_parameters(std::cout, prm);
          return;
        }
      study->check();
      if (command_line.check)
        {
          study->inspect(communicator, log);
          return;
        }
      OutputFolder folder(command_line.output_folder.empty() ? options.output_folder
                                                             : command_line.output_folder,
                          communicator);
      folder.attach_log(log);
      folder.write_parameters(prm);
      log.line("vfife: ", file.path(), ", results in ", folder.path());
      study->run(folder, log);
    }
  } // namespace

  void run_study(const CommandLine &command_line, Communicator &communicator, Log &log)
  {
    const ParameterFile file(command_line.parameter_file, command_line.overrides);
    try
      {
        read_and_run(command_line, file, communicator, log);
      }
    catch (const InputError &error)
      {
        throw InputError(file.explain(error));
      }
  }
} // namespace vfife
