// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Reactions of supports in histories: balance with the loads at rest and in motion, the
// conventional solver's, and closed forms: a suddenly pulled bar, a turning bar, a ring cut by its
// planes of symmetry.
#include "../../model_sections.h"
#include "../../parts.h"
#include "../quick_pair.h"

#include <vfife/base/types.h>

using namespace vfife;

std::string study(const std::string &kind)
{
  return model_text::study(kind) + quiet_output(1);
}

Vector3 last(Columns &history, const std::string &column)
{
  return {history.at(column + " x").back(),
          history.at(column + " y").back(),
          history.at(column + " z").back()};
}

/** A bar of 5 x 5 mm, in cubes. */
std::string bar(const unsigned int n_cells, const std::string &constraints, const std::string &more)
{
  return "subsection Model\n  set bodies = bar\n  set constraints = " + constraints + "\n" +
         model_text::block("bar", {{5. * n_cells, 5, 5}}, {{n_cells, 1, 1}}) + more + "end\n" +
         model_text::no_contraction();
}

/** A clamped bar with a spring, a guide and a force in one corner of its end. */
std::string supported_bar(const std::string &force)
{
  return bar(4,
             "clamp, rest, guide",
             R"(
  set loads       = pull
  set probes      = corner
  subsection Constraint clamp
    set kind  = fixed
    set nodes = x-
  end
  subsection Constraint rest
    set kind      = spring
    set nodes     = z-
    set stiffness = 300, 2000, 5000 N/mm
  end
  subsection Constraint guide
    set kind       = displacement
    set nodes      = y-
    set where      = x < 5.1
    set directions = y
  end
  subsection Load pull
    set kind  = force
    set nodes = x+
    set where = y > 4.9 && z > 4.9
    set force = )" +
               force +
               R"(
  end
)" + model_text::probe("corner", "20, 5, 5 mm"));
}

Columns rest(const std::string &kind, const std::string &force, Communicator &world)
{
  return run_text("resting",
                  study(kind) + supported_bar(force) + model_text::relaxation("1e-12"),
                  world);
}

void resting(Communicator &world)
{
  const Vector3 force(3000., 1000., -500.), corner(20., 5., 5.);
  for (const std::string kind : {"linear static", "static"})
    {
      Columns history = rest(kind, "3000, 1000, -500 N", world);
      // Small displacements of a linear solution leave the arms as they are.
      const Vector3 arm    = corner + (kind == "static" ? last(history, "corner displacement")
                                                        : Vector3(Vector3::Zero()));
      Vector3       forces = force, moments = arm.cross(force);
      for (const std::string name : {"clamp", "rest", "guide"})
        {
          forces += last(history, name + " reaction force");
          moments += last(history, name + " reaction moment");
        }
      check_below(kind + ": reactions and load, over the load", forces.norm() / force.norm(), 1e-9);
      check_below(kind + ": their moments, over that of the load",
                  moments.norm() / arm.cross(force).norm(),
                  1e-9);
    }
  // Under a thousandth of the load turns are of 1e-5: so much do finite and small ones differ.
  Columns one = rest("linear static", "3, 1, -0.5 N", world),
          two = rest("static", "3, 1, -0.5 N", world);
  for (const std::string name : {"clamp", "rest", "guide"})
    for (const std::string of : {" reaction force", " reaction moment"})
      check_ratio("static over linear static: " + name + of,
                  last(two, name + of).norm() / last(one, name + of).norm(),
                  1e-4);
}

/** A bar that is suddenly pulled: its wave comes back from the clamp as 2 F. */
void pulled(Communicator &world)
{
  const double c = std::sqrt(206000 / 7.85e-9), travel = 100 / c;
  auto         history = run_text("pulled",
                          study("run") + bar(20, "clamp", R"(
  set loads       = pull
  subsection Constraint clamp
    set kind  = fixed
    set nodes = x-
  end
  subsection Load pull
    set kind  = force
    set nodes = x+
    set force = 100, 0, 0 N
  end
)") + "subsection Dynamics\n  set end time = " +
                            std::to_string(4e6 * travel) + " us\nend\n",
                          world);
  const auto  &time = history["time"], &reaction = history["clamp reaction force x"],
             &momentum = history["momentum x"];
  double plateau = 0, early = 0, late = 0, balance = 0, impulse = 0;
  int    n = 0;
  for (std::size_t i = 0; i + 1 < time.size(); ++i)
    {
      const double at = time[i] / travel, dt = time[i + 1] - time[i];
      if (at < .7)
        early = std::max(early, std::abs(reaction[i]));
      else if (at > 1.2 && at < 2.8)
        {
          plateau += reaction[i];
          ++n;
        }
      else if (at > 3.3)
        late = std::max(late, std::abs(reaction[i]));
      // Momenta belong to half a step before the sample.
      balance =
        std::max(balance,
                 std::abs(momentum[i + 1] - momentum[i] - dt * (100 + reaction[i])) / (100 * dt));
      impulse += dt * reaction[i];
    }
  check_ratio("pulled bar: mean reaction while the wave is back, over -2 F",
              plateau / n / -200,
              5e-3);
  check_below("pulled bar: reaction before the wave has come, over F", early / 100, .02);
  check_below("pulled bar: rate of the momentum less force and reaction, over F", balance, 1e-9);
  check_ratio("pulled bar: impulse of a period over -4 F L/c", impulse / (-400 * travel), .01);
}

/** A bar turned at one end: the reaction is its mass times omega^2 r, and turns with it. */
void turning(Communicator &world)
{
  const double rate    = 500;
  auto         history = run_text("turning",
                          study("run") + R"(
subsection Model
  set bodies      = bar
  set constraints = drive
  set probes      = middle
)" + model_text::block("bar", {{20, 4, 4}}, {{5, 2, 2}}, R"(
    set position   = 30, -2, 0 mm
    set rotating   = yes
    set rotational speed = 500 rad/s
)") + R"(
  subsection Constraint drive
    set kind  = turning
    set nodes = x-
  end
  subsection Probe middle
    set point = 8, 2, 2 mm
  end
end
)" + model_text::relaxation("1e-9", "set start = static equilibrium\nset end time = 1 ms\n"),
                          world);
  const double mass = 20 * 16 * 7.85e-9, size = mass * rate * rate * 40;
  double       worst = 0;
  for (std::size_t i = 0; i < history["time"].size(); ++i)
    {
      const double  angle = rate * history["time"][i];
      const Vector3 reaction(history["drive reaction force x"][i],
                             history["drive reaction force y"][i],
                             history["drive reaction force z"][i]);
      worst =
        std::max(worst,
                 (reaction + size * Vector3(std::cos(angle), std::sin(angle), 0.)).norm() / size);
    }
  // Central differences (omega dt)^2, the stretch of some 1e-5 of the radius.
  check_below("turning bar: reaction less that of the rigid bar, over it", worst, 1e-4);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {resting, pulled, turning});
}
