// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/number_text.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/study/case_runner.h>
#include <vfife/study/continuation.h>

#include <filesystem>
#include <ostream>
#include <sstream>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    /** A summary is written after a failure too, so its status decides; other files are written
     * at the end only. */
    bool has_results(const std::string &folder, const std::string &last_file)
    {
      return last_file == "summary.json" ? read_run_figures(folder).status == "finished"
                                         : !last_file.empty() && is_there(folder + "/" + last_file);
    }
  } // namespace

  std::vector<std::string> split_entries(const std::string &text, const std::string &entry)
  {
    // Semicolons separate entries, for values have commas; what stands behind the last one is no
    // entry.
    std::vector<std::string> list;
    std::istringstream       in(text);
    for (std::string one; std::getline(in, one, ';');)
      {
        const std::size_t equals = one.find('=');
        if (trimmed(one).empty())
          continue;
        if (equals == std::string::npos)
          throw InputError(entry,
                           "\"" + trimmed(one) + "\" is not of the form Section/name = value");
        list.push_back(trimmed(one.substr(0, equals)) + "=" + trimmed(one.substr(equals + 1)));
      }
    return list;
  }

  std::string word_for(const Outcome outcome)
  {
    static const Choices<Outcome> words = {{"waits", Outcome::waits},
                                           {"finished", Outcome::finished},
                                           {"failed", Outcome::failed},
                                           {"interrupted", Outcome::interrupted}};
    return word_of(outcome, words);
  }

  std::string CaseReport::describe() const
  {
    return word_for(outcome) + (message.empty() ? "" : ": " + message);
  }

  std::string CaseFile::value(const std::string &entry) const
  {
    for (const auto &one : entries)
      if (one.first == entry)
        return one.second;
    return "";
  }

  bool CaseRunner::is_finished(const CommandLine &line, const Communicator &communicator) const
  {
    // One rank looks: files may appear on the others later.
    bool finished = false;
    if (communicator.is_root())
      try
        {
          // Results have all entries in force beside them: read as a file they are compared with
          // those of now, defaults included. Entries that are not there were not known then.
          CommandLine before;
          before.parameter_file = line.output_folder + "/parameters.prm";
          const CaseFile now    = read(line);
          if (has_results(line.output_folder, now.last_file))
            {
              const ParameterFile stated(before.parameter_file);
              auto                entries = read(before).entries;
              for (auto &[entry, value] : entries)
                if (!stated.contains(entry))
                  value = way_before(entry, value);
              finished = entries == now.entries;
            }
        }
      catch (const InputError &)
        {
          finished = false;
        }
    return communicator.any(finished);
  }

  void CaseRunner::remove_last_file(const CommandLine &line) const
  {
    try
      {
        // Which file that is depends on the kind of the case, which its file states.
        const std::string last_file = read(line).last_file;
        if (!last_file.empty())
          fs::remove(line.output_folder + "/" + last_file);
      }
    catch (const InputError &)
      {
        // the case itself says so, on all ranks
      }
  }

  CaseReport
  CaseRunner::do_case(CommandLine line, const bool resumes, Communicator &communicator) const
  {
    // A case ends in one of four ways, none of which ends the study of cases.
    std::ostream nowhere(nullptr); // the case has a log of its own
    Log          log(nowhere, communicator.is_root(), Verbosity::quiet);
    if (resumes)
      {
        if (is_finished(line, communicator))
          return {Outcome::finished, "was finished before"};
        // The root's word counts on all ranks: they must all begin anew, or all go on.
        line.restart = communicator.any(communicator.is_root() &&
                                        is_there(line.output_folder + "/checkpoint.bin"));
      }
    try
      {
        // Results of an earlier case must not be taken for those of one that ends before its last
        // file.
        if (communicator.is_root() && !line.restart)
          remove_last_file(line);
        run(line, communicator, log);
      }
    catch (const Interrupted &interruption)
      {
        return {Outcome::interrupted, interruption.what()};
      }
    catch (const InputError &error)
      {
        return {Outcome::failed, error.what()};
      }
    catch (const NumericalError &error)
      {
        return {Outcome::failed, error.what()};
      }
    return {Outcome::finished, line.restart ? "went on from a checkpoint" : ""};
  }
} // namespace vfife
