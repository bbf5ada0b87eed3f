// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/number_text.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/study/continuation.h>
#include <vfife/study/inner_case.h>
#include <vfife/study/study.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <utility>
#include <vector>

namespace vfife
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Kinds without a summary: the file that they write last. */
    const std::vector<std::pair<std::string, std::string>> last_files = {
      {"loaded tooth contact analysis", "loaded_contact.json"},
      {"lumped", "lumped.json"},
      {"modal", "modes.json"}};

    std::string last_file(const EntryValues &values)
    {
      for (const auto &value : values)
        if (value.first == "Study/kind")
          for (const auto &known : last_files)
            if (known.first == value.second)
              return known.second;
      return "summary.json";
    }

    bool has_results(const std::string &folder, const std::string &file)
    {
      return file == "summary.json" ? read_run_figures(folder).status == "finished"
                                    : fs::exists(folder + "/" + file);
    }

    /** Results of an earlier case must not be taken for those of one that ends before its last
     * file. */
    void remove_results(const CommandLine &line)
    {
      try
        {
          fs::remove(line.output_folder + "/" + last_file(read_case(line)));
        }
      catch (const InputError &)
        {
          // the case itself says so, on all ranks
        }
    }
  } // namespace

  std::vector<std::string> split_entries(const std::string &text, const std::string &entry)
  {
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
    switch (outcome)
      {
      case Outcome::waits:
        return "waits";
      case Outcome::finished:
        return "finished";
      case Outcome::failed:
        return "failed";
      case Outcome::interrupted:
        return "interrupted";
      }
    return "";
  }

  std::string CaseReport::describe() const
  {
    return word_for(outcome) + (message.empty() ? "" : ": " + message);
  }

  bool is_finished(const CommandLine &line, const Communicator &communicator)
  {
    // One rank looks: files may appear on the others later.
    bool finished = false;
    if (communicator.is_root())
      try
        {
          CommandLine before;
          before.parameter_file  = line.output_folder + "/parameters.prm";
          const EntryValues now  = read_case(line);
          const std::string file = last_file(now);
          if (has_results(line.output_folder, file))
            {
              refuse_changes(read_case(before), now, false);
              finished = true;
            }
        }
      catch (const InputError &)
        {
          finished = false;
        }
    return communicator.any(finished);
  }

  CaseReport do_case(CommandLine line, const bool goes_on, Communicator &communicator)
  {
    std::ostream nowhere(nullptr); // the case has a log of its own
    Log          log(nowhere, communicator.is_root(), Verbosity::quiet);
    if (goes_on)
      {
        if (is_finished(line, communicator))
          return {Outcome::finished, "was finished before"};
        line.restart = communicator.any(communicator.is_root() &&
                                        fs::exists(line.output_folder + "/checkpoint.bin"));
      }
    try
      {
        if (communicator.is_root() && !line.restart)
          remove_results(line);
        run_study(line, communicator, log);
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
