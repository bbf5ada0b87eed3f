// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The errors by default that doc/how-to/choose-the-mesh.md states: columns of the coarse mesh, by
// loaded analysis, reduced pair and run.
#include "documented_page.h"

#include <vfife/study/sweep/history_figure.h>

using namespace vfife;

/** By loaded analysis: as it is, and with a fillet. */
void loaded_analysis(Communicator &world)
{
  nlohmann::json figures;
  const auto     analyse = [&](std::vector<std::string> entries) {
    entries.insert(entries.end(), {"Output/report=no"});
    figures =
      read_json(do_case("prm/fem/loaded_spiral_bevel_quick.prm", entries, world) + "figures.json");
  };
  const auto compare_row = [&](const std::string                        &beginning,
                               const std::initializer_list<const char *> names) {
    const auto  row = row_of(default_page, "## How wrong", beginning);
    std::size_t i   = 0;
    for (const char *name : names)
      compare(name, row[1], i++, figures.at(name).at("value").get<double>());
  };
  analyse({});
  compare_row("mean transmission error", {"transmission error mean"});
  compare_row("peak to peak", {"transmission error peak to peak"});
  compare_row("largest pressure", {"largest pressure inside on its own grid"});
  compare_row("root tension", {"pinion root tension", "gear root tension"});
  compare_row("root compression", {"pinion root compression", "gear root compression"});
  compare_row("largest von Mises stress of the web", {"web von mises largest"});
  analyse({"Gear pair/Gear/Body/hub fillet radius=2 mm", "Loaded contact/positions=1"});
  compare_row("tension of the web at the hub", {"gear hub fillet tension"});
}

/** Of a case over the last ten of 40 mesh cycles at 20,000 rpm. */
struct AtSpeed
{
  double         mean, peak_to_peak, force_peak_to_peak; ///< of all samples
  double         mean_cycle, force_mean_cycle;           ///< peak to peak of the mean mesh cycle
  nlohmann::json figures;

  AtSpeed(const std::string &file, std::vector<std::string> entries, Communicator &world)
  {
    entries.insert(entries.end(), {"Operation/mesh cycles=40", "Output/report=no"});
    const std::string folder = do_case(file, std::move(entries), world);
    figures                  = read_json(folder + "summary.json").at("figures");
    const Table history      = read_result_table(folder + "history.csv");
    const auto  of           = [&](const char *column, const FigureValue kind) {
      HistoryFigure value;
      value.column = column;
      value.value  = kind;
      value.from   = 30. / 9000.;
      return value.compute(history).value;
    };
    mean               = of("dte", FigureValue::mean);
    peak_to_peak       = of("dte", FigureValue::peak_to_peak);
    force_peak_to_peak = of("contact force total", FigureValue::peak_to_peak);
    mean_cycle         = of("dte", FigureValue::periodic_peak_to_peak);
    force_mean_cycle   = of("contact force total", FigureValue::periodic_peak_to_peak);
  }

  /** @p column of the page's table of results at speed. */
  void compare_with(const unsigned int column) const
  {
    const auto cell = [column](const std::string &beginning) {
      return row_of(default_page, "| result at 20,000 rpm |", beginning)[column];
    };
    compare("mean [arcsec]", cell("mean transmission error"), 0, mean);
    compare("peak to peak [arcsec]", cell("peak to peak"), 0, mean_cycle);
    compare("contact force, peak to peak [N]",
            cell("sum of the contact forces"),
            0,
            force_mean_cycle);
    compare("torsional mode [Hz]",
            cell("torsional mode"),
            0,
            figures.at("torsional mode frequency, estimated").at("value").get<double>());
  }
};

void reduced_pair(Communicator &world)
{
  const AtSpeed found("prm/reduced/spiral_bevel_quick.prm", {}, world);
  found.compare_with(1);
  const auto row = row_of(pair_page, "### Elements at speed", "quadratic");
  compare("page of gear pairs: mean [arcsec]", row[2], 0, found.mean);
  compare("peak to peak [arcsec]", row[2], 1, found.peak_to_peak);
  compare("contact force, peak to peak [N]", row[3], 0, found.force_peak_to_peak);
}

void run(Communicator &world)
{
  AtSpeed("prm/spiral_bevel_quick.prm", {"Fillets/teeth=none"}, world).compare_with(4);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {loaded_analysis, reduced_pair, run});
}
