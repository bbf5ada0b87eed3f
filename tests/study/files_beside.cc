// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Files that a parameter file names: found beside it from any folder, and by the parameters that
// are kept with the results.
#include "../tests.h"
#include "child_program.h"

#include <filesystem>

namespace
{
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
  set history every = 1
  set pictures      = no
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
} // namespace

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
               {program, "push.prm", "-o", "short", "--set", "Dynamics/largest number of steps=9"})
            .exit_code == 0);
  const Ending longer =
    run_in("elsewhere",
           {program, "--restart", "../case/short", "--set", "Dynamics/largest number of steps=20"});
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
  return 0;
}
