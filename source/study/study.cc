// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/command_line.h>
#include <vfife/base/communicator.h>
#include <vfife/base/errors.h>
#include <vfife/base/log.h>
#include <vfife/base/parameter_file.h>
#include <vfife/base/parameters.h>
#include <vfife/output/output_folder.h>
#include <vfife/study/benchmark_study.h>
#include <vfife/study/dynamic_run.h>
#include <vfife/study/loaded_contact_study.h>
#include <vfife/study/lumped_study.h>
#include <vfife/study/mesh_study.h>
#include <vfife/study/modal_study.h>
#include <vfife/study/model_run.h>
#include <vfife/study/study.h>
#include <vfife/study/tooth_contact_study.h>

#include <deal.II/base/parameter_handler.h>

#include <iostream>
#include <memory>

namespace vfife
{
  namespace
  {
    using MakeStudy = std::unique_ptr<StudyKind> (*)(const ParameterFile &);

    template <typename Kind>
    std::unique_ptr<StudyKind> make(const ParameterFile &)
    {
      return std::make_unique<Kind>();
    }

    /** A file with a section Model and no Gear pair is a general model. */
    std::unique_ptr<StudyKind> make_run(const ParameterFile &file)
    {
      if (file.contains("Model") && !file.contains("Gear pair"))
        return std::make_unique<ModelRun>();
      return std::make_unique<DynamicRun>();
    }

    /** All kinds of studies. */
    const Choices<MakeStudy> study_kinds = {
      {"run", &make_run},
      {"static", &make<StaticRun>},
      {"tooth contact analysis", &make<ToothContactStudy>},
      {"mesh", &make<MeshStudy>},
      {"modal", &make<ModalStudy>},
      {"loaded tooth contact analysis", &make<LoadedContactStudy>},
      {"lumped", &make<LumpedStudy>},
      {"benchmark", &make<BenchmarkStudy>},
    };

    struct StudyOptions
    {
      MakeStudy   kind          = study_kinds.front().second;
      std::string output_folder = "results";

      void declare(dealii::ParameterHandler &prm)
      {
        Subsection section(prm, "Study");
        declare_choice(prm, "kind", kind, study_kinds, "What is done");
        declare_text(prm,
                     "output folder",
                     output_folder,
                     "Folder of the results, made where it is missing");
      }
    };

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
