// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/declared_section.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/gear/spiral_bevel/gear_pair.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/folder/earlier_results.h>
#include <vfife/output/folder/folder_lock.h>
#include <vfife/output/folder/input_files.h>
#include <vfife/study/case_runner.h>
#include <vfife/study/gear/pair_geometry.h>
#include <vfife/study/other_sections.h>
#include <vfife/study/study.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

namespace vfife
{
  namespace
  {
    /** A parameter file that has been read, and the study that it asks for. */
    struct ReadStudy
    {
      StudyOptions               options;
      std::unique_ptr<StudyKind> study;
      dealii::ParameterHandler   prm;
      OtherSections              others; ///< what other kinds read

      ReadStudy(const ParameterFile &file, const CaseRunner &runner)
      {
        // The kind decides what else may stand in the file.
        file.read_known([this](dealii::ParameterHandler &first) { options.declare(first); });
        // Then everything is declared and read strictly: an entry that is not known now is an
        // error. Entries are bound by address to the study and its options, which stay.
        study = options.kind.make(runner);
        options.declare(prm);
        study->declare(prm, file);
        others = find_other_sections(file, prm, runner);
        file.read(prm, others);
      }

      /** What no single entry shows: files that are not there, values that contradict each other.
       */
      void check() const
      {
        check_files(prm);
        study->check();
      }
    };

    /** A study that goes on is not finished until it has written its last file again, by which it
     * is taken for finished. */
    void remove_last_files(const OutputFolder &folder)
    {
      for (const auto &[word, kind] : study_kinds())
        if (!kind.last_file.empty())
          folder.remove_file(kind.last_file);
    }

    /** Names in the folder of the results that stay when earlier results are put away: the files
     * of the input, of which it may have some there, and cases that are taken over. */
    std::set<std::string> list_staying(const std::string              &folder,
                                       const ParameterFile            &file,
                                       const dealii::ParameterHandler &prm,
                                       const StudyKind                &study)
    {
      namespace fs = std::filesystem;
      std::set<std::string> staying;
      for (const std::string &name : study.cases_taken_over())
        staying.insert(name);
      std::vector<std::string> inputs = list_parameter_files(file.path());
      for (const auto &[path, name] : list_named_files(find_declared(prm)))
        inputs.push_back(name);
      std::error_code error;
      const fs::path  top = fs::weakly_canonical(folder, error);
      for (const std::string &input : inputs)
        {
          const fs::path below = fs::weakly_canonical(input, error).lexically_relative(top);
          if (!below.empty() && *below.begin() != ".." && *below.begin() != ".")
            staying.insert(below.begin()->string());
        }
      // written anew by every study
      staying.erase("parameters.prm");
      return staying;
    }

    /** Warns of former names and states which sections the study ignores. */
    void log_reading(const ParameterFile            &file,
                     const dealii::ParameterHandler &prm,
                     const OtherSections            &others,
                     Log                            &log)
    {
      std::vector<std::string> replaced = file.former_names();
      for (std::string &zero : file.list_zeros_for_words(prm))
        replaced.push_back(std::move(zero));
      if (!replaced.empty())
        {
          std::string text = "names of the previous version are read for the last time:";
          for (const std::string &one : replaced)
            text += "\n  " + one;
          log.warning(text);
        }
      if (!others.passed_over.empty())
        log.line("ignored by this kind of study: ", list_of(others.passed_over));
    }

    void read_and_run(const CommandLine   &command_line,
                      const ParameterFile &file,
                      const CaseRunner    &runner,
                      Communicator        &communicator,
                      Log                 &log)
    {
      // 1. What only looks at the file and leaves no trace: printing, checking, inspecting.
      ReadStudy   read(file, runner);
      auto       &prm   = read.prm;
      const auto &study = read.study;
      if (command_line.print_parameters)
        {
          if (communicator.is_root())
            print_parameters(std::cout, prm);
          return;
        }
      // Still before any folder is made.
      read.check();
      const std::optional<PairGeometry> geometry = find_pair_geometry(file, prm);
      if (command_line.check)
        {
          log_reading(file, read.prm, read.others, log);
          if (geometry)
            geometry->show(log);
          study->inspect(communicator, log);
          return;
        }
      // 2. Parameters that are kept name the same files from the folder they are kept in.
      std::optional<AbsoluteFileNames> absolute(prm);
      // 3. The folder of results, for this study alone. What an earlier run has left is read before
      // it is written to: its checkpoint says how much of the log is kept.
      const std::string path = command_line.output_folder.empty() ? read.options.output_folder
                                                                  : command_line.output_folder;
      const FolderLock  lock(path, file.path(), communicator, log);
      std::optional<std::size_t> log_size;
      if (command_line.restart)
        log_size = study->resume(path, find_declared(prm), communicator, log);
      OutputFolder   folder(path, communicator);
      EarlierResults earlier(path, communicator);
      bool           has_earlier = false;
      if (command_line.restart)
        earlier.keep_copies();
      else
        has_earlier = earlier.put_away(list_staying(path, file, prm, *study));
      try
        {
          folder.keep_list();
          remove_last_files(folder);
          folder.attach_log(log, log_size);
          folder.write_parameters(prm, file.path());
          absolute.reset();
          log.line("vfife: ", file.path(), ", results in ", folder.path());
          if (has_earlier)
            log.line("results of an earlier study are moved to ", folder.file("previous"));
          log_reading(file, read.prm, read.others, log);
          if (geometry)
            {
              geometry->show(log);
              write_json(folder, "geometry.json", geometry->json());
            }
          // 4. The study itself, on all ranks.
          study->run(folder, log);
        }
      catch (const InputError &)
        {
          // Much of the input is judged only when it is used: then nothing has happened here.
          const std::string failure = earlier.restore();
          if (!failure.empty())
            log.warning("results of an earlier study are in \"", path, "/previous\": ", failure);
          throw;
        }
    }

    /** Whatever @p what returns; messages get file and line of the entry they are about. */
    template <typename What>
    auto explained(const ParameterFile &file, const What &what)
    {
      try
        {
          return what();
        }
      catch (const InputError &error)
        {
          throw InputError(file.explain(error));
        }
    }

    /** Gears that cannot be made: a study finds that out before its meshes, when it has begun. */
    void check_gears(const ParameterFile &file, const dealii::ParameterHandler &prm)
    {
      if (find_pair_geometry(file, prm))
        GearPair{read_pair_options(file)};
    }

    /** Knows the kinds by their table. */
    class StudyRunner : public CaseRunner
    {
    public:
      CaseFile read(const CommandLine &line) const override
      {
        // Its files may be results of cases that come before it.
        return read_checked(line, [](const ParameterFile &, const ReadStudy &parsed) {
          parsed.study->check();
        });
      }

      CaseFile check(const CommandLine &line) const override
      {
        return read_checked(line, [](const ParameterFile &file, const ReadStudy &parsed) {
          parsed.check();
          check_gears(file, parsed.prm);
        });
      }

      void run(const CommandLine &line, Communicator &communicator, Log &log) const override
      {
        const ParameterFile file(line.parameter_file, line.overrides);
        explained(file, [&] {
          try
            {
              read_and_run(line, file, *this, communicator, log);
            }
          catch (const InputError &error)
            {
              // The entry is not in force beside -o.
              if (line.output_folder.empty() || error.entry() != "Study/output folder")
                throw;
              throw InputError(std::string("-o: ") + error.what());
            }
        });
      }

    private:
      template <typename Check>
      CaseFile read_checked(const CommandLine &line, const Check &check) const
      {
        const ParameterFile file(line.parameter_file, line.overrides);
        return explained(file, [&]() -> CaseFile {
          ReadStudy parsed(file, *this);
          check(file, parsed);
          const AbsoluteFileNames absolute(parsed.prm); // as in the parameters that are kept
          const DeclaredSection   declared = find_declared(parsed.prm);
          return {declared.list_texts(&DeclaredSection::Entry::value),
                  declared.list_texts(&DeclaredSection::Entry::pattern),
                  parsed.options.kind.last_file};
        });
      }
    };
  } // namespace

  std::unique_ptr<CaseRunner> make_case_runner()
  {
    return std::make_unique<StudyRunner>();
  }

  void run_study(const CommandLine &command_line, Communicator &communicator, Log &log)
  {
    StudyRunner().run(command_line, communicator, log);
  }

  void compute_study(const ParameterFile &file,
                     ResultKeeper        &keeper,
                     Communicator        &communicator,
                     Log                 &log)
  {
    explained(file, [&] {
      const StudyRunner runner;
      ReadStudy         read(file, runner);
      read.check();
      OutputFolder folder(keeper, communicator);
      log_reading(file, read.prm, read.others, log);
      if (const auto geometry = find_pair_geometry(file, read.prm))
        {
          geometry->show(log);
          write_json(folder, "geometry.json", geometry->json());
        }
      read.study->run(folder, log);
    });
  }

  GearPair read_gear_pair(const ParameterFile &file)
  {
    return explained(file, [&] {
      const StudyRunner runner;
      const ReadStudy   read(file, runner);
      read.check();
      return GearPair(read_pair_options(file));
    });
  }
} // namespace vfife
