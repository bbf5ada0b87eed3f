// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The steady part of synthetic histories: means, where it starts, and when there is none.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/contact/contact_impulse.h>
#include <vfife/output/measures/steady_part.h>

#include <functional>
#include <limits>

using namespace vfife;

constexpr double mesh_period = 1. / 9000.;

/** History of @p n_meshes; @p force and @p dte are functions of the time in mesh cycles. */
Table make_history(const double                               n_meshes,
                   const double                               samples_per_mesh,
                   const std::function<double(const double)> &force,
                   const std::function<double(const double)> &dte)
{
  Table table;
  table.add_column("time", "s");
  table.add_column("contact force total", "N");
  table.add_column("dte", "arcsec");
  for (unsigned int i = 0; i <= n_meshes * samples_per_mesh + 1e-6; ++i)
    {
      const double t = i / samples_per_mesh;
      table.add_row({t * mesh_period, force(t), dte(t)});
    }
  return table;
}

double constant_dte(const double)
{
  return -35.;
}

void check_means()
{
  const auto force = [](const double t) { return 9000 + 300 * std::sin(2 * pi * t + 0.3); };
  const auto dte   = [](const double t) { return -35 + 2 * std::cos(4 * pi * t); };
  // 50 samples a cycle: the trapezoidal rule is exact for harmonics below 25 but for round-off.
  const SteadyPart part = find_steady_part(make_history(20.4, 50, force, dte), 50, 1, 0);
  check("harmonics: found", part.found);
  check("harmonics: begins at the first row", part.first_row == 0 && part.start_time == 0);
  check("harmonics: whole cycles only", part.cycles == 20 && part.end_row == 1001);
  check_close("harmonics: mean force", part.column("contact force total").mean, 9000, 1e-8);
  check_close("harmonics: mean dte", part.column("dte").mean, -35, 1e-10);
  check_close("harmonics: standard deviation",
              part.column("contact force total").standard_deviation,
              300 / std::sqrt(2.),
              1e-8);
  // The crest lies between samples: 1 - cos(pi/50) of the amplitude at most is missed on each
  // side.
  check_close("harmonics: peak to peak",
              part.column("contact force total").peak_to_peak,
              600,
              600 * 0.002);
  check("columns have units",
        part.column("dte").unit == "arcsec" && part.columns.front().name != "time");

  // No whole number of samples in a mesh: only the two ends are interpolated, error (2
  // pi/50.3)^2/12 of a sample's share.
  const SteadyPart uneven = find_steady_part(make_history(20.4, 50.3, force, dte), 50.3, 1, 0);
  check("uneven samples: found, 20 cycles", uneven.found && uneven.cycles == 20);
  check_close("uneven samples: mean force",
              uneven.column("contact force total").mean,
              9000,
              300 * 1e-4);
}

/** An order that has a whole period from sample to sample falls on the samples' mean, not on
 * that of the steps between them. */
void check_impulse()
{
  constexpr unsigned int samples = 50, steps = 8; // of a mesh, of a sample
  const auto             force = [](const double t) {
    return 9000 + 300 * std::cos(2 * pi * samples * t) + 100 * std::sin(2 * pi * t);
  };
  for (const std::size_t first_known : {0, 500})
    {
      Table history;
      history.add_column("time", "s");
      history.add_column("contact force total", "N");
      history.add_column("dte", "arcsec");
      history.add_column("impulse of contact force total", "N s");
      ContactImpulse impulse;
      for (unsigned int step = 0; step <= 20 * samples * steps; ++step)
        {
          const double t = step / double(samples * steps);
          impulse.add(mesh_period / (samples * steps), force(t), 0);
          if (step % steps == 0)
            history.add_row({t * mesh_period,
                             force(t),
                             constant_dte(t),
                             step / steps < first_known ? not_known : impulse.force});
        }
      const SteadyPart        part     = find_steady_part(history, samples, 1, 0);
      const ColumnStatistics &of_force = part.column("contact force total");
      check_close(first_known == 0 ? "impulse: mean of all steps"
                                   : "impulse of the end alone: mean of the samples",
                  of_force.mean,
                  first_known == 0 ? 9000 : 9300,
                  1e-6);
      check_close("impulse: deviation of the samples from their mean",
                  of_force.standard_deviation,
                  100 / std::sqrt(2.),
                  1e-6);
      check("impulse: no quantity of its own", part.columns.size() == 2);
    }
}

void check_start()
{
  // Mean over k..k+P of A + B exp(-t/tau): A + B w exp(-k/tau), w = tau/P (1 - exp(-P/tau)).
  const double A = 9000, B = 4000, tau = 5;
  const int    period = 4;
  const auto   force  = [=](const double t) {
    return A + B * std::exp(-t / tau) + 5000 * std::sin(2 * pi * t);
  };
  const double w     = tau / period * (1 - std::exp(-period / tau));
  unsigned int first = 0;
  while (true)
    {
      const double before = A + B * w * std::exp(-(first + 0.) / tau);
      const double after  = A + B * w * std::exp(-(first + period + 0.) / tau);
      if (std::abs(after - before) < 0.01 * after)
        break;
      ++first;
    }
  const Table      history = make_history(60, 40, force, constant_dte);
  const SteadyPart part    = find_steady_part(history, 40, 3.2, 0);
  check("decay: swing period in whole meshes", part.period == 4);
  check("decay: found", part.found);
  check_close("decay: start cycle", part.start_time / mesh_period, first, 1e-9);
  check("decay: not from the first cycle", first > 3);
  check_below("decay: largest change", part.largest_change, 0.01);

  const double     ramp  = 23.4 * mesh_period;
  const SteadyPart after = find_steady_part(history, 40, 3.2, ramp);
  check_close("ramp: first whole cycle after it", after.start_time / mesh_period, 24, 1e-9);

  // The dte is judged too.
  const auto       drift = [](const double t) { return -10 - t; };
  const SteadyPart none  = find_steady_part(make_history(
                                             60, 40, [](double) { return 9000.; }, drift),
                                           40,
                                           3.2,
                                           0);
  check("drifting dte: none", !none.found);
}

void check_none()
{
  const auto       growing = [](const double t) { return 1000 * std::exp(0.1 * t); };
  const SteadyPart none = find_steady_part(make_history(30, 20, growing, constant_dte), 20, 2, 0);
  check("growth: none", !none.found);
  check("growth: last third", none.cycles == 10 && none.first_row == 400 && none.end_row == 601);
  check("growth: said so", none.explain().rfind("no steady part", 0) == 0);
  check_close("growth: change of the last pair", none.largest_change, 1 - std::exp(-0.2), 1e-3);

  // Stationary for a moment at mesh 10, then away: a chance agreement is no steady part.
  const auto parabola = [](const double t) { return 9000 + 30 * (t - 10) * (t - 10); };
  check("passing stationary point: none",
        !find_steady_part(make_history(40, 20, parabola, constant_dte), 20, 2, 0).found);

  const auto zero = [](double) { return 0.; };
  check("lost contact: none",
        !find_steady_part(make_history(30, 20, zero, constant_dte), 20, 2, 0).found);
  const auto exploded = [](const double t) {
    return t < 25 ? 9000. : std::numeric_limits<double>::quiet_NaN();
  };
  check("not a number: none",
        !find_steady_part(make_history(30, 20, exploded, constant_dte), 20, 2, 0).found);

  const auto       flat  = [](double) { return 9000.; };
  const SteadyPart brief = find_steady_part(make_history(3, 20, flat, constant_dte), 20, 13, 0);
  check("shorter than two periods: none", !brief.found && brief.cycles == 1);
  check("shorter than a period: said so",
        has_text(brief.explain(), "less than one period (13 mesh cycles) of the torsional mode"));

  // A period of 13 meshes in a record of 20: the swing shows in the means of the cycles.
  const auto swinging = [](const double size) {
    return [size](const double t) { return -50 * (1 + size * std::cos(2 * pi * t / 13)); };
  };
  const auto short_part = [&](const double size) {
    return find_steady_part(make_history(20, 40, flat, swinging(size)), 40, 12.6, 0);
  };
  const SteadyPart calm = short_part(0.004), loud = short_part(0.006);
  check("between one and two periods: a small swing is steady",
        calm.found && calm.by_cycles && calm.cycles == 20);
  check("between one and two periods: a large one is not", !loud.found && loud.by_cycles);
  check("between one and two periods: said so",
        has_text(loud.explain(), "fewer than two periods (13 mesh cycles each)"));
  // Means over a cycle are sin(pi/13)/(pi/13) of the swing in its middle; one cycle has its
  // middle in the trough, the best two at pi/13 from the crest. The trapezoidal rule with 40
  // samples adds (pi/260)^2/3 of the swing.
  check_close("between one and two periods: crest to trough",
              loud.largest_change,
              0.006 * std::sin(pi / 13) / (pi / 13) * (1 + std::cos(pi / 13)),
              0.012 * 1e-4);

  const SteadyPart tiny = find_steady_part(make_history(0.5, 20, flat, constant_dte), 20, 1, 0);
  check("shorter than a mesh: rows of the last third",
        !tiny.found && tiny.cycles == 0 && tiny.first_row == 7);
  check_close("shorter than a mesh: mean", tiny.column("contact force total").mean, 9000, 1e-9);
  check("ramp longer than the run: none",
        !find_steady_part(make_history(30, 20, flat, constant_dte), 20, 2, 1e9).found);

  check("no samples per mesh: refused",
        refuses([&] { find_steady_part(make_history(30, 20, flat, constant_dte), 0, 2, 0); }));
}

void check_ripple()
{
  // Means are those of every mesh; what ripples about them is not the same everywhere.
  const auto flat = [](double) { return 9000.; };
  const auto find = [&flat](const std::function<double(const double)> &ripple) {
    return find_steady_part(
      make_history(14, 50, flat, [&](const double t) { return -270 + ripple(t); }), 50, 1, 0);
  };
  const SteadyPart even = find([](const double t) { return 4 * std::sin(2 * pi * t); });
  check("even ripple: steady from the start",
        even.found && even.ripple.steady && even.start_time == 0);
  check("even ripple: said so", even.explain().rfind("steady from", 0) == 0);

  // 3.2 to 8.8 peak to peak over 14 meshes: each half ends at its largest crest.
  const auto       growth = [](const double t) { return 1.6 * std::pow(2.75, t / 14); };
  const SteadyPart grows  = find([&](const double t) { return growth(t) * std::sin(2 * pi * t); });
  check("growing ripple: the means are steady", grows.found);
  check("growing ripple: it is not", grows.ripple.judged && !grows.ripple.steady);
  check("growing ripple: figures stay those of the whole part", grows.start_time == 0);
  const RippleChange &dte = grows.ripple.columns.back();
  check("growing ripple: of the dte", dte.name == "dte" && dte.unit == "arcsec");
  // Crest at t = 0.25 and trough at 0.75 of a mesh, to the second order of the growth in it.
  check_close("growing ripple: first half", dte.peak_to_peak_before, 2 * growth(6.5), .01);
  check_close("growing ripple: second half", dte.peak_to_peak_after, 2 * growth(13.5), .02);
  check_close("growing ripple: change", dte.change, 1 - std::pow(2.75, -.5), 1e-3);
  check("growing ripple: said so",
        grows.explain().rfind("means steady from", 0) == 0 &&
          has_text(grows.explain(), "The ripple is still transient"));
  // Forces of thousands are no powers of ten.
  Ripple of_forces  = grows.ripple;
  of_forces.columns = {{"contact force total", "N", 1829.4, 1834.2, .0339}};
  check(
    "forces as one reads them",
    has_text(
      of_forces.explain(),
      "contact force total has 1829 N peak to peak in the first half and 1834 N in the second"));
  check("shrinking ripple: neither is it",
        !find([&](const double t) { return growth(14 - t) * std::sin(2 * pi * t); }).ripple.steady);

  // As high all along, with the mesh and in the last two meshes twice a mesh: amplitudes of the
  // second half are 5/7 and 2/7 of it.
  const SteadyPart other =
    find([](const double t) { return 4 * std::sin((t < 12 ? 2 : 4) * pi * t); });
  check("other harmonics: not steady", !other.ripple.steady && other.start_time == 0);
  check_close("other harmonics: change", other.ripple.columns.back().change, 2. / 7, .01);

  // What the start leaves behind dies out: steady once it has.
  const SteadyPart settled =
    find([](const double t) { return (4 + 8 * std::exp(-2 * t)) * std::sin(2 * pi * t); });
  check("ripple of the start: steady later on",
        settled.ripple.steady && settled.start_time > 0 && settled.cycles >= 7);

  check("ripple of round-off: none", find([](const double t) {
                                       return t < 7 ? 0. : 1e-9 * std::sin(2 * pi * t);
                                     }).ripple.steady);
  const SteadyPart tiny = find_steady_part(make_history(1.5, 20, flat, constant_dte), 20, 1, 0);
  check("a single mesh: not judged", !tiny.ripple.judged && !tiny.ripple.steady);
  const SteadyPart exploded =
    find_steady_part(make_history(30,
                                  20,
                                  flat,
                                  [](const double t) {
                                    return t < 25 ? -35. : std::numeric_limits<double>::quiet_NaN();
                                  }),
                     20,
                     2,
                     0);
  check("not a number: not steady", exploded.ripple.judged && !exploded.ripple.steady);
}

int main()
{
  return run_parts({check_means, check_impulse, check_start, check_none, check_ripple});
}
