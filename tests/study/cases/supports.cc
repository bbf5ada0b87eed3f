// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Supports of general models against closed forms: springs to the ground, and radius and angle that
// are prescribed.
#include "../../parts.h"
#include "../prescribed_ring.h"
#include "../quick_pair.h"

#include <vfife/base/types.h>

using namespace vfife;

/** A bar of 100 x 5 x 5 mm, nu = 0, on springs of 1000 N/mm along each direction. */
std::string sprung_bar(const std::string &kind, const std::string &rest)
{
  const bool runs = kind == "run";
  return model_text::study(kind) + R"(
subsection Model
  set bodies      = bar
  set constraints = springs
  set probes      = foot, tip
)" +
         model_text::block("bar",
                           {{100, 5, 5}},
                           {{20, 1, 1}},
                           runs ? "set velocity = 0, 30, 0 mm/s\n" : "") +
         "  subsection Constraint springs\n    set kind = spring\n    set nodes = " +
         (runs ? "all" : "x-") + "\n    set stiffness = 1000, 1000, 1000 N/mm\n  end\n" +
         model_text::probe("foot", "0, 0, 0 mm") + model_text::probe("tip", "100, 0, 0 mm") +
         "end\n" + model_text::no_contraction() + rest;
}

void springs(Communicator &world)
{
  std::string text   = sprung_bar("static", R"(
subsection Model
  set loads = pull
  subsection Load pull
    set kind  = force
    set nodes = x+
    set force = 100, 0, 0 N
  end
end
)" + model_text::relaxation("1e-9"));
  auto        pulled = run_text("pulled", text, world);
  check_ratio("spring: displacement of the foot over F/k",
              pulled["foot displacement x"].back() / 0.1,
              1e-6);
  // F L/(E A) = 1.9 um, strain 2e-5: the forces' own squares are of that size.
  check_ratio("spring: stretch of the bar over F L/(E A)",
              (pulled["tip displacement x"].back() - pulled["foot displacement x"].back()) /
                (100. * 100. / (206000. * 25.)),
              1e-3);

  // Springs share out by nodes equally (no faces): the bar's ends, of half the mass, hardly bend.
  auto                swinging = run_text("swinging",
                           sprung_bar("run", R"(
subsection Dynamics
  set end time = 1 ms
end
subsection Output
  set steps per sample = 10
end
)"),
                           world);
  const auto         &time = swinging["time"], &way = swinging["foot displacement y"];
  std::vector<double> zeros;
  for (std::size_t i = 1; i < time.size(); ++i)
    if (way[i - 1] * way[i] < 0)
      zeros.push_back(time[i - 1] + (time[i] - time[i - 1]) * way[i - 1] / (way[i - 1] - way[i]));
  const double mass = 2500 * 7.85e-9, omega = std::sqrt(1000 / mass);
  check("spring: it swings", zeros.size() >= 2);
  check_ratio("spring: frequency over sqrt(k/m)",
              pi * (zeros.size() - 1) / (zeros.back() - zeros.front()) / omega,
              0.02);
  check_below("spring: energy error", largest_size(swinging["energy error"]), 1e-3);
}

/** A cube of one cell under its weight on springs, all nodes alike, let go with a velocity. */
void preloaded_swing(Communicator &world)
{
  auto         swinging = run_text("preloaded",
                           R"(
subsection Model
  set bodies      = cube
  set constraints = springs, more springs
  set loads       = weight
  set probes      = corner
)" + model_text::block("cube", {{5, 5, 5}}, {{1, 1, 1}}, "set initial velocity y = 30\n") +
                             R"(
  subsection Constraint springs
    set kind      = spring
    set nodes     = all
    set stiffness = 600, 600, 600 N/mm
  end
  subsection Constraint more springs
    set kind      = spring
    set nodes     = all
    set stiffness = 400, 400, 400 N/mm
  end
  subsection Load weight
    set kind         = acceleration
    set nodes        = all
    set acceleration = 0, -1e6, 0 mm/s^2
  end
)" + model_text::probe("corner", "0, 0, 0 mm") +
                             "end\n" +
                             model_text::relaxation("1e-9",
                                                    "set start = static equilibrium\n"
                                                            "set end time = 0.5 ms\n") +
                             "subsection Output\n  set steps per sample = 10\nend\n",
                           world);
  const double mass = 125 * 7.85e-9, omega = std::sqrt(1000 / mass), sag = 1e6 * mass / 1000;
  const auto  &time = swinging["time"], &way = swinging["corner displacement y"];
  double       deviation = 0;
  for (std::size_t i = 0; i < time.size(); ++i)
    raise_to(deviation, std::abs(way[i] + sag - 30 / omega * std::sin(omega * time[i])));
  // Central differences are faster by (omega dt)^2/24, dt below 1 us: 4e-5 of 16 rad.
  check_below("preload: swing about the sag, from the initial velocity, over v/omega",
              deviation / (30 / omega),
              1e-3);
}

void led_radius(Communicator &world)
{
  auto ring = run_text("ring",
                       model_text::study("static") + prescribed_ring() + R"(
subsection Dynamics
  subsection Relaxation
    set tolerance = 1e-7
  end
end
)",
                       world);
  check_close("prescribed radius: displacement inside [mm]",
              ring["inner displacement r"].back(),
              20.01 * std::cos(pi / 360) - 20,
              1e-9);
  check_close("prescribed angle: way inside [mm]",
              ring["inner displacement theta"].back(),
              20.01 * std::sin(pi / 360),
              1e-9);
  // A thin ring widened from inside (Lame, plane stress), turned as a whole by half a degree.
  const double a = 20, b = 40, nu = 0.29;
  const double grown = 0.01 * ((1 - nu) * b + (1 + nu) * b) / ((1 - nu) * a + (1 + nu) * b * b / a);
  const double radius =
    std::hypot(40 + ring["outer displacement r"].back(), ring["outer displacement theta"].back());
  // Chords of 6 degrees, ten cells: some 1e-3.
  check_ratio("prescribed radius: growth outside over Lame's", (radius - 40) / grown, 5e-3);
  check_close("prescribed angle: turn outside [deg]",
              std::atan2(ring["outer displacement theta"].back(),
                         40 + ring["outer displacement r"].back()) *
                180 / pi,
              0.5,
              1e-5);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {springs, preloaded_swing, led_radius});
}
