// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A sweep over a tiny model: combinations, a run that fails, going on, two runs at a time.
#include "../child_program.h"

#include <vfife/base/text/table.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/study/sweep/error_estimate.h>

namespace fs = std::filesystem;

void write_cases()
{
  std::ofstream("bars.prm") << "include " << tree_folder()
                            << "/prm/verification/two_bars.prm\n"
                               "subsection Study\n  set output folder = unused\nend\n"
                               "subsection Model\n"
                               "  subsection Body flying\n    set elements x = 20\n  end\n"
                               "  subsection Body resting\n    set elements x = 20\n  end\n"
                               "  subsection Contact faces\n    set integration = explicit\n"
                               "  end\nend\n"
                               "subsection Output\n  set report = no\nend\n";
  std::ofstream("sweep.prm")
    << "subsection Study\n  set kind = sweep\nend\n"
       "subsection Sweep\n  set base = bars.prm\n  set report = no\n"
       "  set entries = Output/verbosity=quiet; Output/steps per sample = 7\n"
       "  set reference folders = modes\n"
       "  set parameters = limit, damping\n"
       "  set figures = way, free end\n"
       "  subsection Figure way\n"
       "    set column = behind displacement x\n"
       "    set reference = 0.049\n  end\n"
       "  subsection Figure free end\n"
       "    set column = ahead displacment x\n  end\n"
       "  subsection Parameter limit\n"
       "    set entry  = Model/Contact faces/abort penetration ratio\n"
       "    set values = 0.1, 1e-6\n  end\n"
       "  subsection Parameter damping\n"
       "    set entry  = Dynamics/mass proportional damping\n"
       "    set values = 0, 100 1/s, 200 1/s\n  end\nend\n";
}

/** With the cells of both bars as numerical parameter; the second variant fails. */
void write_numerical_case()
{
  std::ofstream("numerical.prm")
    << "subsection Study\n  set kind = sweep\nend\n"
       "subsection Sweep\n  set base = bars.prm\n  set report = no\n"
       "  set entries = Output/verbosity=quiet\n"
       "  set parameters = cells, limit\n"
       "  set numerical parameters = cells\n"
       "  set figures = way, late\n"
       "  subsection Figure way\n    set column = behind displacement x\n"
       "    set reference = 0.049\n  end\n"
       "  subsection Figure late\n    set column = behind displacement x\n"
       "    set from = 1 s\n  end\n"
       "  subsection Parameter cells\n"
       "    set entry  = Model/Body flying/elements x; Model/Body resting/elements x\n"
       "    set values = 10 | 10, 20 | 20, 40 | 40\n  end\n"
       "  subsection Parameter limit\n"
       "    set entry  = Model/Contact faces/abort penetration ratio\n"
       "    set values = 0.1, 1e-6\n  end\nend\n";
}

Ending sweep(const std::string &folder, const std::vector<std::string> &more = {})
{
  std::vector<std::string> words = {program_file(), "sweep.prm", "-o", folder};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(words);
}

/** Columns run to status of the table of a sweep. */
void show_table(const std::string &folder)
{
  std::ifstream file(folder + "/sweep.csv");
  for (std::string line; std::getline(file, line);)
    {
      std::size_t end = 0;
      for (unsigned int column = 0; column < 4; ++column)
        end = line.find(',', end + 1);
      std::cout << line.substr(0, end) << std::endl;
    }
}

void show(const std::string &name, const Ending &ending)
{
  std::cout << name << ": exit code " << ending.exit_code << "\n" << ending.text;
}

std::string history(const std::string &folder)
{
  return read_text(folder + "/history.csv");
}

void numerical()
{
  write_numerical_case();
  const auto run = [](const std::vector<std::string> &more) {
    std::vector<std::string> words = {program_file(), "numerical.prm", "-o", "numerical"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  };
  const Ending ending = run({});
  check("numerical: a variant fails", ending.exit_code == 2);
  check("no samples: a warning for each run",
        has_text(ending.text, "run_01: figure \"late\": no samples from 1 s on; the record ends") &&
          has_text(ending.text, "run_03: figure \"late\": no samples"));
  show_table("numerical");
  const vfife::Table table = vfife::read_result_table("numerical/sweep.csv"),
                     bars  = vfife::read_result_table("numerical/error_bars.csv"),
                     pairs = vfife::read_result_table("numerical/differences.csv");
  check("no samples: an empty column", std::isnan(table.numbers("late")[0]));
  const auto       &way   = table.numbers("way");
  const auto       &names = bars.column("quantity").texts;
  const std::size_t row   = std::find(names.begin(), names.end(), "way") - names.begin();
  const auto        text  = [&bars, row](const char *name, const std::size_t next) {
    return bars.column(name).texts[row + next];
  };
  check_close("value: of the finest", bars.numbers("value")[row], way[2], 0);
  check_close("spread or limit of three",
              bars.numbers("error")[row],
              vfife::estimate_error({way[0], way[1], way[2]}, {4, 2, 1}).error,
              1e-15);
  check_close("of one parameter alone",
              bars.numbers("error by cells")[row],
              bars.numbers("error")[row],
              0);
  check("its run", text("run", 0) == "run_03" && text("variant", 0) == "limit = 0.1");
  check("none of failed runs", std::isnan(bars.numbers("value")[row + 1]));
  std::cout << text("method", 1) << std::endl;
  check("errors and orders by references are no figures, nor are steps",
        std::count(names.begin(), names.end(), "way error") +
            std::count(names.begin(), names.end(), "steps") ==
          0);
  std::cout << pairs.csv_row(0).substr(0, pairs.csv_row(0).find(",nan")) << " "
            << pairs.column("verdict").texts[0] << std::endl;
  check("in sweep.json", has_text(read_text("numerical/sweep.json"), "\"error bars\""));
  show("no case", run({"--set", "Sweep/base=nowhere.prm"}));
  show("not a parameter", run({"--set", "Sweep/numerical parameters=cell"}));
  show("twice", run({"--set", "Sweep/numerical parameters=cells, cells"}));
  show("one value", run({"--set", "Sweep/Parameter cells/values=10 | 10"}));
  show("a value for one entry of two", run({"--set", "Sweep/Parameter cells/values=10 | 10, 20"}));
  show("from fine to coarse", run({"--set", "Sweep/Parameter cells/values=40 | 40, 20 | 20"}));
  show("a size that grows",
       run({"--set",
            "Sweep/Parameter cells/entry=Dynamics/time step factor",
            "--set",
            "Sweep/Parameter cells/values=0.4, 0.8"}));
  show("the same cells twice",
       run({"--set", "Sweep/Parameter cells/values=10 | 10, 20 | 20, 20 | 20"}));
  show("the same number twice", run({"--set", "Sweep/Parameter limit/values=0.1, 1e-1"}));
  show("an entry of two parameters",
       run({"--set", "Sweep/Parameter limit/entry=Model/Body resting/elements x"}));
  show("an entry of all runs and of a parameter",
       run({"--set", "Sweep/entries=Model/Body flying/elements x = 5"}));
  show("two sizes", run({"--set", "Sweep/Parameter cells/relative element sizes=2, 1"}));
  show("sizes that grow", run({"--set", "Sweep/Parameter cells/relative element sizes=1, 2, 4"}));
  show("sizes of another parameter",
       run({"--set", "Sweep/Parameter limit/relative element sizes=2, 1"}));
  show("which runs",
       run({"--set", "Sweep/Parameter cells/relative element sizes=3, 2, 1", "--check"}));
}

/** The second run's gear cannot be made: the first one does not begin. */
void gears()
{
  std::ofstream("chamfers.prm") << "subsection Study\n  set kind = sweep\nend\n"
                                   "subsection Sweep\n  set base = "
                                << tree_folder()
                                << "/prm/gear/paper_tca.prm\n  set parameters = chamfer\n"
                                   "  subsection Parameter chamfer\n"
                                   "    set entry  = Gear pair/Gear/tip chamfer\n"
                                   "    set values = 0.1 mm, 0.9 mm\n  end\nend\n";
  const Ending ending = run_program({program_file(), "chamfers.prm", "-o", "chamfers"});
  check("gears of all runs are made before the first one begins",
        ending.exit_code == 1 && has_text(ending.text, "(Sweep/Parameter chamfer/values)") &&
          has_text(ending.text, "run with chamfer = 0.9 mm") &&
          has_text(ending.text, "expected at most 0.73 mm") && !fs::exists("chamfers"));
}

int main()
{
  for (const char *folder : {"all", "list", "two_ranks", "modes", "numerical", "chamfers"})
    fs::remove_all(folder);
  fs::create_directory("modes");
  std::ofstream("modes/coupled_modes.csv") << "axes,frequency [Hz]\nstanding,923\n";
  write_cases();

  const Ending ending = sweep("all");
  check("failing runs do not stop the others, and are said",
        ending.exit_code == 2 &&
          has_text(ending.text,
                   "vfife: 3 of 6 runs have failed; \"all/sweep.json\" states the reason"));
  show_table("all");
  check("runs differ",
        history("all/run_01").size() > 1000 && history("all/run_01") != history("all/run_02"));
  const std::string json = read_text("all/sweep.json");
  check("sweep.json has the failure",
        has_text(json, "\"message\": \"penetration exceeds the limit"));

  const vfife::Table table         = vfife::read_result_table("all/sweep.csv");
  const auto         numbers       = [&table](const char *name) { return table.numbers(name); };
  const vfife::Table first_history = vfife::read_result_table("all/run_01/history.csv");
  // What the table takes of the histories is there; that it is right is another matter: the free
  // end flies at 2 m/s until the bars have met (10 um) and the wave has come back to it (L/c, c =
  // sqrt(E/rho)), and then stands. Bars of 20 cells spread the wave's front.
  const double arrival = .01 / 2 + 100 / std::sqrt(206000 / 7.85e-9) * 1e3; // [ms], v in mm/ms
  check_close("way of the free end: that of the history",
              numbers("way")[0],
              first_history.numbers("behind displacement x").back(),
              0.);
  check_close("way of the free end [mm]", numbers("way")[0], 2 * arrival, .1 * 2 * arrival);
  check_close("its error", numbers("way error")[0], numbers("way")[0] / .049 - 1, 1e-14);
  // The end of the case, met to a step.
  check_close("time [s]", numbers("time")[0], 80e-6, 1e-7);
  check("it is in sweep.json", has_text(json, "\"way error\""));
  const auto &order = table.numbers("way order");
  check("order between 100 and 200 1/s only",
        std::isnan(order[0]) && std::isnan(order[1]) && std::isfinite(order[2]));
  check_close("order: halvings of the error from 100 to 200 1/s",
              order[2],
              std::log2(std::abs((numbers("way")[1] - .049) / (numbers("way")[2] - .049))),
              1e-9);
  check("no figures of failed runs", std::isnan(table.numbers("way")[3]));
  check("a column that does not exist is warned of",
        has_text(ending.text,
                 "figure \"free end\": \"ahead displacment x\" is not a column of "
                 "history.csv; did you mean \"ahead displacement x\"?"));
  check("entries of all runs",
        has_text(read_text("all/run_02/parameters.prm"), "set steps per sample       = 7"));
  check("results beside are copied",
        read_text("all/beside/1/coupled_modes.csv") == read_text("modes/coupled_modes.csv"));

  // Finished runs are kept, one without a result is done again, one goes on from its checkpoint.
  const std::string first = history("all/run_01"), second = history("all/run_02"),
                    third = history("all/run_03");
  const auto time         = fs::last_write_time("all/run_01/summary.json");
  fs::remove_all("all/run_02");
  fs::remove("all/run_03/summary.json");
  check("goes on", sweep("all", {"--restart"}).exit_code == 2);
  show_table("all");
  check("a finished run is kept", fs::last_write_time("all/run_01/summary.json") == time);
  check("the others have the same digits",
        history("all/run_02") == second && history("all/run_03") == third);
  const std::string log = read_text("all/run.log");
  check("is said",
        has_text(log, "run_01 finished: was finished before") &&
          has_text(log, "run_02 finished\n") &&
          has_text(log, "run_03 finished: continued from a checkpoint"));

  // Results of a version that did not know the bound of the assembly, which is the default now, are
  // those of another bound.
  const std::string  parameters = read_text("all/run_01/parameters.prm");
  std::istringstream lines(parameters);
  std::ofstream      older("all/run_01/parameters.prm");
  for (std::string line; std::getline(lines, line);)
    if (!has_text(line, "set time step estimate"))
      older << line << "\n";
  older.close();
  check("of another version: goes on", sweep("all", {"--restart"}).exit_code == 2);
  check("of another version: done again", fs::last_write_time("all/run_01/summary.json") != time);
  check("of another version: the same digits", history("all/run_01") == first);

  check("two at a time",
        run_program({"mpirun",
                     "-np",
                     "2",
                     program_file(),
                     "sweep.prm",
                     "-o",
                     "two_ranks",
                     "--set",
                     "Sweep/ranks per run=1"})
            .exit_code == 2);
  show_table("two_ranks");
  check("the same digits",
        history("two_ranks/run_01") == first && history("two_ranks/run_02") == second);

  show("list", sweep("list", {"--set", "Sweep/combination=list", "--check"}));
  show("unknown entry", sweep("list", {"--set", "Sweep/Parameter damping/entry=Dynamics/dampin"}));
  show("wrong value", sweep("list", {"--set", "Sweep/Parameter damping/values=0, 1 mm"}));
  show("figure without a column", sweep("list", {"--set", "Sweep/Figure way/column="}));
  show("wrong reference", sweep("list", {"--set", "Sweep/Figure way/reference=39 us"}));
  std::ofstream("twice.prm") << "include sweep.prm\nsubsection Sweep\n"
                                "  set figures = way, free end, steps\n"
                                "  subsection Figure steps\n    set column = time\n  end\nend\n";
  show("a column twice", run_program({program_file(), "twice.prm", "-o", "list"}));
  show("no entry", sweep("list", {"--set", "Sweep/entries=Output/report"}));
  show("nothing beside", sweep("list", {"--set", "Sweep/reference folders=all"}));
  // No file can have this name: there is none, as of any other that is not there.
  check("beside: a name too long for a folder",
        has_text(sweep("list", {"--set", "Sweep/reference folders=" + std::string(300, 'x')}).text,
                 "has neither coupled modes"));
  show("nothing to vary", sweep("list", {"--set", "Sweep/parameters="}));
  numerical();
  gears();
  return 0;
}
