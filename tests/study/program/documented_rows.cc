// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of tables of doc/verification, made again: the cheapest row of each table that no other test
// makes. contrib/check_pages asks for such a row of every table.
#include "documented_page.h"

#include <vfife/base/types.h>

#include <complex>

using namespace vfife;

/** Histories of a case, a sample every step. */
Columns run_case(const std::string &file, std::vector<std::string> overrides, Communicator &world)
{
  overrides.emplace_back("Output/report=no");
  overrides.emplace_back("Output/steps per sample=1");
  return read_columns(do_case(file, std::move(overrides), world) + "history.csv");
}

/** Of modes.csv: the lowest frequency of a number of diameters that is no rotation [Hz]. */
double lowest_mode(const Columns &modes, const unsigned int diameters, const double speed)
{
  double lowest = 1e9;
  for (std::size_t i = 0; i < modes.at("frequency").size(); ++i)
    if (modes.at("nodal diameter")[i] == diameters && modes.at("speed")[i] == speed &&
        modes.at("frequency")[i] > 1)
      lowest = std::min(lowest, modes.at("frequency")[i]);
  return lowest;
}

void modes(Communicator &world)
{
  const auto row =
    row_of(element_page, "### Gear of the reference pair", "quick (15,168 elements), 0 ");
  const Columns found = read_columns(do_case("prm/spiral_bevel_modes.prm",
                                             {"Operation/bore rotation=per node",
                                              "Fem/speeds=0",
                                              "Fem/cyclic symmetry=yes",
                                              "Fem/element type=incompatible modes",
                                              "Fem/modes=3",
                                              "Output/report=no"},
                                             world) +
                                     "modes.csv");
  // Columns n = 1, umbrella, 2, 3, 4.
  const std::vector<unsigned int> diameters = {1, 0, 2, 3, 4};
  for (std::size_t c = 0; c < diameters.size(); ++c)
    compare("n = " + std::to_string(diameters[c]),
            row[3 + c],
            0,
            lowest_mode(found, diameters[c], 0.));
}

void modes_of_curved_elements(Communicator &world)
{
  const auto    row = row_of(element_page, "One sector of the quick gear", "quadratic, curved");
  const Columns found =
    read_columns(do_case("prm/fem/gear_modes_cubic.prm",
                         {"Fem/element type=quadratic", "Fem/modes=2", "Output/report=no"},
                         world) +
                 "modes.csv");
  const std::vector<unsigned int> diameters = {1, 0, 2, 3};
  for (std::size_t c = 0; c < diameters.size(); ++c)
    compare("curved, n = " + std::to_string(diameters[c]),
            row[2 + c],
            0,
            lowest_mode(found, diameters[c], 0.));
}

void modes_in_spin(Communicator &world)
{
  for (const std::string measure : {"green", "biot"})
    {
      const auto row =
        row_of(element_page, "### Rise of frequencies", "`strain measure = " + measure + "`");
      const Columns found =
        read_columns(do_case("prm/fem/gear_in_spin.prm",
                             {"Fem/strain measure=" + measure, "Fem/modes=1", "Output/report=no"},
                             world) +
                     "modes.csv");
      for (unsigned int n = 0; n < 5; ++n)
        compare("n = " + std::to_string(n),
                row[1 + n],
                0,
                lowest_mode(found, n, 6835.) - lowest_mode(found, n, 0.));
    }
}

void spinning_block(Communicator &world)
{
  const std::string file = "prm/verification/free_spin.prm";
  auto              row  = row_of(dynamics_page, "| safety |", "polar, largest energy error");
  auto              h    = run_case(file, {"Dynamics/time step factor=0.9"}, world);
  compare("safety 0.9 [%]", row[1], 0, 100 * largest_size(h["energy error"]));

  row = row_of(dynamics_page, "**Frames.**", "drift of angular momentum a revolution");
  // Round-off differs between processors: only its size is stated.
  const std::string revolution = "Dynamics/end time=0.3141592653589793 ms";
  auto              polar      = run_case(file, {revolution}, world)["angular momentum z"];
  check_below("  polar", polar.back() / polar.front() - 1, 10 * numbers_in(row[1]).at(0).value);
  auto three = run_case(file,
                        {revolution, "Dynamics/corotational frame=three nodes"},
                        world)["angular momentum z"];
  compare("three nodes", row[2], 0, three.back() / three.front() - 1);
}

void bars_and_beams(Communicator &world)
{
  auto row = row_of(element_page, "## Orders of the explicit", "rotating bar, u(L)");
  auto h   = run_case("prm/verification/rotating_bar.prm", {"Model/Body bar/elements x=10"}, world);
  compare("10 cells, relative error",
          row[2],
          0,
          h["end displacement x"].back() / numbers_in(row[1]).at(0).value - 1);

  row = row_of(element_page, "**Elements and frames.**", "cantilever's ring-down, frequency");
  h   = run_case("prm/verification/vibrating_cantilever.prm",
               {"Model/Body beam/elements along length=20",
                  "Model/Body beam/elements over height=2",
                  "Dynamics/element type=full integration"},
               world);
  std::vector<double> zeros;
  const auto         &t = h["time"], &w = h["tip displacement z"];
  for (std::size_t i = 1; i < w.size(); ++i)
    if ((w[i - 1] > 0) != (w[i] > 0))
      zeros.push_back(t[i - 1] + (t[i] - t[i - 1]) * w[i - 1] / (w[i - 1] - w[i]));
  compare("full [%]",
          row[3],
          0,
          100 * (0.5 * (zeros.size() - 1) / (zeros.back() - zeros.front()) / 822.07 - 1));

  row = row_of(dynamics_page, "**Energy balance.**", "two bars, 25 to 200 cells");
  h   = run_case("prm/verification/two_bars.prm",
               {"Model/Body flying/elements x=25", "Model/Body resting/elements x=25"},
               world);
  // What the iteration of the implicit contact leaves: only its size is stated.
  check_below("  25 cells [%]",
              100 * largest_size(h["energy error"]),
              10 * numbers_in(row[1]).at(0).value);

  row = row_of(element_page, "**Unstructured mesh**", "the same mesh by linear conventional");
  do_case("prm/verification/curved_beam.prm", {"Study/kind=linear static"}, world);
  compare("displacement [mm]",
          row[1],
          0,
          read_columns("documented/history.csv")["end displacement x"].back());
}

void loaded_pair(Communicator &world)
{
  auto row = row_of(pair_page, "## Conventional finite elements", "transmission error, no web");
  compare("conventional [arcsec]",
          row[2],
          0,
          read_columns(do_case("prm/fem/loaded_spiral_bevel_quick.prm",
                               {"Gear pair/Gear/Body/body type=rim only",
                                "Fem/element type=incompatible modes",
                                "Loaded contact/positions=1",
                                three_points,
                                quick_penalty},
                               world) +
                       "loaded_contact.csv")["transmission error"]
            .front());

  row = row_of(pair_page, "| quick pair with web |", "the same, 6,344 elements");
  // The coarsest web with one row more; what coupled modes need besides.
  std::string       rows  = coarse_web;
  const std::string three = "elements along web = 3";
  rows.replace(rows.find(three), three.size(), "elements along web = 4");
  const std::string pair = quick_pair("set body type = conical web", rows, "1e-5");
  std::ofstream("coupled_row.prm")
    << pair.substr(0, pair.find("subsection Dynamics"))
    << "subsection Study\n set kind = loaded tooth contact analysis\nend\n"
       "subsection Fem\n set mass = lumped\nend\n"
       "subsection Loaded contact\n set positions = 1\n set coupled modes = 9\nend\n";
  const Table table =
    read_result_table(do_case("coupled_row.prm", {}, world) + "coupled_modes.csv");
  // Standing modes with at least 4 % of the turn, the number in brackets.
  const auto  axes = std::find_if(table.columns().begin(),
                                 table.columns().end(),
                                 [](const Table::Column &column) { return column.name == "axes"; });
  std::size_t n    = 0;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    if (axes->texts[i] == "fixed" && table.numbers("share of the static rotation")[i] > 0.04)
      {
        const std::string name = "mode " + std::to_string(n / 2 + 1);
        compare(name + " [Hz]", row[1], n++, table.numbers("frequency")[i]);
        compare(name + " [%]", row[1], n++, 100 * table.numbers("share of the static rotation")[i]);
      }
  check("  all of them", n == numbers_in(row[1]).size());
}

/** The equilibrium before the run of the coarse reference pair, with and without its web. */
void paper_pair(Communicator &world)
{
  nlohmann::json summary;
  const auto     start = [&](std::vector<std::string> entries) {
    entries.insert(entries.end(), {"Dynamics/maximum number of steps=1", "Output/report=no"});
    summary = read_json(do_case("prm/spiral_bevel_quick.prm", entries, world) + "summary.json");
  };
  const auto figure = [&](const char *part, const char *name) {
    return summary.at(part).at(name).at("value").get<double>();
  };
  const auto part = [&](const char *name) { return figure("transmission error", name); };
  start({});

  auto row = row_of(paper, "## Claims", "contact force hardly depends on thickness");
  compare("torque over arm [N]", row[2], 0, figure("figures", "torque over effective lever arm"));

  row = row_of(paper, "## Where the transmission error", "70 | -84.3");
  compare("transmission error at the start [arcsec]", row[1], 0, part("total at the start"));
  compare("teeth, rim bending and rest [arcsec]",
          row[2],
          0,
          part("teeth and rest") + part("rim bending"));
  compare("windup of the web [arcsec]", row[3], 0, part("web windup"));
  compare("tilt and shift of the rim [arcsec]", row[4], 0, part("rim tilt and shift"));
  compare("centrifugal [arcsec]", row[5], 0, part("centrifugal shift"));

  // A line search by the potential alone finds no end there (doc/theory/fem.md, Static with
  // contact). The penalty moves the teeth alone.
  start({"Gear pair/Gear/Body/body type=rim only", three_points, quick_penalty});
  row = row_of(paper, "## Where the transmission error", "none |");
  compare("centrifugal [arcsec]", row[5], 0, part("centrifugal shift"));
}

void oscillator(Communicator &)
{
  const auto frequencies = row_of(paper, "## Over speed", "Hz | 900"),
             answers     = row_of(paper, "## Over speed", "one oscillator of 1419 Hz");
  const auto stated      = numbers_in(answers[0]);
  for (std::size_t c = 1; c < 10; ++c)
    {
      const double r = numbers_in(frequencies[c]).at(0).value / stated.at(0).value;
      compare(frequencies[c] + "Hz",
              answers[c],
              0,
              1 / std::abs(std::complex<double>(1 - r * r, 2 * stated.at(1).value * r)));
    }
}

int main(int argc, char **argv)
{
  return run_parts(argc,
                   argv,
                   {oscillator,
                    modes,
                    modes_of_curved_elements,
                    modes_in_spin,
                    spinning_block,
                    bars_and_beams,
                    loaded_pair,
                    paper_pair});
}
