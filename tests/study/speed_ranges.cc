// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Where made-up curves over speed are above a level; how long a speed settles, and what is left of
// vibrations above a frequency.
#include "../tests.h"

#include <vfife/base/types.h>
#include <vfife/lumped/speed_sweep.h>
#include <vfife/study/reduced/pair_speed_sweep.h>
#include <vfife/study/reduced/speed_ranges.h>
#include <vfife/study/reduced/speed_response.h>

using namespace vfife;

namespace
{
  void check_range(const std::string &what,
                   const SpeedRange  &range,
                   const double       from,
                   const double       to,
                   const double       largest,
                   const double       at)
  {
    check_close(what + ": from", range.from, from, 1e-12);
    check_close(what + ": to", range.to, to, 1e-12);
    check_close(what + ": largest", range.largest, largest, 0);
    check_close(what + ": at", range.at, at, 0);
  }

  void ranges()
  {
    const std::vector<double> speeds = {100, 200, 300, 400, 500, 600};
    const std::vector<double> curve  = {3, 1, 4, 6, 0, 5};
    const auto                found  = find_ranges_above(speeds, curve, 2);
    check("three", found.size() == 3);
    check_range("from the first speed on", found[0], 100, 150, 3, 100);
    check_range("over two speeds", found[1], 200 + 100. / 3, 400 + 400. / 6, 6, 400);
    check_range("to the last speed", found[2], 540, 600, 5, 600);
    check("none", find_ranges_above(speeds, curve, 6).empty());
    check_range("all", find_ranges_above(speeds, curve, -1).at(0), 100, 600, 6, 400);

    const auto down = find_ranges_above({300, 200, 100}, {0, 4, 0}, 2);
    check_range("falling speeds", down.at(0), 250, 150, 4, 200);
    check("nothing of nothing", find_ranges_above({}, {}, 1).empty());
  }

  LumpedResponse forces(const double mean, const double largest)
  {
    LumpedResponse response;
    response.mean_force    = mean;
    response.largest_force = largest;
    return response;
  }

  /** Each direction and place is a curve of its own. */
  void exceedances()
  {
    Table          resonance = make_resonance_response_table();
    constexpr auto rpm       = pi / 30;
    add_response("up", 1000 * rpm, 27, forces(100, 110), resonance);
    add_response("up", 2000 * rpm, 27, forces(200, 260), resonance);
    add_response("down", 2000 * rpm, 27, forces(200, 210), resonance);
    add_response("down", 1000 * rpm, 27, forces(100, 140), resonance);
    Table stresses = make_stress_response_table();
    for (const double speed : {1000., 2000.})
      {
        stresses.add_row({"up", speed, "web", 50, 55, 1.1});
        stresses.add_row({"up", speed, "root", 50, speed < 1500 ? 70 : 50, speed < 1500 ? 1.4 : 1});
      }
    Table table = make_exceedance_table();
    add_exceedances(resonance, stresses, 1.2, table);
    const auto texts = [&table](const std::string &name) { return table.column(name).texts; };
    check("directions", texts("direction") == std::vector<std::string>({"up", "down", "up"}));
    check("quantities",
          texts("quantity") ==
            std::vector<std::string>({"contact force total", "contact force total", "root"}));
    check_close("force, up: from", table.numbers("from")[0], 1500, 1e-9);
    check_close("force, up: to", table.numbers("to")[0], 2000, 1e-9);
    check_close("force, up: largest", table.numbers("largest amplification")[0], 1.3, 1e-12);
    check_close("force, down: from",
                table.numbers("from")[1],
                2000 - 1000 * (1.2 - 1.05) / (1.4 - 1.05),
                1e-9);
    check_close("force, down: at", table.numbers("at")[1], 1000, 1e-9);
    check_close("root: to", table.numbers("to")[2], 1500, 1e-9);
  }

  void spectra()
  {
    // Mean 7, 3 periods of amplitude 2, 20 of 5.
    std::vector<double> samples, slow;
    for (unsigned int i = 0; i < 100; ++i)
      {
        slow.push_back(7 + 2 * std::sin(2 * pi * 3 * i / 100 + .4));
        samples.push_back(slow.back() + 5 * std::cos(2 * pi * 20 * i / 100));
      }
    const auto distance = [&slow](const std::vector<double> &other) {
      double worst = 0;
      for (std::size_t i = 0; i < slow.size(); ++i)
        worst = largest_of(worst, std::abs(other[i] - slow[i]));
      return worst;
    };
    check_below("without fast vibrations", distance(cut_spectrum(samples, 19)), 1e-12);
    check_close("with them", distance(cut_spectrum(samples, 20)), 5., 1e-12);
    check("all of few samples", cut_spectrum({1, 2, 4}, 1) == std::vector<double>({1, 2, 4}));

    SpeedResponse response(3);
    for (const double sample : samples)
      response.add({0, sample, false, {}, {sample}});
    check_close("largest force", response.response(0).largest_force, 9., 2e-2);
    check_close("largest stress", response.largest_stress(0), 9., 2e-2);

    PairSpeedSweepSetup setup;
    setup.cutoff                 = 60e3;
    setup.reduced.counted_meshes = 10;
    check("below half the cut-off", setup.count_vibrations(7000) == 42);
    setup.options.highest_frequency = 14.1e3;
    check("below the one given", setup.count_vibrations(7000) == 20);
  }

  void settling()
  {
    PairSpeedSweepSetup setup;
    setup.reduced.settling_meshes = 5;
    setup.damping                 = 400;
    check("meshes as they are asked for", setup.find_settling_meshes(9000) == 5);
    // Amplitudes fall to 1/e in 5 ms, 45 meshes of 9 kHz.
    setup.options.settling_decay_times = 3.001;
    check("decay times", setup.find_settling_meshes(9000) == 136);
    check("but no less than the meshes", setup.find_settling_meshes(100) == 5);
  }
} // namespace

int main()
{
  settling();
  spectra();
  ranges();
  exceedances();
}
