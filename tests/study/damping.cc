// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Damping relative to the turning body: decay of a vibration while the body flies on, and the audit
// of a ring whose drag is known.
#include "../model_sections.h"
#include "../refusal.h"
#include "../tests.h"
#include "quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>
#include <vfife/dynamics/dynamics_options.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace vfife;

namespace
{
  /** A free bar in its first longitudinal mode, v = V cos(pi x/L), while it flies across: the
   * energy of the mode falls with exp(-zeta t), the momentum stays. */
  void free_bar(const std::string &damping, Communicator &world)
  {
    constexpr double zeta = 2000;
    auto             run =
      run_text("free_bar",
               "subsection Study\n set kind = run\nend\nsubsection Model\n set bodies = bar\n" +
                 model_text::block("bar",
                                   {{100, 5, 5}},
                                   {{20, 1, 1}},
                                   "set velocity = 0, 3000, 0 mm/s\n"
                                   "set initial velocity x = 1000*cos(pi*x/100)\n") +
                 "end\nsubsection Material steel\n set Poisson's ratio = 0\nend\n"
                 "subsection Dynamics\n" +
                 damping + " set end time = 1 ms\nend\n" + quiet_output(20),
               world);
    const auto  &kinetic = run["relative kinetic energy"], &strain = run["strain energy"];
    const double start = kinetic.front() + strain.front(), end = kinetic.back() + strain.back();
    // Within zeta/omega, 1.2 % of a half period's swing of the loss; omega = pi c/L = 1.6e5 1/s.
    const double time = run["time"].back() - run["time"].front();
    check_close("free bar: logarithm of the energy over -zeta t",
                std::log(end / start) / (-zeta * time),
                1.,
                1e-2);
    check_close("free bar: damping loss over the energy lost",
                run["damping loss"].back() / (start - end),
                1.,
                1e-3);
    check_close("free bar: momentum stays",
                run["momentum y"].back() / run["momentum y"].front(),
                1.,
                1e-12);
  }

  /** What is given twice or in halves. */
  void refusals()
  {
    DynamicsOptions options;
    const auto refuse = [&options] { print_refusal([&options] { options.check("Dynamics"); }); };
    options.damping_ratio = .002;
    refuse();
    options.damping_frequency = 3700;
    check_close("damping by its ratio [1/s]", options.mass_damping(), 4 * pi * 7.4, 1e-11);
    check("damping by its ratio: accepted", message_of([&] { options.check("Dynamics"); }).empty());
    options.damping = 500;
    refuse();
    options                   = DynamicsOptions();
    options.damping_frequency = 3700;
    refuse();
  }

  /** Speed and spin of a ring that drifts along its axis at w while it turns at rate s. */
  struct Drift
  {
    double w, s;
  };

  constexpr double inner = 20, outer = 30, zeta = 2000;
  constexpr double first_w = 60000, first_s = 2000;

  /** Mass mean of |v|/r = sqrt(s^2 + w^2/r^2) of a disc from a to b, by Simpson's rule. */
  double mean_speed_rate(const Drift &drift)
  {
    constexpr unsigned int n   = 200;
    double                 sum = 0;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double r = inner + (outer - inner) * i / n;
        sum += (i == 0 || i == n ? 1.
                : i % 2 == 1     ? 4.
                                 : 2.) *
               std::hypot(drift.s, drift.w / r) * r;
      }
    return sum * (outer - inner) / (3 * n) / ((outer * outer - inner * inner) / 2);
  }

  /** dw/dt = -zeta w, ds/dt = zeta (rate - s): the damper pulls towards the mean speed rate. */
  Drift follow(const double time)
  {
    constexpr unsigned int n  = 1000;
    const double           dt = time / n;
    Drift                  drift{first_w, first_s};
    const auto rate_of_s = [](const Drift &d) { return zeta * (mean_speed_rate(d) - d.s); };
    for (unsigned int i = 0; i < n; ++i)
      {
        // The middle of the step: second order.
        const Drift half{drift.w * std::exp(-zeta * dt / 2), drift.s + dt / 2 * rate_of_s(drift)};
        drift = {drift.w * std::exp(-zeta * dt), drift.s + dt * rate_of_s(half)};
      }
    return drift;
  }

  /** A ring in a bearing that drifts along its axis: rigid, with a drag that is known. */
  void drifting_ring(const std::string &rate, Communicator &world)
  {
    auto run =
      run_text("ring",
               "subsection Study\n set kind = run\nend\nsubsection Model\n set bodies = ring\n" +
                 model_text::ring("ring",
                                  {{inner, outer, 2}},
                                  {{10, 72, 1}},
                                  "set bearing = yes\nset speed = 2000 rad/s\n"
                                  "set initial velocity z = 60000\n") +
                 // The ring breathes: what its spin is at the end hangs on the steps.
                 "end\nsubsection Dynamics\n set damping = 2000\n set end time = 0.2 ms\n"
                 " set step bound = element\n"
                 " set damping rate = " +
                 rate + "\nend\n" + quiet_output(20),
               world);
    const double time = run["time"].back() - run["time"].front();
    // The drift decays whichever rate the damper follows.
    check_close("drifting ring, " + rate + ": drift over V exp(-zeta t)",
                run["momentum z"].back() / run["momentum z"].front() / std::exp(-zeta * time),
                1.,
                1e-3);

    std::ifstream file("ring/summary.json");
    const auto    audit = nlohmann::json::parse(file).at("damping audit").at(0);
    const auto   value = [&](const char *name) { return audit.at(name).at("value").get<double>(); };
    const double rpm   = pi / 30;
    const Drift  end   = follow(time);
    const bool   mean_speed = rate == "mean speed";

    // M w^2/2 of the drift is lost, and the damper that follows a faster rate drives the spin.
    const double mass   = run["momentum z"].front() / first_w; // N s over mm/s: t
    const double lost   = mass * (first_w * first_w - end.w * end.w) / 2;
    const double gained = mean_speed ? run["angular momentum z"].back() * end.s / 2 -
                                         run["angular momentum z"].front() * first_s / 2
                                     : 0.;
    check_close("drifting ring, " + rate + ": power of the damping over that of the drag [-]",
                value("power") * 1e3 * time / (lost - gained),
                1.,
                2e-2);
    // The ring, which is not preloaded, grows by rho s^2 r^2/E and slows down a little by itself; a
    // damper that follows the momentum leaves its angular momentum alone.
    const double growth = run["angular momentum z"].back() / run["angular momentum z"].front();
    check_close("drifting ring, " + rate + ": angular momentum over that at the start",
                growth,
                end.s / first_s * (mean_speed ? 1. : first_s / end.s),
                mean_speed ? 1e-3 * (end.s / first_s - 1) + 1e-6 : 1e-12);
    // Torque times time is what the angular momentum has gained; it drives in the sense of the
    // spin.
    const double first_momentum = run["angular momentum z"].front(),
                 last_momentum  = run["angular momentum z"].back();
    check_close("drifting ring, " + rate + ": torque of the damping over the gain of momentum",
                1e3 * value("net torque") * time -
                  (mean_speed ? (last_momentum - first_momentum) : 0.),
                0.,
                1e-2 * first_momentum * (follow(time).s / first_s - 1));
    // Mean over the samples; the ring that is not driven keeps its spin.
    double difference = 0;
    for (const double t : run["time"])
      {
        Drift now = follow(t);
        if (!mean_speed)
          now.s = first_s;
        difference += (mean_speed_rate(now) - now.s) / run["time"].size();
      }
    check_close("drifting ring, " + rate + ": mean speed rate over the momentum's rate",
                value("mean speed rate minus momentum rate") * rpm / difference,
                1.,
                1e-2);
    check_close("drifting ring, " + rate + ": spin drift over the momentum's [rpm]",
                value("spin drift") - (growth - 1) * first_s / rpm,
                0.,
                10.);
  }
} // namespace

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  free_bar(" set damping = 2000\n", session.world());
  // zeta = 4 pi f ratio at any frequency.
  std::ostringstream percent;
  percent.precision(17);
  percent << 1e2 * 2000 / (4 * pi * 3700);
  free_bar(" set damping ratio = " + percent.str() + " %\n set damping frequency = 3.7 kHz\n",
           session.world());
  refusals();
  drifting_ring("momentum", session.world());
  drifting_ring("mean speed", session.world());
  return 0;
}
