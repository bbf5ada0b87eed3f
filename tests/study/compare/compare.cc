// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Study kind compare: a coarse pair beside finite elements and the lumped model, a ring-down beside
// modes, and the spectrum that both are read from.
#include "../../model_sections.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/study/compare/compared_case.h>
#include <vfife/study/compare/nearest_mode.h>
#include <vfife/study/compare/pair/probe_passages.h>
#include <vfife/study/compare/spectrum_lines.h>

#include <filesystem>
#include <iomanip>

using namespace vfife;

void show(const Table &table)
{
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    std::cout << table.column("quantity").texts[i] << " ("
              << table.column("reference kind").texts[i]
              << "): " << table.column("verdict").texts[i] << std::endl;
}

std::size_t find_row(const Table &table, const std::string &quantity, const std::string &kind)
{
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    if (table.column("quantity").texts[i] == quantity &&
        table.column("reference kind").texts[i] == kind)
      return i;
  return table.n_rows();
}

void write_pair_cases()
{
  const std::string pair =
    quick_pair("set body type = rim only", "set elements through rim = 2", "1e-5");
  // Forces of the first instant, not of the first step.
  std::ofstream("compare_run.prm")
    << pair << "subsection Contact\n set integration = explicit\nend\n";
  const std::string bodies = pair.substr(0, pair.find("subsection Dynamics"));
  std::ofstream("compare_loaded.prm")
    << pair << model_text::loaded_contact(2, "set coupled modes = 3\n");
  std::ofstream("compare_lumped.prm") << bodies << "subsection Study\n set kind = lumped\nend\n"
                                      << "subsection Lumped\n set mesh = loaded contact\n set "
                                         "damping ratio = 0.1\n set report = no\nend\n";
  std::ofstream("compare.prm")
    << "subsection Study\n set kind = compare\nend\n"
    << "subsection Compare\n set cases = run, loaded, lumped\n set report = no\n"
    << " set title = coarse\n"
    << " subsection Case run\n  set base = compare_run.prm\n end\n"
    << " subsection Case loaded\n  set base = compare_loaded.prm\n end\n"
    << " subsection Case lumped\n  set base = compare_lumped.prm\n"
    << "  set entries = Lumped/table = {loaded}/loaded_contact.csv\n end\nend\n";
}

void pair(Communicator &world)
{
  const std::string folder = "compare_results";
  std::filesystem::remove_all(folder);
  write_pair_cases();
  run_case("compare.prm", folder, world);
  const Table table = read_result_table(folder + "/comparison.csv");
  show(table);
  const std::size_t row = find_row(table, "mean dte", "FEM");
  // Both solve the same equilibrium at the start, small displacements beside large ones.
  const Table history = read_result_table(folder + "/run/history.csv"),
              loaded  = read_result_table(folder + "/loaded/loaded_contact.csv");
  const auto &still   = loaded.numbers("transmission error");
  check_ratio("dte at the start over that of finite elements",
              history.numbers("dte").front() / still[0],
              1e-3);
  check_ratio("contact force over theirs",
              history.numbers("contact force total").front() /
                loaded.numbers("contact force total")[0],
              1e-4);
  // One mesh is a quarter of a swing: the gear hardly follows the static curve, which it leaves
  // by less than that leaves its mean.
  check_close("mean dte and that of finite elements [arcsec]",
              table.numbers("value")[row],
              table.numbers("reference")[row],
              0.5 * std::abs(still[0] - still[1]));
  check("the reference is the mean of the static curve",
        std::abs(table.numbers("reference")[row] - .5 * (still[0] + still[1])) < 1e-9);

  // The same once more: all cases are read.
  const auto time = std::filesystem::last_write_time(folder + "/run/history.csv");
  run_case("compare.prm", folder, world);
  check("finished cases are read",
        std::filesystem::last_write_time(folder + "/run/history.csv") == time);
  const Table again = read_result_table(folder + "/comparison.csv");
  check("with the same numbers", again.numbers("value") == table.numbers("value"));
}

/** A run beside the reduced pair of the same file, and that beside the pair at rest. */
void reduced(Communicator &world)
{
  std::filesystem::remove_all("compare_reduced");
  const std::string pair = quick_pair("set body type = conical web", coarse_web, "1e-6");
  std::ofstream("reduced_run.prm") << pair;
  std::ofstream("reduced_pair.prm") << pair << "subsection Study\n set kind = reduced\nend\n";
  std::ofstream("reduced_loaded.prm") << pair << model_text::loaded_contact(1);
  const auto write = [](const std::string &cases, const std::string &entries) {
    std::ofstream file("compare_reduced.prm");
    file << "subsection Study\n set kind = compare\nend\nsubsection Compare\n set cases = " << cases
         << "\n set report = no\n set entries = " << entries << "\n";
    std::istringstream names(cases);
    for (std::string name; std::getline(names >> std::ws, name, ',');)
      file << " subsection Case " << name << "\n  set base = reduced_" << name << ".prm\n end\n";
    file << "end\n";
  };
  write("run, pair", "Operation/mesh cycles = 4; Dynamics/driven speed damping = 8000 1/s");
  run_case("compare_reduced.prm", "compare_reduced", world);
  const Table table = read_result_table("compare_reduced/comparison.csv");
  show(table);
  const auto close = [&](const std::string &quantity, const double part) {
    const std::size_t row = find_row(table, quantity, "reduced");
    check_ratio(quantity + " over the reduced pair's",
                table.numbers("value")[row] / table.numbers("reference")[row],
                part);
  };
  close("mean dte", 2e-3);
  close("mean contact force total", 5e-3);
  close("dte, amplitude of mesh order 1", .1);
  close("torsional mode frequency", 1e-2);
  const std::size_t curve =
    find_row(table, "dte over the mesh cycle, rms distance from the reduced pair's", "reduced");
  check_below("curves: of the largest order",
              table.numbers("value")[curve] /
                table.numbers(
                  "value")[find_row(table, "dte, amplitude of mesh order 2", "reduced")],
              .1);

  std::filesystem::remove_all("compare_slow");
  write("pair, loaded", "Operation/mesh cycles = 1; Operation/speed = 600 rpm");
  run_case("compare_reduced.prm", "compare_slow", world);
  const Table slow = read_result_table("compare_slow/comparison.csv");
  show(slow);
  check("a reduced pair at rest in the first position",
        std::abs(read_result_table("compare_slow/pair/history.csv").numbers("dte").front() /
                   slow.numbers("reference")[find_row(slow, "mean dte", "FEM")] -
                 1.) < 1e-3);
}

void ring_down(Communicator &world)
{
  std::filesystem::remove_all("compare_beam");
  std::ofstream("compare_beam.prm")
    << "subsection Study\n set kind = compare\nend\n"
    << "subsection Compare\n set report = no\n set cases = ring, modes\n"
    << " set entries = Model/Body beam/elements along length = 10;"
       " Model/Body beam/elements over height = 2\n"
    << " subsection Case ring\n  set base = " << tree_folder()
    << "/prm/verification/vibrating_cantilever.prm\n"
    << "  set entries = Output/report = no\n end\n"
    << " subsection Case modes\n  set base = " << tree_folder()
    << "/prm/fem/cantilever_modes.prm\n end\nend\n";
  run_case("compare_beam.prm", "compare_beam", world);
  const Table table = read_result_table("compare_beam/comparison.csv");
  show(table);
  // 8 periods under Hann's window: the line of the negative frequency is 16 bins away.
  check_ratio("line over mode", table.numbers("value")[0] / table.numbers("reference")[0], 2e-4);
}

void at_rest(Communicator &world)
{
  std::filesystem::remove_all("compare_plate");
  std::ofstream("compare_plate.prm")
    << "subsection Study\n set kind = compare\nend\n"
    << "subsection Compare\n set report = no\n set cases = rest, linear\n"
    << " set entries = Output/report = no\n"
    << " subsection Case rest\n  set base = " << tree_folder()
    << "/prm/verification/plate_with_hole.prm\n end\n"
    << " subsection Case linear\n  set base = " << tree_folder()
    << "/prm/verification/plate_with_hole.prm\n"
    << "  set entries = Study/kind = linear static\n end\nend\n";
  run_case("compare_plate.prm", "compare_plate", world);
  const Table table = read_result_table("compare_plate/comparison.csv");
  show(table);
  double largest = 0;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    raise_to(largest, std::abs(table.numbers("value")[i] / table.numbers("reference")[i] - 1));
  // Strains of 1.5e-4 at the hole are the order of what linear statics leave out.
  check_below("largest difference of displacements and stresses", largest, 1e-3);
  check("but there is one", largest > 1e-7);

  // Results that are there already are read: no case is done again, and nothing differs.
  std::filesystem::remove_all("compare_read");
  std::ofstream("compare_read.prm")
    << "include compare_plate.prm\nsubsection Compare\n"
    << " subsection Case rest\n  set results = compare_plate/rest\n end\n"
    << " subsection Case linear\n  set results = compare_plate/linear\n end\nend\n";
  run_case("compare_read.prm", "compare_read", world);
  const Table again = read_result_table("compare_read/comparison.csv");
  check("results: the same rows without a case done",
        again.numbers("value") == table.numbers("value") &&
          again.numbers("reference") == table.numbers("reference") &&
          !std::filesystem::exists("compare_read/rest"));
}

void passage()
{
  // A run at a mesh frequency of 100 Hz, two samples a position; the static places are every half
  // mesh from one mesh before the mean contact on, which the run passes at 0.01 s.
  Table run, loaded;
  run.add_column("time", "s");
  run.add_text_column("probe");
  run.add_column("von mises", "MPa");
  for (unsigned int i = 0; i <= 40; ++i)
    run.add_row({1e-3 * i, "A", 10. + i});
  loaded.add_column("position after the mean contact", "mesh cycles");
  loaded.add_text_column("probe");
  loaded.add_column("von mises", "MPa");
  for (const double position : {0.5, 0.})
    for (unsigned int m = 0; m < 6; ++m)
      loaded.add_row({position + m - 1, "A", 10. + 10 * (position + m) + (m == 2 ? 3. : 0.)});
  const auto passages = compare_passages(
    run, loaded, [](const std::string &) { return 0.01; }, 100., 0.012);
  check("one probe", passages.size() == 1);
  // 0.015 to 0.04 s: 1.5, 2, ... 4 meshes.
  check("instants within the record", passages[0].instants == 6);
  check_close("peak of the run", passages[0].peak, 50., 1e-9);
  check_close("peak of the reference", passages[0].reference_peak, 50., 1e-9);
  check_close("distance", passages[0].distance, 3., 1e-9);
}

void spectrum()
{
  std::vector<double> time, signal;
  for (unsigned int i = 0; i < 1000; ++i)
    {
      time.push_back(1e-4 * i);
      signal.push_back(5 + std::sin(2 * pi * 123.4 * time[i]) +
                       .3 * std::cos(2 * pi * 456.7 * time[i]));
    }
  const auto lines = find_spectrum_lines(time, signal, 2000., .1);
  check("two lines", lines.size() == 2);
  // Window lobes fall with the third power of the distance: 33 bins leave 1e-5.
  check_ratio("first line", lines[0].frequency / 123.4, 1e-4);
  check_ratio("its amplitude", lines[0].amplitude, 1e-3);
  check_ratio("second line", lines[1].frequency / 456.7, 1e-4);
  check_close("its amplitude", lines[1].amplitude, .3, 1e-3);

  const std::vector<double> modes = {100, 1000, 1040};
  check("agrees", compare_with_modes("", 100.5, .1, modes, .01).verdict() == "agrees");
  check("differs", compare_with_modes("", 104, .5, modes, .01).verdict() == "differs");
  check("by less than a line of the spectrum",
        compare_with_modes("", 104, .1, modes, .01).verdict() == "not judged");
  check("modes that the record does not separate",
        compare_with_modes("", 1001, .04, modes, .01).verdict() == "not judged");
}

/** Cases whose bodies are not those of the first one are named with what differs. */
void other_pairs()
{
  ComparedCases cases;
  for (const auto &[name, thickness] :
       {std::pair("thin", 3.), std::pair("same", 3. + 1e-9), std::pair("thick", 4.)})
    {
      const std::string folder = std::string("compare_of_") + name;
      std::filesystem::create_directories(folder);
      std::ofstream(folder + "/geometry.json")
        << R"({"pair": {}, "gear": {"hand": "right", "web thickness": {"value": )"
        << std::setprecision(12) << thickness << R"(, "unit": "mm"}}})";
      cases.push_back({name, folder, "run", true});
    }
  // With the geometry of the first one.
  const auto write_entries = [](const std::string &folder, const char *chamfer, const char *heat) {
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/parameters.json")
      << R"({"Gear pair/Gear/tip chamfer": {"value": ")" << chamfer << R"(", "unit": "mm"},)"
      << R"("Gear pair/Gear/temperature": {"value": ")" << heat << R"(", "unit": "K"},)"
      << R"("Gear pair/mesh": {"value": ")" << folder << R"(", "unit": ""}})";
  };
  write_entries("compare_of_thin", "0.3", "0");
  for (const auto &[name, chamfer, heat] : {std::make_tuple("written otherwise", "300 um", "0 K"),
                                            std::make_tuple("chamfered", "0.5 mm", "0"),
                                            std::make_tuple("hot", "0.3 mm", "10 + x")})
    {
      const std::string folder = std::string("compare_of_") + name;
      write_entries(folder, chamfer, heat);
      std::filesystem::copy_file("compare_of_thin/geometry.json",
                                 folder + "/geometry.json",
                                 std::filesystem::copy_options::overwrite_existing);
      cases.push_back({name, folder, "run", true});
    }
  cases.push_back({"no gears", ".", "run", false});
  for (const std::string &sentence : list_other_pairs(cases))
    std::cout << sentence << std::endl;
}

void errors(Communicator &world)
{
  std::ofstream("compare_wrong.prm") << "subsection Study\n set kind = compare\nend\n"
                                     << "subsection Compare\n set cases = a, b\n"
                                     << " subsection Case a\n  set base = compare_run.prm\n"
                                     << "  set entries = Operation/sped = 1 rpm\n end\nend\n";
  print_refusal([&] { run_case("compare_wrong.prm", "unused", world); });
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  spectrum();
  pair(session.world());
  reduced(session.world());
  ring_down(session.world());
  at_rest(session.world());
  passage();
  other_pairs();
  errors(session.world());
  return 0;
}
