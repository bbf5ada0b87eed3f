// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A block that is pressed on a floor and pulled along it, floor a body or a rigid wall: below the
// limit of friction it sticks and moves by its traction over the tangential stiffness, beyond it
// slides with the acceleration that is left. In time, and at rest by relaxation.
#include "../model/model_text.h"
#include "../parts.h"
#include "relaxed.h"

#include <vfife/mesh/body_mesh.h>

using namespace vfife;

constexpr double mu = 0.3, normal = 3000., ratio = 0.5;   // [-], [N], [-]
constexpr double penalty    = 4e4;                        // [N/mm^3]
constexpr double press_time = 0.1e-3, pull_time = 0.3e-3; // [s]

enum class Floor
{
  body,
  wall
};

/** Block of 10 x 10 x 4 mm; @p parts: loads and constraints with their sections. */
std::string make_text(const Floor        floor,
                      const std::string &names,
                      const std::string &sections,
                      const std::string &contact = "")
{
  std::ostringstream text;
  text << "subsection Model\n  set bodies = block" << (floor == Floor::body ? ", floor" : "")
       << "\n  set contacts = face\n"
       << names << R"(
  subsection Body block
    set mesh    = block
    set size x  = 10 mm
    set size y  = 10 mm
    set size z  = 4 mm
    set elements x = 4
    set elements y = 4
    set elements z = 2
  end
)";
  if (floor == Floor::body)
    text << R"(
  subsection Body floor
    set mesh     = block
    set size x   = 24 mm
    set size y   = 20 mm
    set size z   = 4 mm
    set elements x = 12
    set elements y = 10
    set elements z = 2
    set position = -5, -5, -4 mm
  end
  subsection Constraint ground
    set kind  = fixed
    set body  = floor
    set nodes = z-
  end
  subsection Contact face
    set slave body     = block
    set slave surface  = z-
    set master body    = floor
    set master surface = z+
)";
  else
    text << R"(
  subsection Contact face
    set kind        = wall
    set body        = block
    set nodes       = z-
    set wall normal = 0, 0, 1
)";
  text << "    set friction coefficient = " << mu
       << "\n    set tangential stiffness ratio = " << ratio << "\n"
       << contact << "  end\n"
       << sections << "end\n";
  return text.str();
}

/** Displacement along x of the block's lower face, mean by mass, and the floor's under it. */
double mean_way(const Model &model, const State &state)
{
  double      sum = 0, mass = 0;
  const Body &block = model.bodies[0];
  for (const unsigned int node : block.node_set("z-"))
    {
      const double m = block.node_masses()[node];
      sum += m * (state.node_position(state.partition->local_node[node])[0] -
                  block.node_positions()[node][0]);
      mass += m;
    }
  return sum / mass;
}

/** Of the block along x [N s]. */
double block_momentum(const Model &model, const State &state)
{
  double sum = 0;
  for (unsigned int node = 0; node < model.bodies[0].n_nodes(); ++node)
    sum += model.bodies[0].node_masses()[node] *
           state.velocity.value(state.partition->local_node[node])[0];
  return sum;
}

struct Pulled
{
  double largest_way = 0, way = 0, velocity_change = 0, friction_loss = 0,
         error     = 0; ///< error: energy
  double stiffness = 0, mass = 0,
         lag = 0; ///< drag of the damping, half a step behind, over the inertia
};

/** Pressed with 3 kN, then pulled with @p part of the limit by an acceleration. */
Pulled pull(const Floor floor, const double part)
{
  const double       mass = 10 * 10 * 4 * 7.85e-9;
  std::ostringstream sections;
  sections << R"(
  subsection Load press
    set body    = block
    set nodes   = z+
    set force   = 0, 0, )"
           << -normal << R"( N
    set history = t < 0.1e-3 ? 0.5*(1 - cos(pi*t/0.1e-3)) : 1
  end
  subsection Load pull
    set kind         = acceleration
    set body         = block
    set nodes        = all
    set acceleration = )"
           << part * mu * normal / mass << R"(, 0, 0 mm/s^2
    set history      = t < 0.1e-3 ? 0 : t < 0.3e-3 ? 0.5*(1 - cos(pi*(t-0.1e-3)/0.2e-3)) : 1
  end
)";
  const Model model =
    make_model(make_text(floor,
                         std::string("set loads = press, pull\n") +
                           (floor == Floor::body ? "set constraints = ground\n" : ""),
                         sections.str(),
                         "    set penalty = " + std::to_string(penalty) + "\n" +
                           (floor == Floor::body ? "    set damping ratio = 0.2\n" : "")));
  // Elastic bodies that slide by Coulomb's law excite themselves (Adams 1995): damped relative to
  // the block's own rigid motion, which lags half a step behind.
  DynamicsOptions options = undamped();
  options.damping         = 2e5;
  OneSolver run(model, options);
  Pulled    result;
  result.mass      = mass;
  double from      = -1;
  auto   observers = watch(1, [&](const State &state) {
    result.way         = mean_way(model, state);
    result.largest_way = std::max(result.largest_way, std::abs(result.way));
    // Of the little that the first steps exchange it is any part.
    if (state.time > press_time)
      result.error = std::max(result.error, std::abs(state.measured.energy.error()));
    if (state.time > pull_time && from < 0)
      from = block_momentum(model, state);
    result.velocity_change = (block_momentum(model, state) - from) / mass;
    result.friction_loss   = state.measured.energy.friction_loss;
  });
  run.solver.run(run.state, pull_time + 0.2e-3, observers);
  result.lag       = 0.5 * options.damping * run.state.dt;
  result.stiffness = ratio * penalty * 100;
  return result;
}

void in_time()
{
  for (const Floor floor : {Floor::body, Floor::wall})
    {
      const std::string name = floor == Floor::body ? "on a body: " : "on a wall: ";
      const Pulled      half = pull(floor, 0.5);
      // The floor itself yields a little: the spring's part is the displacement on the wall.
      const double elastic = 0.5 * mu * normal / half.stiffness;
      if (floor == Floor::wall)
        check_ratio(name + "sticks, way over that of the spring", half.largest_way / elastic, 0.15);
      else
        check(name + "sticks", half.largest_way < 3 * elastic);
      check_below(name + "nothing slides: friction's loss over mu N times the elastic way",
                  half.friction_loss / (mu * normal * elastic),
                  0.02);
      check_below(name + "sticks: energy error", half.error, 2e-3);

      const Pulled fast         = pull(floor, 1.2);
      const double acceleration = 0.2 * mu * normal / fast.mass;
      check_ratio(name + "slides, change of the velocity over (F - mu N) t/m",
                  fast.velocity_change * (1 + fast.lag) / (acceleration * 0.2e-3),
                  0.01);
      check_ratio(name + "friction's loss over mu N times the way",
                  fast.friction_loss / (mu * normal * fast.way),
                  0.02);
      check_below(name + "slides: energy error", fast.error, 2e-3);
    }
}

void at_rest()
{
  // A leash of 5000 N/mm holds what friction leaves: (F - mu N)/k, nothing below the limit.
  for (const Floor floor : {Floor::body, Floor::wall})
    for (const double force : {100., 400.})
      {
        std::ostringstream sections;
        sections << R"(
  subsection Constraint leash
    set kind      = spring
    set body      = block
    set nodes     = z-
    set stiffness = 5000, 5000, 0 N/mm
  end
  subsection Load press
    set body  = block
    set nodes = z+
    set force = 0, 0, -1000 N
  end
  subsection Load pull
    set body  = block
    set nodes = z-
    set force = )"
                 << force << R"(, 0, 0 N
  end
)";
        const Model model =
          make_model(make_text(floor,
                               std::string("set loads = press, pull\nset constraints = leash") +
                                 (floor == Floor::body ? ", ground\n" : "\n"),
                               sections.str(),
                               "        set penalty = 2000\n"));
        OneSolver run(model, undamped());
        relax(model, run);
        run.solver.measure_at_rest(run.state);
        const double       way = mean_way(model, run.state);
        std::ostringstream name;
        name << (floor == Floor::body ? "on a body, " : "on a wall, ") << force << " N: ";
        if (force < mu * 1000)
          // F/(k_t + leash); the floor's own yielding is some 5e-5 mm more.
          check_ratio(name.str() + "holds, way over F/k",
                      way / (force / (ratio * 2000 * 100 + 5000)),
                      floor == Floor::body ? 0.1 : 0.01);
        else
          check_close(name.str() + "slides to (F - mu N)/k [mm]",
                      way,
                      (force - mu * 1000) / 5000,
                      1e-3);
        const auto &forces = run.state.measured.contact_forces;
        check_close(name.str() + "friction on the block [N]",
                    forces.at(0)[0],
                    -(force - 5000 * way),
                    0.05);
        check_close(name.str() + "normal force on the block [N]", forces.at(0)[2], 1000., 0.05);
      }
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {in_time, at_rest});
}
