// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Dynamics/start = steady torsional vibration: its motion by an integration in time, and runs that
// begin in it beside runs that begin at rest.
#include "../../parts.h"
#include "../quick_pair.h"

#include <vfife/study/run/deflection_parts.h>
#include <vfife/study/run/steady_swing.h>

#include <filesystem>

using namespace vfife;

constexpr double frequency = 9000., damping = 2000., torque = 8e5;

/** Static transmission error of three orders [rad] at @p time. */
double error_at(const double time)
{
  const double phase = 2. * pi * frequency * time;
  return 1e-6 * (-400. + 3. * std::cos(phase + .4) - 2. * std::sin(2. * phase) +
                 1. * std::cos(3. * phase - 1.));
}

std::vector<double> sample_errors()
{
  std::vector<double> errors;
  for (unsigned int k = 0; k < 16; ++k)
    errors.push_back(error_at(k / (16. * frequency)));
  return errors;
}

/** A steady vibration is where it was after a gear mesh, at speeds below and above the swing's
 * resonance. */
void is_periodic()
{
  for (const double swing_frequency : {1200., 14000.})
    {
      Swing swing;
      swing.inertia            = 6e-1;
      swing.stiffness          = swing.inertia * std::pow(2. * pi * swing_frequency, 2);
      const SwingMotion motion = find_steady_swing(sample_errors(), swing, frequency, damping, 1e8);
      const double      square = swing.stiffness / swing.inertia;
      double            x = error_at(0) + motion.error, v = motion.rate;
      const double      first_x = x, first_v = v;
      const unsigned int n            = 4000;
      const double       step         = 1. / (n * frequency);
      const auto         acceleration = [&](const double time, const double at, const double rate) {
        return -square * (at - error_at(time)) - damping * rate;
      };
      for (unsigned int i = 0; i < n; ++i)
        {
          // Runge-Kutta of fourth order.
          const double t = i * step, h = .5 * step;
          const double v1 = v, a1 = acceleration(t, x, v);
          const double v2 = v + h * a1, a2 = acceleration(t + h, x + h * v1, v2);
          const double v3 = v + h * a2, a3 = acceleration(t + h, x + h * v2, v3);
          const double v4 = v + step * a3, a4 = acceleration(t + step, x + step * v3, v4);
          x += step / 6. * (v1 + 2. * v2 + 2. * v3 + v4);
          v += step / 6. * (a1 + 2. * a2 + 2. * a3 + a4);
        }
      check_below("place after a gear mesh over the vibration", std::abs(x - first_x) / 5e-6, 1e-8);
      check_below("rate", std::abs(v - first_v) / (5e-6 * 2. * pi * frequency), 1e-8);
      check_ratio("flanks have the load and the inertia",
                  (1. - motion.torque) * 1e8 / (swing.stiffness * motion.error),
                  1e-9);
    }
}

/** At the resonance without damping the vibration is bounded by half of the load. */
void is_bounded()
{
  Swing swing;
  swing.inertia            = 6e-1;
  swing.stiffness          = swing.inertia * std::pow(2. * pi * 1.0001 * frequency, 2);
  const SwingMotion motion = find_steady_swing(sample_errors(), swing, frequency, 0., torque);
  check_close("half of the load", std::abs(1. - motion.torque), .5, 1e-12);
  check("at rest nothing swings",
        find_steady_swing(sample_errors(), swing, 0., 0., torque).torque == 1.);
}

/** Largest less least transmission error [arcsec]. */
double ripple_of(const std::string &kind, const std::string &start, Communicator &world)
{
  const std::string name = kind + " " + start;
  std::ofstream("steady_swing.prm") << quick_pair("set body type = conical web", coarse_web, "1e-6")
                                    << "subsection Study\n set kind = " << kind << "\nend\n";
  // From rest it swings to the other side within half a period of 5.8 mesh cycles.
  std::vector<std::string> entries = {"Operation/mesh cycles=3", "Dynamics/start=" + start};
  // Both starts have the same bodies. The swing of 1.5 kHz is far below their cut-off.
  if (kind == "reduced")
    entries.insert(entries.end(), {"Reduced/cutoff frequency=20 kHz", "Reduced/store=bodies"});
  run_pair("steady_swing.prm", name, world, entries);
  const auto  history = read_columns(name + "/history.csv");
  const auto &errors  = history.at("dte");
  const auto  ends    = std::minmax_element(errors.begin(), errors.end());
  return *ends.second - *ends.first;
}

void runs_swing_less(Communicator &world)
{
  for (const char *kind : {"run", "reduced"})
    {
      const std::string still = "static equilibrium", swinging = "steady torsional vibration";
      const double      rest = ripple_of(kind, still, world);
      check_below(std::string(kind) + ": peak to peak over that from rest",
                  ripple_of(kind, swinging, world) / rest,
                  .5);
      const auto times_of = [kind](const std::string &start) {
        return read_columns(kind + (" " + start) + "/history.csv").at("time");
      };
      check(std::string(kind) + ": the same samples", times_of(still) == times_of(swinging));
    }
}

int main(int argc, char **argv)
{
  std::filesystem::remove_all("bodies");
  is_periodic();
  is_bounded();
  run_parts<Communicator>(argc, argv, {runs_swing_less});
  return 0;
}
