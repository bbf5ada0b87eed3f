// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/number_text.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/folder/earlier_results.h>
#include <vfife/output/folder/folder_lock.h>
#include <vfife/study/case_runner.h>
#include <vfife/study/continuation.h>

#include <algorithm>
#include <ostream>
#include <sstream>

namespace vfife
{
  namespace
  {
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

  bool CaseFile::is_count(const std::string &entry) const
  {
    return std::any_of(allowed.begin(), allowed.end(), [&entry](const auto &one) {
      return one.first == entry && is_whole_number(one.second);
    });
  }

  std::string CaseRunner::find_change(const CommandLine &line) const
  {
    // Results have all entries in force beside them: read as a file they are compared with those of
    // now, defaults included. Entries that are not there are of a later version of the program.
    CommandLine before;
    before.parameter_file = line.output_folder + "/parameters.prm";
    const CaseFile now    = read(line);
    if (!has_results(line.output_folder, now.last_file))
      return "the earlier run has not finished";
    const ParameterFile stated(before.parameter_file);
    const CaseFile      then    = read(before);
    const auto          digests = read_input_digests(line.output_folder);
    if (then.entries.size() != now.entries.size())
      return "other sections";
    for (std::size_t i = 0; i < now.entries.size(); ++i)
      {
        const auto &[entry, value] = now.entries[i];
        const std::string &former  = then.entries[i].second;
        const auto         digest  = digests.find(entry);
        if (then.entries[i].first != entry)
          return "other sections";
        if (!stated.contains(entry))
          return entry + ": expected an entry of the earlier results, which do not have it";
        if (digest != digests.end())
          {
            const std::string other = find_other_content(former, digest->second, value);
            if (!other.empty())
              return entry + ": " + other;
          }
        else if (former != value)
          return entry + ": expected \"" + former + "\" of the earlier results, got \"" + value +
                 "\"";
      }
    return "";
  }

  CaseRunner::Earlier CaseRunner::look_at_earlier(const CommandLine  &line,
                                                  const Communicator &communicator) const
  {
    // One rank looks: files may appear on the others later.
    Earlier earlier;
    if (communicator.is_root())
      {
        try
          {
            earlier.change = find_change(line);
          }
        catch (const InputError &error)
          {
            earlier.change = error.what();
          }
        earlier.has_checkpoint = is_there(line.output_folder + "/checkpoint.bin");
        earlier.has_results    = is_there(line.output_folder + "/parameters.prm");
      }
    earlier.change         = communicator.broadcast(earlier.change);
    earlier.has_checkpoint = communicator.any(earlier.has_checkpoint);
    earlier.has_results    = communicator.any(earlier.has_results);
    return earlier;
  }

  void CaseRunner::put_away(const CommandLine &line, Communicator &communicator, Log &log) const
  {
    try
      {
        const FolderLock lock(line.output_folder, line.parameter_file, communicator, log);
        EarlierResults(line.output_folder, communicator).put_away({});
      }
    catch (const InputError &)
      {
        // in use: these are the results of another study
      }
  }

  CaseReport
  CaseRunner::do_case(CommandLine line, const bool resumes, Communicator &communicator) const
  {
    std::ostream nowhere(nullptr); // the case has a log of its own
    Log          log(nowhere, communicator.is_root(), Verbosity::quiet);
    std::string  remark;
    if (resumes)
      {
        const Earlier earlier = look_at_earlier(line, communicator);
        if (earlier.change.empty())
          return {Outcome::finished, "was finished before"};
        line.restart = earlier.has_checkpoint;
        if (line.restart)
          {
            const CaseReport report = do_or_report(line, communicator, log);
            if (report.outcome != Outcome::failed || !report.is_input)
              return report;
            // The checkpoint is of another input, or damaged.
            line.restart = false;
            remark       = "computed again: ";
          }
        else if (earlier.has_results)
          remark = "computed again: ";
        if (!remark.empty())
          remark += earlier.change;
      }
    CaseReport report = do_or_report(line, communicator, log);
    // Results of an earlier case must not be taken for those of one whose input is refused.
    if (report.is_input)
      put_away(line, communicator, log);
    if (report.outcome == Outcome::finished)
      report.message = remark;
    return report;
  }

  CaseReport
  CaseRunner::do_or_report(const CommandLine &line, Communicator &communicator, Log &log) const
  {
    // A case ends in one of four ways, none of which ends the study of cases.
    try
      {
        run(line, communicator, log);
      }
    catch (const Interrupted &interruption)
      {
        return {Outcome::interrupted, interruption.what()};
      }
    catch (const InputError &error)
      {
        return {Outcome::failed, error.what(), true};
      }
    catch (const NumericalError &error)
      {
        return {Outcome::failed, error.what()};
      }
    return {Outcome::finished, line.restart ? "continued from a checkpoint" : ""};
  }
} // namespace vfife
