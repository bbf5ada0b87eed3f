// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Runs that are stopped, killed or made longer go on to the same digits; what cannot go on is said.
#include "../forged_checkpoint.h"
#include "../history_difference.h"
#include "../quick_pair.h"

namespace fs = std::filesystem;

const std::string program = program_file();

/** Two bars that collide: contact opens and closes; with fields, and samples that are not those
 * of the checkpoints. */
void write_case()
{
  std::ofstream file("bars.prm");
  file << "include " << tree_folder() << "/prm/verification/two_bars.prm\n"
       << "subsection Model\n"
          "  subsection Body flying\n    set elements x = 40\n  end\n"
          "  subsection Body resting\n    set elements x = 40\n  end\nend\n"
          "subsection Dynamics\n  set mass proportional damping = 500\nend\n"
          "subsection Output\n  set steps per sample = 3\n  set field output interval = 20\n"
          "  set report = no\n  set checkpoint interval = 1 ms\n  set verbosity = quiet\nend\n";
}

std::vector<std::string> command(const std::string              &folder,
                                 const std::vector<std::string> &more = {})
{
  std::vector<std::string> words = {program, "bars.prm", "-o", folder};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/** deal.II writes the date into a comment. */
std::string without_date(std::string text)
{
  const std::size_t begin = text.find("<!--"), end = text.find("-->");
  return end == std::string::npos ? text : text.erase(begin, end - begin);
}

bool same_files(const std::string &one, const std::string &two)
{
  const auto history = [](const std::string &folder) { return read_text(folder + "/history.csv"); };
  unsigned int n     = 0;
  for (const auto &entry : fs::directory_iterator(one + "/fields"))
    {
      ++n;
      const std::string name = entry.path().filename();
      if (read_text(entry.path()) != read_text(two + "/fields/" + name))
        return false;
    }
  return n > 2 && history(one).size() > 1000 && history(one) == history(two) &&
         without_date(read_text(one + "/fields.pvd")) ==
           without_date(read_text(two + "/fields.pvd"));
}

/** Whether the run in that folder has passed a part of its way. */
std::function<bool()> when_written(const std::string &folder, const std::size_t bytes)
{
  return [=] {
    std::error_code error;
    const auto      size = fs::file_size(folder + "/history.csv", error);
    return !error && size > bytes && fs::exists(folder + "/checkpoint.bin");
  };
}

void show(const std::string &name, const Ending &ending)
{
  std::string text = ending.text;
  for (std::size_t at; (at = text.find(tree_folder())) != std::string::npos;)
    text.erase(at, tree_folder().size());
  std::cout << name << ": exit code " << ending.exit_code << "\n" << text;
}

void resume_after_the_end()
{
  // The end of a short run is a stop at a step that is known.
  const std::string steps = "Dynamics/maximum number of steps=";
  check("short run", run_program(command("parts", {"--set", steps + "57"})).exit_code == 0);
  check("longer",
        run_program(command("parts", {"--restart", "--set", steps + "131"})).exit_code == 0);
  check("to the end", run_program(command("parts", {"--restart"})).exit_code == 0);
  check("three parts have the digits of one run", same_files("whole", "parts"));
  const std::string log = read_text("parts/run.log");
  check("the log has all parts", has_text(log, "step 57") && has_text(log, "step 131"));
}

void resume_after_signals()
{
  const std::size_t third  = fs::file_size("whole/history.csv") / 3;
  Ending            ending = run_program(command("killed"), when_written("killed", third), SIGKILL);
  check("killed", ending.exit_code == -1 && !fs::exists("killed/summary.json"));
  check("goes on", run_program({program, "--restart", "killed"}).exit_code == 0);
  check("after a kill: the same digits", same_files("whole", "killed"));

  ending = run_program(command("stopped"), when_written("stopped", third), SIGTERM);
  check("stopped: exit code", ending.exit_code == 3);
  check("stopped: message",
        has_text(ending.text, "\nvfife: stopped on request at time ") &&
          has_text(ending.text, "after a checkpoint; to continue: vfife --restart \"stopped\""));
  check("goes on", run_program(command("stopped", {"--restart"})).exit_code == 0);
  check("after a signal: the same digits", same_files("whole", "stopped"));

  // As early as it is heard: at its end a run looks no more.
  run_program(command("frame"), when_written("frame", 0), SIGUSR1);
  const auto count = [](const std::string &folder) {
    return std::distance(fs::directory_iterator(folder + "/fields"), fs::directory_iterator());
  };
  check("SIGUSR1: one more field file", count("frame") == count("whole") + 1);
}

/** Before the first step there is nothing to go on from: that is said. */
void stop_in_equilibrium()
{
  const auto begun = [] {
    return has_text(read_text("early/run.log"), "equilibrium before the start");
  };
  const std::string pair = tree_folder() + "/prm/spiral_bevel_quick.prm";
  const Ending      ending =
    run_program({program, pair, "-o", "early", "--set", quick_penalty}, begun, SIGINT);
  check("stopped in the equilibrium: ended by the signal", ending.exit_code == -1);
  check(
    "stopped in the equilibrium: message",
    has_text(ending.text,
             "\nvfife: stopped before the first step or between runs; no checkpoint exists\n") &&
      !fs::exists("early/checkpoint.bin"));
}

/** Half of the run on one rank, the rest on two. */
void resume_with_more_ranks()
{
  run_program(command("ranks", {"--set", "Dynamics/maximum number of steps=100"}));
  std::vector<std::string> words = command("ranks", {"--restart"});
  words.insert(words.begin(), {"mpirun", "-np", "2"});
  check("two ranks go on", run_program(words).exit_code == 0);
  // Sums over ranks are rounded otherwise. Largest coordinate, cell, mass.
  histories::check_same("ranks",
                        vfife::read_result_table("ranks/history.csv"),
                        vfife::read_result_table("whole/history.csv"),
                        {200., 2.5, 2 * 100 * 5 * 5 * 7.85e-9});
  check("it is said", has_text(read_text("ranks/run.log"), "written by another number of ranks"));
}

void refuse_others()
{
  show("changed",
       run_program(
         command("parts", {"--restart", "--set", "Dynamics/mass proportional damping=400"})));
  show("other mesh",
       run_program(command("parts", {"--restart", "--set", "Model/Body flying/elements x=20"})));
  show("nothing there", run_program(command("empty", {"--restart"})));

  // Half of the last one is lost: the one before gives the same digits.
  fs::resize_file("killed/checkpoint.bin", fs::file_size("killed/checkpoint.bin") / 2);
  const Ending ending = run_program(command("killed", {"--restart"}));
  check("damaged: the one before", ending.exit_code == 0 && same_files("whole", "killed"));
  const std::string log = read_text("killed/run.log");
  check("damaged: is said",
        has_text(log, "the program uses the previous checkpoint") &&
          has_text(log, "continues from \"killed/checkpoint.previous.bin\""));
  for (const char *name : {"checkpoint.bin", "checkpoint.previous.bin"})
    {
      std::fstream file(std::string("parts/") + name, std::ios::in | std::ios::out);
      file.seekp(5000);
      file.put('x').put('y');
    }
  show("both damaged", run_program(command("parts", {"--restart"})));
}

/** Writes a checkpoint whose state is cut or changed, with the checksum that belongs to it. */
void forge(const std::string &from, const std::function<void(std::string &)> &change)
{
  forge_checkpoint(from, "forged", change);
}

/** Right checksums do not make sizes and indices right: nothing is used before it is compared
 * with the model. */
void refuse_forged()
{
  const std::string steps = "Dynamics/maximum number of steps=";
  run_program(command("parts", {"--set", steps + "57"}));
  const std::string from = "parts/checkpoint.bin";
  forge(from, [](std::string &) {});
  {
    // Behind the mark of 16 bytes.
    std::fstream file("forged/checkpoint.bin", std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(16);
    file.put(4);
  }
  show("of an earlier version", run_program(command("forged", {"--restart"})));
  forge(from, [](std::string &state) { state.resize(state.size() / 2); });
  show("forged, cut", run_program(command("forged", {"--restart"})));
  forge(from, [](std::string &state) { state += "more"; });
  show("forged, longer", run_program(command("forged", {"--restart"})));
  // Every number of the contact's lists, which are the last of the state, becomes a huge one;
  // two samples use them.
  unsigned int ended_well = 0, n = 0;
  for (std::size_t at = 16; at <= 2048; at += 56, ++n)
    {
      forge(from, [at](std::string &state) {
        state.replace(state.size() - at, 4, "\xf0\xff\xff\x7f", 4);
      });
      const int code =
        run_program(command("forged", {"--restart", "--set", steps + "63"})).exit_code;
      ended_well += code >= 0 && code <= 2 ? 1 : 0;
    }
  check("forged: no crash", ended_well == n);
}

/** Until the bars meet the error of the damping's loss grows from step to step. */
void give_up_by_energy()
{
  const Ending ending = run_program(command("given_up", {"--set", "Dynamics/energy limit=1e-6"}));
  check("energy limit: exit code, message, summary",
        ending.exit_code == 2 && has_text(ending.text, "and grows: the integration is unstable") &&
          has_text(read_text("given_up/summary.json"), "\"failed\""));
}

void report_full_disk()
{
  fs::create_directory("full");
  fs::create_symlink("/dev/full", "full/history.csv");
  show("full disk", run_program(command("full")));
  // deal.II writes the fields; the message is this program's.
  fs::remove_all("full");
  fs::create_directories("full/fields");
  fs::create_symlink("/dev/full", "full/fields/00000.vtu.part");
  show("full disk, fields", run_program(command("full")));
  show("no folder can be made", run_program(command("/proc/results")));
  show("a file, by the entry",
       run_program({program_file(), "bars.prm", "--set", "Study/output folder=bars.prm"}));
}

int main()
{
  for (const char *folder : {"whole",
                             "parts",
                             "killed",
                             "stopped",
                             "frame",
                             "early",
                             "ranks",
                             "full",
                             "empty",
                             "forged",
                             "given_up"})
    fs::remove_all(folder);
  write_case();
  const Ending whole = run_program(command("whole"));
  std::cout << whole.text;
  check("run without a stop", whole.exit_code == 0);
  resume_after_the_end();
  resume_after_signals();
  stop_in_equilibrium();
  resume_with_more_ranks();
  refuse_others();
  refuse_forged();
  give_up_by_energy();
  report_full_disk();
  return 0;
}
