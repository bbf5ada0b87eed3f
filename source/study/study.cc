// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/declared_section.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/study/study.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <iostream>
#include <memory>
#include <optional>

namespace vfife
{
  namespace
  {
    /** A parameter file that has been read. */
    struct Case
    {
      StudyOptions               options;
      std::unique_ptr<StudyKind> study;
      dealii::ParameterHandler   prm;

      explicit Case(const ParameterFile &file)
      {
        {
          // The kind decides what else may stand in the file.
          dealii::ParameterHandler first;
          options.declare(first);
          file.read_known(first);
        }
        study = options.kind(file);
        options.declare(prm);
        study->declare(prm, file);
        file.read(prm);
      }
    };

    void read_and_run(const CommandLine   &command_line,
                      const ParameterFile &file,
                      Communicator        &communicator,
                      Log                 &log)
    {
      Case        read(file);
      auto       &prm   = read.prm;
      const auto &study = read.study;
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
      const std::string path = command_line.output_folder.empty() ? read.options.output_folder
                                                                  : command_line.output_folder;
      std::optional<std::size_t> log_size;
      if (command_line.restart)
        log_size = study->go_on(path, find_declared(prm).list_values(), communicator, log);
      OutputFolder folder(path, communicator);
      folder.attach_log(log, log_size);
      folder.write_parameters(prm);
      log.line("vfife: ", file.path(), ", results in ", folder.path());
      study->run(folder, log);
    }
  } // namespace

  EntryValues read_case(const CommandLine &command_line)
  {
    const ParameterFile file(command_line.parameter_file, command_line.overrides);
    try
      {
        const Case read(file);
        read.study->check();
        return find_declared(read.prm).list_values();
      }
    catch (const InputError &error)
      {
        throw InputError(file.explain(error));
      }
  }

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
