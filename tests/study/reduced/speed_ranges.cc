// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Where made-up curves over speed are above a level; how long a speed settles; what a low pass
// leaves of known vibrations, and what passes the sectors of a body with the mesh cycle.
#include "../../parts.h"
#include "../../tests.h"

#include <vfife/base/process/log.h>
#include <vfife/base/types.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/lumped/speed_sweep.h>
#include <vfife/study/cases/run_length.h>
#include <vfife/study/reduced/low_pass.h>
#include <vfife/study/reduced/pair_speed_sweep.h>
#include <vfife/study/reduced/slow_mesh.h>
#include <vfife/study/reduced/speed_ranges.h>
#include <vfife/study/reduced/speed_response.h>

using namespace vfife;

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

/** What is left of the samples that @p value says. */
std::vector<double>
pass(LowPass low_pass, const unsigned int n, const std::function<double(int)> &value)
{
  std::vector<double> left;
  for (unsigned int i = 0; i < n; ++i)
    if (const auto slow = low_pass.add(Eigen::VectorXd::Constant(1, value(i))))
      left.push_back((*slow)[0]);
  return left;
}

void low_pass()
{
  const double  frequency = .1;
  const LowPass filter(frequency);
  check("three periods on both sides", filter.reach() == 30);
  const auto amplitude_and_change = [&](const double of_frequency) {
    const auto value = [&](const int i) {
      return std::cos(2 * pi * of_frequency * frequency * i + .4);
    };
    const std::vector<double> left  = pass(filter, 200, value);
    double                    worst = 0, squares = 0;
    for (std::size_t i = 0; i < left.size(); ++i)
      {
        squares += left[i] * left[i];
        raise_to(worst, std::abs(left[i] - value(i + filter.reach())));
      }
    return std::make_pair(std::sqrt(2. * squares / left.size()), worst);
  };
  for (const double part : {.1, .3, .5, .6})
    check_below("below: not changed, nor later", amplitude_and_change(part).second, 1e-2);
  check_close("half of it at the frequency", amplitude_and_change(1.).first, .5, 1e-2);
  for (const double part : {1.4, 2., 3.3, 5.})
    check_below("above: gone", amplitude_and_change(part).first, 1e-2);
  const std::vector<double> line  = pass(filter, 100, [](const int i) { return 7. + 3. * i; });
  double                    worst = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    raise_to(worst, std::abs(line[i] - (7. + 3. * (i + 30.))));
  check("samples with enough of them around", line.size() == 40);
  check_below("a straight line as it is", worst, 1e-11);
  check("all of few samples", pass(LowPass(.5), 3, [](const int i) {
                                return double(i);
                              }) == std::vector<double>({0, 1, 2}));
}

void slow_mesh()
{
  // Of four sectors, the pulse that passes them from one to the next in a mesh.
  const auto pulse = [](const double meshes) {
    Eigen::MatrixXd sectors(4, 1);
    for (unsigned int k = 0; k < 4; ++k)
      sectors(k, 0) = std::cos(.5 * pi * (k + meshes));
    return sectors;
  };
  SlowMesh mesh(1), backwards(-1);
  for (unsigned int i = 0; i <= 200; ++i)
    {
      mesh.add(pulse(i / 200.));
      backwards.add(pulse(-(i / 200.)));
    }
  double worst = 0;
  for (const double at : {-5.25, -1., 0., .5, 1., 2.375, 7.1})
    {
      raise_to(worst, (mesh.at(at) - pulse(at)).norm());
      raise_to(worst, (backwards.at(at) - pulse(-at)).norm());
    }
  check_below("a pulse passes the sectors", worst, 1e-4);
}

void responses()
{
  // Of the force: mean 7, slow amplitude 2, fast 5. Of stresses: slow ones that are known, where
  // fast ones belong to them, and vibrations.
  const LowPass filter(.05);
  SpeedResponse response(filter, [](const Eigen::MatrixXd &stresses) {
    return std::vector<double>({stresses.maxCoeff(), stresses(0, 0)});
  });
  check("samples around those that count", response.n_around() == 60);
  const auto slow = [](const int i) { return 2 * std::sin(2 * pi * .02 * i + .4); };
  const auto fast = [](const int i) { return 5 * std::cos(2 * pi * .2 * i); };
  for (int i = 0; i < 200 + 2 * 60; ++i)
    {
      SpeedSample sample;
      sample.error               = i + 3. * fast(i);
      sample.coast               = i < 160;
      sample.force               = i == 70 ? 0. : 7. + slow(i) + fast(i);
      sample.waves               = {Complex(0., i)};
      sample.slow_stresses       = Eigen::MatrixXd::Constant(2, 1, fast(i));
      sample.slow_stresses(0, 0) = 0;
      sample.vibration           = Eigen::MatrixXd::Constant(2, 1, slow(i) + fast(i));
      response.add(sample);
    }
  const LumpedResponse found = response.response(0);
  check_close("those around do not count", found.mean_error, .5 * (60 + 259), 1e-2);
  check_close("transmission errors without fast ones", found.pp_error, 199., .5);
  check_close("teeth on the other side", found.time_coast, .5, 1e-12);
  check("contact lost once, with all vibrations", found.losses == 1);
  check_close("time without contact", found.time_apart, 1. / 200, 1e-12);
  check_close("waves move with the samples", response.wave(1).second, 99.5, 1e-12);
  check_close("largest force", found.largest_force, 9., 1e-1);
  check_close("slow stresses with all they have", response.largest_stress(0), 7., 1e-1);
  check_close("vibrations without fast ones", response.largest_stress(1), 2., 1e-2);
}

void frequencies()
{
  PairSpeedSweepSetup setup;
  setup.cutoff  = 60e3;
  setup.samples = 25;
  check_close("half the cut-off", setup.highest_frequency(), 30e3, 0);
  setup.options.highest_frequency = 14e3;
  check_close("the one given", setup.highest_frequency(), 14e3, 0);
  check("four samples a period", setup.find_stride(500., 900) == 6);
  check("no fewer than a history", setup.find_stride(9000., 100) == 4);
  check("no more than steps", setup.find_stride(100., 50) == 1);
}

/** A resonance with mesh order k is zeta/(k z) wide: 1000 1/s, 19 teeth, 502.6, 251.3 and 167.5
 * rpm of the orders 1 to 3. */
void widths()
{
  constexpr double    rpm = pi / 30;
  PairSpeedSweepSetup setup;
  setup.damping             = 1000;
  setup.speeds.lowest_speed = 2000 * rpm;
  check_close("width with order 2 [rpm]", setup.resonance_width(2, 19) / rpm, 251.3, .1);
  setup.speeds.highest_speed = 9450 * rpm;
  setup.speeds.n_speeds      = 8;
  const std::string wide     = setup.find_wide_steps(19);
  check("1064 rpm apart: said",
        wide.find("the speeds are 1064 rpm apart") == 0 &&
          has_text(wide, "502.6 rpm with mesh order 1") && has_text(wide, "Reduced/speeds = 46"));
  setup.speeds.n_speeds = 46;
  check("46 speeds: nothing is said", setup.find_wide_steps(19).empty());
  setup.damping = 0;
  check("no damping, no width",
        has_text(setup.find_wide_steps(19), "without damping, which is zero"));
}

/** Of an error of 3 cos(2 p) + 0.5 cos(8 p) + 2 cos(12 p) arcsec over the phase p of the mesh. */
void near_the_cutoff()
{
  std::vector<double> errors;
  for (unsigned int i = 0; i < 4 * 50; ++i)
    {
      const double phase = 2 * pi * i / 50;
      errors.push_back(3 * std::cos(2 * phase) + .5 * std::cos(8 * phase) +
                       2 * std::cos(12 * phase + .3));
    }
  const MeshOrderContent all = find_strongest_order(errors, 50, 1);
  check("strongest order", all.order == 2);
  check_close("its peak to peak", all.peak_to_peak, 6., 1e-12);
  check("strongest from the ninth on", find_strongest_order(errors, 50, 9).order == 12);
  const auto told = [&](const double cutoff) {
    NearCutoff near(cutoff);
    near.look(errors, 50, 3000., 9450., 10.);
    std::ostringstream screen;
    Log                log(screen, true);
    NamedFigures       figures;
    near.tell(figures, log);
    return std::make_pair(screen.str(), figures);
  };
  // Half of 60 kHz is the tenth order of 3 kHz, half of 75 kHz lies beyond the twelfth.
  const auto near = told(60e3);
  check("above half the cut-off: said",
        has_text(near.first, "mesh order 12 (36000 Hz at 9450 rpm) has 4 arcsec") &&
          has_text(near.first, "Reduced/cutoff frequency = 108 kHz"));
  check("and among the figures",
        near.second.size() == 2 && near.second[0].second.value == 12 &&
          std::abs(near.second[1].second.value - 4) < 1e-12);
  check("below it nothing is said", told(75e3).first.empty() && told(75e3).second.empty());
}

/** What falls as exp(-500 t) is a tenth after 4.605 ms, 13.1 mesh cycles of 2850 Hz. */
void lengths()
{
  DynamicsOptions dynamics;
  dynamics.damping      = 1000;
  dynamics.mesh_damping = 2000;
  check("twice fourteen mesh cycles", count_steady_meshes(2850, 3.2, dynamics) == 28);
  check("or two swing periods behind them", count_steady_meshes(2850, 9.5, dynamics) == 14 + 20);
  dynamics.damping = 4000;
  check("the slower one counts", count_steady_meshes(2850, 3.2, dynamics) == 7 + 8);
  dynamics.damping = dynamics.mesh_damping = 0;
  check("never without damping", count_steady_meshes(2850, 3.2, dynamics) == 0);
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

int main()
{
  return run_parts({settling,
                    widths,
                    near_the_cutoff,
                    lengths,
                    low_pass,
                    slow_mesh,
                    responses,
                    frequencies,
                    ranges,
                    exceedances});
}
