// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Files that a parameter file names: found beside it from any folder, and by the parameters that
// are kept with the results; known by their content where results are taken over. One study at a
// time in a folder.
#include "../child_program.h"

#include <vfife/output/files/table_reader.h>

namespace fs = std::filesystem;

const std::string program = program_file();

/** A block of a mesh file in a folder "case", pushed by a history in a table. */
void write_case()
{
  fs::create_directories("case/parts");
  std::ofstream("case/push.prm") << R"(
subsection Study
  set kind          = run
  set output folder = results
end
include parts/model.prm
subsection Dynamics
  set end time = 4 us
end
subsection Output
  set steps per sample = 1
  set report        = no
end
)";
  // An included file names its files beside itself.
  std::ofstream("case/parts/model.prm") << R"(
subsection Model
  set bodies = block
  set loads  = push
  set probes = end
  subsection Body block
    set mesh = file
    set file = block.inp
  end
  subsection Load push
    set nodes   = x+
    set force   = 10, 0, 0 N
    set history = table.csv
  end
  subsection Probe end
    set point = 1, 0, 0 mm
  end
end
)";
  std::ofstream("case/parts/table.csv") << "time,factor\n0,0\n1e-6,1\n2e-6,0.5\n";
  std::ofstream("case/parts/block.inp") << R"(*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*ELEMENT, TYPE=C3D8, ELSET=EB1
1, 1, 2, 3, 4, 5, 6, 7, 8
*NSET, NSET=x+
2, 3, 6, 7
)";
}

bool same_history(const std::string &one, const std::string &two)
{
  const std::string text = read_text(one + "/history.csv");
  return text.size() > 500 && text == read_text(two + "/history.csv");
}

/** Runs the program in a folder. */
Ending run_in(const std::string &folder, const std::vector<std::string> &words)
{
  const fs::path here = fs::current_path();
  fs::current_path(folder);
  const Ending ending = run_program(words);
  fs::current_path(here);
  return ending;
}

/** Shows what it has said where it has not said that. */
bool says(const Ending &ending, const std::string &words)
{
  const bool found = has_text(ending.text, words);
  if (!found)
    std::cout << ending.text;
  return found;
}

/** The table of the force is replaced by another one of the same name, or of another name. */
void other_content()
{
  const std::vector<std::string> longer = {
    program, "push.prm", "-o", "known", "--restart", "--set", "Dynamics/end time=5 us"};
  const auto write_table = [](const std::string &name, const std::string &rows) {
    std::ofstream("case/parts/" + name) << "time,factor\n" << rows;
  };
  const std::string rows = "0,0\n1e-6,1\n2e-6,0.5\n";
  write_table("table.csv", rows);
  check("to be made longer", run_in("case", {program, "push.prm", "-o", "known"}).exit_code == 0);
  const std::string history = read_text("case/known/history.csv");
  write_table("table.csv", "0,0\n1e-6,1\n2e-6,5\n");
  const Ending refused = run_in("case", longer);
  check("another content: refused",
        refused.exit_code == 1 &&
          says(refused, "(Model/Load push/history): expected the content") &&
          says(refused, "parts/table.csv\" (CRC-32 "));
  check("another content: the results stay", read_text("case/known/history.csv") == history);
  write_table("copy.csv", rows);
  auto words = longer;
  words.insert(words.end(), {"--set", "Model/Load push/history=parts/copy.csv"});
  check("the same content of another name goes on", run_in("case", words).exit_code == 0);
  write_table("table.csv", rows);
  check("and again of the first name", run_in("case", longer).exit_code == 0);
  check("summary.json has the digests",
        has_text(read_text("case/known/summary.json"), "\"Model/Body block/file\": \"CRC-32 "));
}

/** Cases of a comparison whose mesh is made twice as high: u = F L/(E A) at the end. */
void compared_content()
{
  std::ofstream("case/compare.prm") << R"(
subsection Study
  set kind = compare
end
subsection Compare
  set cases    = one, two
  set report = no
  set entries  = Model/Load push/history = 1; Material steel/Poisson's ratio = 0
  subsection Case one
    set base    = push.prm
    set entries = Study/kind = static
  end
  subsection Case two
    set base    = push.prm
    set entries = Study/kind = linear static
  end
end
)";
  std::ofstream("case/parts/foot.prm") << R"(
subsection Model
  set constraints = foot
  subsection Constraint foot
    set kind  = fixed
    set nodes = x-
  end
end
)";
  std::ofstream("case/push.prm", std::ios::app) << "include parts/foot.prm\n";
  const std::string mesh = read_text("case/parts/block.inp");
  std::ofstream("case/parts/block.inp") << mesh << "*NSET, NSET=x-\n1, 4, 5, 8\n";
  const auto compare = [](const std::string &more = "Compare/title=of blocks") {
    return run_in("case", {program, "compare.prm", "-o", "compared", "--set", more});
  };
  const auto displacement = [] {
    return vfife::read_result_table("case/compared/two/history.csv")
      .numbers("end displacement x")
      .front();
  };
  check("compared", compare().exit_code == 0);
  const double E = 206000;
  check_ratio("end of a bar of 1 mm^2", displacement() / (10 / E), 1e-6);
  const Ending again = compare();
  check("finished cases are taken over",
        again.exit_code == 0 && says(again, "two finished: was finished before"));

  // All y of 1 become 2.
  std::string higher = read_text("case/parts/block.inp");
  for (const char *node : {"3, 1, 1", "4, 0, 1", "7, 1, 1", "8, 0, 1"})
    higher.replace(higher.find(node) + 6, 1, "2");
  std::ofstream("case/parts/block.inp") << higher;
  const Ending other = compare();
  check("another mesh of the same name: computed again",
        other.exit_code == 0 &&
          says(other, "two finished: computed again: Model/Body block/file: expected the content"));
  check_ratio("end of a bar of 2 mm^2", displacement() / (5 / E), 1e-6);
  check("results of the lower one are put away",
        fs::exists("case/compared/two/previous/summary.json"));
}

/** The program at work in a folder until it is killed. */
class Holder
{
public:
  /** Returns when it has the lock and has begun to write. */
  explicit Holder(const std::string &folder)
    : process_(fork())
  {
    if (process_ == 0)
      {
        fs::current_path("case");
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        execl(program.c_str(),
              program.c_str(),
              "push.prm",
              "-o",
              folder.c_str(),
              "--set",
              "Dynamics/end time=100 s",
              nullptr);
        _exit(127);
      }
    while (!fs::exists("case/" + folder + "/history.csv") ||
           !has_text(read_text("case/" + folder + "/vfife.lock"), "push.prm"))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ~Holder()
  {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Holder(const Holder &)            = delete;
  Holder &operator=(const Holder &) = delete;

  pid_t process() const
  {
    return process_;
  }

private:
  pid_t process_;
};

/** The folder of a study that runs is refused by any path, and nothing there is touched. */
void locked()
{
  const auto start = [](const std::string &folder) {
    return run_in("case", {program, "push.prm", "-o", folder});
  };
  fs::remove("case/link");
  fs::create_directory("case/locked");
  fs::create_directory_symlink("locked", "case/link");
  {
    const Holder      holder("locked");
    const std::string text       = read_text("case/locked/vfife.lock"),
                      parameters = read_text("case/locked/parameters.prm");
    check("the lock says who has it",
          text.find("process " + std::to_string(holder.process()) + " on ") == 0 &&
            has_text(text, ", push.prm\n"));
    for (const char *folder : {"locked", "link", "../case/./locked"})
      {
        const Ending refused = start(folder);
        check(std::string("in use: ") + folder,
              refused.exit_code == 1 && says(refused, "which is in use (process ") &&
                says(refused, "push.prm). Wait until that study ends"));
      }
    check("in use: --restart", run_in("case", {program, "--restart", "locked"}).exit_code == 1);
    check("in use: nothing is touched",
          read_text("case/locked/parameters.prm") == parameters &&
            read_text("case/locked/vfife.lock") == text && !fs::exists("case/locked/previous"));
  }

  // A process that is killed leaves the file, but not the lock.
  check("a lock is left", fs::exists("case/locked/vfife.lock"));
  const Ending taken = start("locked");
  check("it is taken over",
        taken.exit_code == 0 && says(taken, "found the lock of a killed study (process "));
  check("the lock is gone with its holder", !fs::exists("case/locked/vfife.lock"));

  // The folder of a case is locked as that of any study.
  const Holder holder("compared/two");
  const Ending refused = run_in("case", {program, "compare.prm", "-o", "compared"});
  check("a case in use", refused.exit_code == 2 && says(refused, "which is in use (process "));
}

int main()
{
  fs::remove_all("case");
  fs::remove_all("elsewhere");
  fs::create_directories("elsewhere");
  write_case();

  const Ending beside = run_in("case", {program, "push.prm"});
  check("beside the parameter file", beside.exit_code == 0);
  if (beside.exit_code != 0)
    std::cout << beside.text;
  check("from another folder",
        run_in("elsewhere", {program, "../case/push.prm", "-o", "one"}).exit_code == 0 &&
          same_history("case/results", "elsewhere/one"));

  // The parameters that were kept, from where they lie and from anywhere.
  check("parameters.prm, in the folder of the results",
        run_in("case/results", {program, "parameters.prm", "-o", "again"}).exit_code == 0 &&
          same_history("case/results", "case/results/again"));
  check("parameters.prm, from elsewhere",
        run_in("elsewhere", {program, "one/parameters.prm", "-o", "two"}).exit_code == 0 &&
          same_history("case/results", "elsewhere/two"));

  // A run that goes on with nothing but the folder of its results.
  check("short run",
        run_in("case",
               {program, "push.prm", "-o", "short", "--set", "Dynamics/maximum number of steps=9"})
            .exit_code == 0);
  const Ending longer =
    run_in("elsewhere",
           {program, "--restart", "../case/short", "--set", "Dynamics/maximum number of steps=20"});
  check("--restart DIR alone", longer.exit_code == 0);
  if (longer.exit_code != 0)
    std::cout << longer.text;
  check("goes on with the file itself",
        run_in("case", {program, "push.prm", "-o", "short", "--restart"}).exit_code == 0 &&
          same_history("case/results", "case/short"));

  // A name that has no file beside the parameter file is one of the working folder.
  fs::rename("case/parts/table.csv", "elsewhere/table.csv");
  check("in the working folder",
        run_in("elsewhere", {program, "../case/push.prm", "-o", "three"}).exit_code == 0 &&
          same_history("case/results", "elsewhere/three"));
  const Ending missing = run_in("case", {program, "push.prm", "-o", "missing"});
  check("missing: exit code", missing.exit_code == 1);
  std::cout << missing.text;

  fs::rename("elsewhere/table.csv", "case/parts/table.csv");
  other_content();
  compared_content();
  locked();
  return 0;
}
