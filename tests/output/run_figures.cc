// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A made-up summary whose numbers all differ: what is written where, in which units, and which of
// them a table of runs shows in which column.
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/summary.h>

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace vfife;

const std::string folder_name = "run_figures_results";

EnergyLedger make_ledger()
{
  EnergyLedger ledger;
  ledger.kinetic             = 101;
  ledger.kinetic_relative    = 102;
  ledger.strain              = 103;
  ledger.contact             = 104;
  ledger.drive_work          = 205;
  ledger.torque_work         = -56;
  ledger.damping_loss        = 7;
  ledger.mesh_damping_uptake = 8;
  ledger.swing_loss          = 6;
  ledger.contact_loss        = 9;
  ledger.start               = 110;
  ledger.scale               = 200;
  ledger.friction_loss       = 4;
  return ledger;
}

// What is there now, less the start and what was supplied, with what was lost.
constexpr double residual = 101 + 103 + 104 - 110 - (205 - 56) + 7 + 8 + 9;

RunSummary make_summary()
{
  RunSummary summary;
  summary.study    = "run";
  summary.bodies   = {{"pinion", 1000, 1200, 1e-3, 2., 10 * pi / 3, 2e-4},
                      {"gear", 3000, 4000, 5e-3, 40., -5 * pi, 0.}};
  summary.dt       = 5e-8;
  summary.time     = .0125;
  summary.steps    = 250000;
  summary.run_time = 80;
  summary.figures  = {{"torsional mode frequency, estimated", {1412, "Hz"}},
                      {"torque over effective lever arm", {8911, "N"}},
                      {"pinion root tension", {236, "MPa"}},
                      {"pinion root compression", {-302, "MPa"}},
                      {"gear root stress range", {392, "MPa"}}};
  summary.probes.resize(1);
  summary.probes[0].name     = "node A";
  summary.probes[0].largest  = 63;
  summary.probes[0].median   = 46;
  summary.transmission_error = {{"total at the start", {-88.5, "arcsec"}},
                                {"teeth and rest", {-40.25, "arcsec"}},
                                {"web windup", {-20.5, "arcsec"}},
                                {"rim tilt and shift", {-18.75, "arcsec"}},
                                {"rim bending", {-7.5, "arcsec"}},
                                {"centrifugal shift", {-9., "arcsec"}},
                                {"bearings", {-32., "arcsec"}},
                                {"shaft bending", {-94., "arcsec"}}};
  summary.misalignment       = {{"offset", {148., "um"}},
                                {"pinion axial shift", {15., "um"}},
                                {"gear axial shift", {-72., "um"}},
                                {"shaft angle error", {1.8, "arcmin"}}};
  SteadyPart part;
  part.found             = true;
  part.start_time        = .004;
  part.end_time          = .012;
  part.cycles            = 72;
  part.period            = 6;
  part.largest_change    = .007;
  part.ripple.judged     = true;
  part.ripple.columns    = {{"dte", "arcsec", 1.5, 2.5, .4}};
  part.columns           = {{"contact force total", "N", 8900, 310, 80},
                            {"dte", "arcsec", -88, 2.5, .6},
                            {"rim dte", "arcsec", -61, 2.25, .5}};
  summary.steady         = part;
  summary.energy         = make_ledger();
  summary.damping        = {{"gear", 2000, 5e6, pi / 30, -pi / 10}};
  summary.contact_losses = {3, .005, .0002};
  return summary;
}

void places(const OutputFolder &folder)
{
  const std::string path  = folder.file("summary.json");
  const auto        close = [&path](const std::string &pointer, const double expected) {
    check_close(pointer, read_figure(path, pointer), expected, 1e-13 * std::abs(expected));
  };
  close("/mesh/cells", 4000);
  close("/mesh/nodes", 5200);
  close("/mesh/bodies/0/mass", 1);             // t -> kg
  close("/mesh/bodies/0/added mass", .2);      // t -> kg
  close("/mesh/bodies/0/axial inertia", .002); // t mm^2 -> kg m^2
  close("/mesh/bodies/0/speed at the start", 100);
  close("/mesh/bodies/1/speed at the start", -150);
  close("/run/step", 5e-8);
  close("/run/element-steps per second", 4000. * 250000 / 80);
  close("/steady part/start", .004);
  close("/steady part/end", .012);
  close("/steady part/mesh cycles", 72);
  close("/steady part/torsional mode period", 6);
  close("/steady part/largest change of the means", .007);
  close("/steady part/ripple/judged", 1);
  close("/steady part/ripple/steady", 0);
  close("/steady part/ripple/columns/dte/peak to peak of the first half", 1.5);
  close("/steady part/ripple/columns/dte/peak to peak of the second half", 2.5);
  close("/steady part/ripple/columns/dte/largest change", .4);
  close("/steady part/columns/dte/mean", -88);
  close("/steady part/columns/dte/peak to peak", 2.5);
  close("/steady part/columns/dte/standard deviation", .6);
  close("/energy/kinetic", 101);
  close("/energy/kinetic, relative to the turning bodies", 102);
  close("/energy/strain", 103);
  close("/energy/contact", 104);
  close("/energy/start", 110);
  close("/energy/work of the drive", 205);
  close("/energy/work of the torques", -56);
  close("/energy/damping loss", 7);
  close("/energy/removed by the driven speed damping", 8);
  close("/energy/removed by the driven speed damping from the torsional mode", 6);
  close("/energy/contact loss", 9);
  close("/energy/contact loss by friction", 4);
  close("/energy/residual", residual);
  close("/energy/error", residual / 200);
  close("/damping audit/0/net torque", 2);              // N mm -> N m
  close("/damping audit/0/power", 5000);                // mJ/s -> W
  close("/damping audit/0/drift of rotation speed", 1); // rad/s -> rpm
  close("/damping audit/0/mean speed rate minus momentum rate", -3);
  close("/contact losses/count", 3);
  close("/contact losses/first", .005);
  close("/contact losses/time without contact", .0002);
}

void table_of_runs(const OutputFolder &folder)
{
  const std::map<std::string, Figure> expected = {{"steps", {250000, "-"}},
                                                  {"time", {.0125, "s"}},
                                                  {"run time", {80, "s"}},
                                                  {"energy error", {residual / 200, "-"}},
                                                  {"contact losses", {3, "-"}},
                                                  {"steady", {1, "-"}},
                                                  {"ripple steady", {0, "-"}},
                                                  {"contact force mean", {8900, "N"}},
                                                  {"contact force peak to peak", {310, "N"}},
                                                  {"dte mean", {-88, "arcsec"}},
                                                  {"dte peak to peak", {2.5, "arcsec"}},
                                                  {"rim dte mean", {-61, "arcsec"}},
                                                  {"rim dte peak to peak", {2.25, "arcsec"}},
                                                  {"dte at the start", {-88.5, "arcsec"}},
                                                  {"teeth and rest", {-40.25, "arcsec"}},
                                                  {"web windup", {-20.5, "arcsec"}},
                                                  {"rim tilt and shift", {-18.75, "arcsec"}},
                                                  {"rim bending", {-7.5, "arcsec"}},
                                                  {"centrifugal shift", {-9., "arcsec"}},
                                                  {"bearings", {-32., "arcsec"}},
                                                  {"shaft bending", {-94., "arcsec"}},
                                                  {"offset", {148., "um"}},
                                                  {"pinion axial shift", {15., "um"}},
                                                  {"gear axial shift", {-72., "um"}},
                                                  {"shaft angle error", {1.8, "arcmin"}},
                                                  {"torsional mode frequency", {1412, "Hz"}}};
  const RunFigures                    run      = read_run_figures(folder.path());
  check("it has finished", run.status == "finished" && run.failure.empty());
  check("as many columns", run.figures.size() == expected.size());
  for (const auto &named : run.figures)
    {
      const auto found = expected.find(named.first);
      check("column " + named.first,
            found != expected.end() && named.second.value == found->second.value &&
              named.second.unit == found->second.unit);
    }
}

/** By names that depend on the case, beside a case that has none of them and one of its own. */
void figures_of_cases(const OutputFolder &folder)
{
  const OutputFolder other(folder_name + "/other", folder.communicator());
  write_own_figures(other, {{"pinion root tension", {240, "MPa"}}, {"lag", {-3, "arcsec"}}});
  const std::map<std::string, std::array<double, 2>> expected = {
    {"pinion root tension", {{236, 240}}},
    {"pinion root compression", {{-302, std::nan("")}}},
    {"gear root stress range", {{392, std::nan("")}}},
    {"node A largest per revolution", {{63, std::nan("")}}},
    {"node A median per revolution", {{46, std::nan("")}}},
    {"lag", {{std::nan(""), -3}}}};
  const auto all = read_own_figures({folder.path(), other.path(), "nowhere"});
  check("figures of cases: as many", all.size() == 3 && all[0].size() == expected.size());
  for (const auto &[name, values] : expected)
    for (unsigned int i = 0; i < 3; ++i)
      {
        const auto   found = std::find_if(all[i].begin(), all[i].end(), [&](const auto &figure) {
          return figure.first == name;
        });
        const double value = found == all[i].end() ? 0. : found->second.value;
        check("case " + std::to_string(i) + ", " + name,
              i < 2 && std::isfinite(values[i]) ? value == values[i] : std::isnan(value));
      }
}

void failed(const OutputFolder &folder)
{
  RunSummary summary    = make_summary();
  summary.status        = "failed";
  summary.failure       = "the energy error is 0.6";
  summary.steady->found = false;
  summary.transmission_error.clear();
  write_summary(folder, summary);
  const RunFigures run = read_run_figures(folder.path());
  check("a failed run says of what",
        run.status == "failed" && run.failure == "the energy error is 0.6");
  for (const auto &named : run.figures)
    {
      if (named.first == "steady")
        check("not steady", named.second.value == 0);
      if (named.first == "web windup")
        check("what it does not have is no number", std::isnan(named.second.value));
    }
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all(folder_name);
  const OutputFolder folder(folder_name, session.world());
  write_summary(folder, make_summary());
  places(folder);
  table_of_runs(folder);
  figures_of_cases(folder);
  failed(folder);
  return 0;
}
