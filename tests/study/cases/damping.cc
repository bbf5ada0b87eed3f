// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Damping relative to the turning body: decay of a vibration while the body flies on, and the audit
// of a ring whose drag is known.
#include "../../read_files.h"
#include "../../refusal.h"
#include "../quick_pair.h"
#include "../short_rotor.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/base/types.h>
#include <vfife/dynamics/dynamics_options.h>

using namespace vfife;

/** A bar in its first longitudinal mode, v = V cos(pi x/L), while it flies along @p flight: the
 * energy of the mode falls with exp(-zeta t), the momentum stays. Free, or led along itself. */
void flying_bar(const std::string &name,
                const std::string &flight,
                const std::string &guide,
                const std::string &damping,
                Communicator      &world)
{
  constexpr double  zeta = 2000;
  const std::string along(1, flight[0]);
  auto              run     = run_text("flying_bar",
                      model_text::study("run") + "subsection Model\n set bodies = bar\n" +
                        model_text::block("bar",
                                          {{100, 5, 5}},
                                          {{20, 1, 1}},
                                          "set velocity = " + flight.substr(2) +
                                            "\nset initial velocity x = 1000*cos(pi*x/100)\n") +
                        guide + "end\n" + model_text::no_contraction() + "subsection Dynamics\n" +
                        damping + " set end time = 1 ms\nend\n" + quiet_output(20),
                      world);
  const auto       &kinetic = run["relative kinetic energy"], &strain = run["strain energy"];
  const double      start = kinetic.front() + strain.front(), end = kinetic.back() + strain.back();
  // Within zeta/omega, 1.2 % of a half period's swing of the loss; omega = pi c/L = 1.6e5 1/s.
  const double time = run["time"].back() - run["time"].front();
  check_ratio(name + ": logarithm of the energy over -zeta t",
              std::log(end / start) / (-zeta * time),
              1e-2);
  check_ratio(name + ": damping loss over the energy lost",
              run["damping loss"].back() / (start - end),
              1e-3);
  check_ratio(name + ": momentum stays",
              run["momentum " + along].back() / run["momentum " + along].front(),
              guide.empty() ? 1e-12 : 1e-10);
}

/** ln(E/E_0)/(-zeta t) of an energy @p less what flies on with it [mJ], and what of that energy
 * the dampers have not lost. */
std::pair<double, double> decay_of(Columns &run, const double rate, const double less = 0)
{
  const auto energy = [&](const std::size_t i) {
    return run["kinetic energy"][i] + run["strain energy"][i] - less;
  };
  const double start = energy(0), end = energy(run["time"].size() - 1);
  return {std::log(end / start) / (-rate * (run["time"].back() - run["time"].front())),
          run["damping loss"].back() / (start - end)};
}

/** A clamped beam let go in its lowest motion: its ratio is the one that is given. Five periods,
 * over which what the loss swings by is nothing. */
void clamped_beam(Communicator &world)
{
  constexpr double frequency = 809.4, ratio = .02;
  auto             run     = run_text("clamped_beam",
                      model_text::study("run") +
                        "subsection Model\n set bodies = beam\n"
                                        " set constraints = clamp\n" +
                        model_text::block("beam",
                                          {{100, 5, 10}},
                                          {{20, 1, 2}},
                                          "set initial velocity z = 1000*(x/100)^2\n") +
                        model_text::section("Constraint clamp", "set nodes = x-\n") +
                        "end\nsubsection Material steel\n set Young's modulus = 200000\n"
                                        " set Poisson's ratio = 0\nend\n"
                                        "subsection Dynamics\n set damping ratio = 0.02\n"
                                        " set damping frequency = 809.4\n set end time = " +
                        std::to_string(5 / frequency) + "\nend\n" + quiet_output(20),
                      world);
  const auto [decay, loss] = decay_of(run, 4 * pi * frequency * ratio);
  check_ratio("clamped beam: decay over that of its ratio", decay, 1e-2);
  check_ratio("clamped beam: damping loss over the energy lost", loss, 1e-3);
}

/** A block on springs along x that flies across: the bounce decays, the flight stays. */
void sprung_block(Communicator &world)
{
  constexpr double zeta = 1000, k = 1000, across = 500;
  const double     mass = 7.85e-9 * 1000, omega = std::sqrt(k / mass);
  auto             run =
    run_text("sprung_block",
             model_text::study("run") +
               "subsection Model\n set bodies = block\n"
               " set constraints = bed\n" +
               model_text::block(
                 "block", {{10, 10, 10}}, {{2, 2, 2}}, "set velocity = 1000, 500, 0 mm/s\n") +
               model_text::section("Constraint bed",
                                   "set kind = spring\nset nodes = all\n"
                                   "set stiffness = 1000, 0, 0 N/mm\n") +
               "end\nsubsection Dynamics\n set mass proportional damping = 1000\n set end time = " +
               std::to_string(4 * pi / omega) + "\nend\n" + quiet_output(1),
             world);
  const auto [decay, loss] = decay_of(run, zeta, .5 * mass * across * across);
  check_ratio("sprung block: decay of the bounce", decay, 1e-2);
  check_ratio("sprung block: damping loss over the energy lost", loss, 1e-3);
  check_ratio("sprung block: momentum across stays",
              run["momentum y"].back() / run["momentum y"].front(),
              1e-12);
}

/** A cylinder on bearings, at rest and far above its critical speed: to and fro it decays as a
 * point mass does, as the modal analysis says. */
void shaft_on_bearings(Communicator &world)
{
  constexpr double zeta = 200;
  const auto       text = [&](const std::string &kind, const std::string &speed) {
    return rotor_text::cylinder(kind,
                                "left, right",
                                "set initial velocity y = 40\nset rotational speed = " + speed +
                                  " rad/s\n",
                                "",
                                "end\nsubsection Dynamics\nset start = static equilibrium\n"
                                      "set end time = 8 ms\nset mass proportional damping = 200\nend\n");
  };
  for (const std::string speed : {"0", "2000"})
    {
      auto        run       = run_text("shaft", text("run", speed) + quiet_output(20), world);
      double      amplitude = 0;
      const auto &time      = run["time"];
      // The largest of the last quarter against that of the first, with the decay between.
      double first = 0;
      for (std::size_t i = 0; i < time.size(); ++i)
        {
          const double way =
            std::exp(.5 * zeta * time[i]) *
            std::hypot(.5 * (run["top displacement x"][i] + run["bottom displacement x"][i]),
                       .5 * (run["top displacement y"][i] + run["bottom displacement y"][i]));
          double &largest = time[i] < 2.2e-3 ? first : amplitude;
          if (time[i] < 2.2e-3 || time[i] > 5.8e-3)
            raise_to(largest, way);
        }
      check_ratio("shaft at " + speed + " rad/s: amplitude times exp(zeta t/2), end over begin",
                  amplitude / first,
                  1e-2);
      const double rpm = std::stod(speed) * 30 / pi;
      std::ofstream("shaft_modes.prm")
        << text("modal", speed) << "subsection Fem\n set modes = 5\n set linear solver = direct\n"
        << " set coriolis = yes\n set speeds = " << rpm << " rpm\nend\n"
        << quiet_output(1);
      run_pair("shaft_modes.prm", "shaft_modes", world);
      auto   modes = read_columns("shaft_modes/modes.csv");
      double best  = 1;
      for (std::size_t i = 0; i < modes["frequency"].size(); ++i)
        if (modes["frequency"][i] > 0)
          {
            const double decay = modes["damping ratio"][i] * 2 * pi * modes["frequency"][i];
            best               = std::min(best, std::abs(decay / (.5 * zeta) - 1));
          }
      check_below("shaft at " + speed + " rad/s: decay of its modes less zeta/2, over it",
                  best,
                  2e-2);
    }
}

/** A ring in a bearing that nothing holds: it turns and flies on. */
void loose_ring(Communicator &world)
{
  auto run =
    run_text("loose_ring",
             model_text::study("run") + "subsection Model\n set bodies = ring\n" +
               model_text::ring("ring",
                                {{20, 30, 5}},
                                {{2, 24, 1}},
                                "set rotating = yes\nset rotational speed = 2000 rad/s\n"
                                "set initial velocity y = 10\n") +
               "end\nsubsection Dynamics\n set mass proportional damping = 2000\n set end time = "
               "5 ms\nend\n" +
               quiet_output(100),
             world);
  check_ratio("loose ring: momentum stays",
              run["momentum y"].back() / run["momentum y"].front(),
              1e-9);
  check_below("loose ring: momentum across over it",
              std::abs(run["momentum x"].back()) / run["momentum y"].front(),
              1e-9);
  check_ratio("loose ring: angular momentum stays",
              run["angular momentum z"].back() / run["angular momentum z"].front(),
              1e-9);
}

/** What is given twice or in halves. */
void refusals()
{
  DynamicsOptions options;
  const auto      refuse = [&options] { print_refusal([&options] { options.check("Dynamics"); }); };
  options.damping_ratio  = .002;
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
      sum += (i == 0 || i == n ? 1. : i % 2 == 1 ? 4. : 2.) * std::hypot(drift.s, drift.w / r) * r;
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
  auto run = run_text(
    "ring",
    model_text::study("run") +
      "subsection Model\n set bodies = ring\n"
      " set constraints = journal, bed\n" +
      model_text::ring("ring",
                       {{inner, outer, 2}},
                       {{10, 72, 1}},
                       "set rotating = yes\nset rotational speed = 2000 rad/s\n"
                       "set initial velocity z = 60000\n") +
      model_text::section("Constraint journal",
                          "set kind = displacement\nset nodes = inner\n"
                          "set directions = r\n") +
      // Opposed, though hardly: the drift is damped.
      model_text::section("Constraint bed",
                          "set kind = spring\nset nodes = all\n"
                          "set stiffness = 0, 0, 1e-6 N/mm\n") +
      // The ring breathes: what its spin is at the end hangs on the steps.
      "end\nsubsection Dynamics\n set mass proportional damping = 2000\n set end time = 0.2 ms\n"
      " set time step estimate = element\n"
      " set damping reference = " +
      rate + "\nend\n" + quiet_output(20),
    world);
  const double time = run["time"].back() - run["time"].front();
  // The drift decays whichever rate the damper follows.
  check_ratio("drifting ring, " + rate + ": drift over V exp(-zeta t)",
              run["momentum z"].back() / run["momentum z"].front() / std::exp(-zeta * time),
              1e-3);

  const auto   audit = read_json("ring/summary.json").at("damping audit").at(0);
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
  check_ratio("drifting ring, " + rate + ": power of the damping over that of the drag [-]",
              value("power") * 1e3 * time / (lost - gained),
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
  check_below("drifting ring, " + rate + ": torque of the damping over the gain of momentum",
              1e3 * value("net torque") * time -
                (mean_speed ? (last_momentum - first_momentum) : 0.),
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
  check_ratio("drifting ring, " + rate + ": mean speed rate over the momentum's rate",
              value("mean speed rate minus momentum rate") * rpm / difference,
              1e-2);
  check_below("drifting ring, " + rate + ": drift of rotation speed over the momentum's [rpm]",
              value("drift of rotation speed") - (growth - 1) * first_s / rpm,
              10.);
}

int main(int argc, char **argv)
{
  MpiSession        session(argc, argv);
  const std::string free_bar = "free bar", across = "y 0, 3000, 0 mm/s";
  flying_bar(free_bar, across, "", " set mass proportional damping = 2000\n", session.world());
  // zeta = 4 pi f ratio at any frequency.
  std::ostringstream percent;
  percent.precision(17);
  percent << 1e2 * 2000 / (4 * pi * 3700);
  flying_bar(free_bar,
             across,
             "",
             " set damping ratio = " + percent.str() + " %\n set damping frequency = 3.7 kHz\n",
             session.world());
  flying_bar("led bar",
             "x 3000, 0, 0 mm/s",
             " set constraints = guide\n" +
               model_text::section("Constraint guide",
                                   "set kind = displacement\nset nodes = all\n"
                                   "set directions = y, z\n"),
             " set mass proportional damping = 2000\n",
             session.world());
  clamped_beam(session.world());
  sprung_block(session.world());
  shaft_on_bearings(session.world());
  loose_ring(session.world());
  refusals();
  drifting_ring("momentum", session.world());
  drifting_ring("mean speed", session.world());
  return 0;
}
