// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Studies one after the other in one folder, whatever their kinds: results of the earlier one are
// put away, and stay as they are where the input of the new one is refused, early or late.
#include "../../model_sections.h"
#include "../forged_checkpoint.h"
#include "../quick_pair.h"

#include <vfife/base/errors.h>

#include <set>

using namespace vfife;

const std::string folder = "new_results_folder";

const std::string model =
  "subsection Model\n set bodies = bar\n set constraints = foot\n set loads = pull\n" +
  model_text::block("bar", {{100, 10, 10}}, {{10, 2, 2}}) +
  "subsection Constraint foot\n set kind = fixed\n set nodes = x-\nend\n"
  "subsection Load pull\n set kind = force\n set nodes = x+\n set force = 1000, 0, 0 N\nend\n"
  "end\n";

/** "done", or which of the two errors has ended the study. */
std::string run(const std::string &kind,
                const std::string &more,
                Communicator      &world,
                const bool         restart = false)
{
  std::ofstream("new_results.prm") << model_text::study(kind) << model << more;
  try
    {
      run_pair("new_results.prm", folder, world, {}, restart);
    }
  catch (const InputError &)
    {
      return "input error";
    }
  catch (const NumericalError &)
    {
      return "numerical error";
    }
  return "done";
}

nlohmann::json read_summary()
{
  return read_json(folder + "/summary.json");
}

bool has(const std::string &file)
{
  return std::filesystem::exists(folder + "/" + file);
}

/** All files of the folder and of those below, with their bytes. */
std::map<std::string, std::string> read_all()
{
  namespace fs = std::filesystem;
  std::map<std::string, std::string> files;
  for (const auto &entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = read_text(entry.path().string());
  return files;
}

/** As a report leaves them: this test draws none. */
void write_report()
{
  std::filesystem::create_directories(folder + "/pictures");
  std::ofstream(folder + "/report.html") << "<html>";
  std::ofstream(folder + "/pictures/dte.svg") << "<svg>";
}

/** What a user may keep in the folder. */
const std::set<std::string> own_files = {"notes.txt", "measured.csv", "fields/view.pvsm"};

bool has_own_files()
{
  return std::all_of(own_files.begin(), own_files.end(), [](const std::string &name) {
    return has(name) && read_text(folder + "/" + name) == name;
  });
}

/** Whether all files but the user's, and those that are put away, are of the last study. */
bool is_of_one_study(const std::set<std::string> &expected)
{
  std::set<std::string> found;
  for (const auto &[name, bytes] : read_all())
    if (own_files.count(name) == 0 && name.rfind("previous/", 0) != 0)
      found.insert(name);
  for (const std::string &name : found)
    if (expected.count(name) == 0)
      std::cout << "  unexpected: " << name << std::endl;
  return found == expected;
}

const std::set<std::string> static_files = {"files.txt",
                                            "parameters.prm",
                                            "parameters.json",
                                            "run.log",
                                            "summary.json",
                                            "history.csv",
                                            "reactions.csv",
                                            "fields/bar.vtu"};

/** A run, then one that goes on: a report is that of the state before. */
void go_on(Communicator &world)
{
  const auto dynamics = [](const std::string &entry) {
    return "subsection Dynamics\n  set end time = 20 us\n  " + entry +
           "\nend\nsubsection Output\n  set steps per sample = 1\nend\n";
  };
  check("run", run("run", dynamics("set maximum number of steps = 20"), world) == "done");
  write_report();
  const auto before = read_all();
  check("it cannot go on with another damping",
        run("run", dynamics("set mass proportional damping = 400"), world, true) == "input error");
  check("refused: all bytes are as before", read_all() == before);

  // A right checksum of another model: that shows when the run has opened its files.
  const std::string checkpoint = read_text(folder + "/checkpoint.bin");
  std::ofstream("new_results.bin", std::ios::binary) << checkpoint;
  forge_checkpoint("new_results.bin", folder, [](std::string &state) {
    change_part(state, "run", [](std::string &run) { run.replace(run.find("bar"), 3, "rod"); });
  });
  const auto forged = read_all();
  check("refused late", run("run", dynamics(""), world, true) == "input error");
  check("refused late: all bytes are as before", read_all() == forged);
  std::ofstream(folder + "/checkpoint.bin", std::ios::binary) << checkpoint;

  check("goes on", run("run", dynamics(""), world, true) == "done");
  check("without a report of the state before", !has("report.html") && !has("pictures"));
  check("nothing of it is put away for good",
        !has("before_restart") &&
          read_text(folder + "/history.csv").size() > before.at("history.csv").size());
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all(folder);
  const std::string quiet = "subsection Output\n  set report = no\nend\n";
  const auto        fem   = [](const std::string &entry) {
    return "subsection Fem\n  set " + entry + "\nend\n";
  };

  check("linear static", run("linear static", quiet, session.world()) == "done");
  nlohmann::json summary = read_summary();
  check("the summary says that it has finished", summary.at("status") == "finished");
  check("and of which file", summary.at("parameter file") == "new_results.prm");

  const std::string one_step = "subsection Dynamics\n  subsection Relaxation\n    set largest "
                               "number of steps = 1\n  end\nend\n";
  check("an equilibrium that is not reached",
        run("static", quiet + one_step, session.world()) == "numerical error");
  summary = read_summary();
  check("the summary says that it has failed", summary.at("status") == "failed");
  check("and why",
        has_text(summary.at("failure").get<std::string>(), "the equilibrium was not reached in 1"));

  check("the one before is put away",
        has_text(read_text(folder + "/previous/summary.json"), "\"finished\""));

  check("modal", run("modal", fem("modes = 4"), session.world()) == "done");
  check("modes are there", has("modes.json"));
  check("nothing of the study before",
        read_summary().at("study") == "modal" && !has("history.csv"));
  std::filesystem::create_directories(folder + "/fields");
  for (const std::string &name : own_files)
    std::ofstream(folder + "/" + name) << name;
  const auto modal = read_all();
  check("a mistake in the file", run("modal", fem("mode = 4"), session.world()) == "input error");
  check("it leaves the results alone", read_all() == modal);
  // Found when the modes are computed, with a log and parameters of the new study on the disk.
  check("more modes than there are",
        run("modal", fem("modes = 5000"), session.world()) == "input error");
  check("it leaves the results alone too", read_all() == modal);

  write_report();
  check("another kind", run("linear static", quiet, session.world()) == "done");
  check("the folder has its results alone", is_of_one_study(static_files));
  check("it says so",
        has_text(read_text(folder + "/run.log"), "results of an earlier study are moved to"));
  check("files of the user are where they were", has_own_files());
  check("modes, report and pictures are put away",
        has("previous/modes.json") && has("previous/report.html") &&
          has("previous/pictures/dte.svg") &&
          read_json(folder + "/previous/summary.json").at("study") == "modal");

  // One that is broken off, as by a kill, has neither an end nor a checkpoint.
  check("the same kind", run("linear static", quiet, session.world()) == "done");
  std::filesystem::remove(folder + "/summary.json");
  check("once more", run("linear static", quiet, session.world()) == "done");
  check("what was broken off does not replace what had ended",
        has("previous/summary.json") && is_of_one_study(static_files) && !has("previous.old"));
  go_on(session.world());
  check("files of the user are still there", has_own_files());

  // A folder that a refused study has made is gone with it.
  std::filesystem::remove_all(folder);
  check("refused in a new folder",
        run("modal", fem("modes = 5000"), session.world()) == "input error" &&
          !std::filesystem::exists(folder));
  return 0;
}
