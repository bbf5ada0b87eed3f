// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Runs that must not go on: an inverted element, a surface that sinks into another; and one that
// must: rigid flight.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"
#include "one_solver.h"

#include <vfife/mesh/body_mesh.h>

#include <limits>

using namespace vfife;

/** The message of the run's failure, or that there was none. */
std::string run_and_fail(OneSolver &run, const double end_time, Observers &observers)
{
  const std::string message =
    message_of<NumericalError>([&] { run.solver.run(run.state, end_time, observers); });
  return message.empty() ? "no failure" : message;
}

/** What a run of 10 us ends with. */
std::string fail(const Model &model)
{
  OneSolver run(model, undamped());
  Observers none;
  return run_and_fail(run, 1e-5, none);
}

bool contains(const std::string &text, const std::string &part)
{
  if (!has_text(text, part))
    std::cout << text << std::endl;
  return has_text(text, part);
}

/** A block driven into its held end faster than its waves: the first layer turns inside out. */
void invert()
{
  Model model;
  Body  block("block", make_block(Vector3(10, 2, 2), {{5, 1, 1}}), Material());
  block.velocity[0] =
    2 * std::sqrt(block.materials().front().youngs_modulus / block.materials().front().density);
  model.add_body(std::move(block));
  model.constraints.push_back({"wall", ConstraintKind::held, 0, model.bodies[0].node_set("x+")});
  DynamicsOptions options = undamped();
  options.energy_limit    = std::numeric_limits<double>::max();
  OneSolver         run(model, options);
  auto              observers = watch(1, [](const State &) {});
  const std::string message   = run_and_fail(run, 100 * run.solver.stable_step(), observers);
  check("inverted element is named",
        contains(message, "an element is inverted at time") &&
          contains(message, "body \"block\", element 4, least Jacobian -"));
}

/** Two blocks on penalty springs so soft that they do not stop each other. */
void sink()
{
  Model model;
  for (unsigned int b = 0; b < 2; ++b)
    {
      Body block(b == 0 ? "falling" : "resting",
                 make_block(Vector3(4, 4, 4), {{2, 2, 2}}),
                 Material());
      block.placement.translation[2] = b == 0 ? 4.01 : 0;
      block.velocity[2]              = b == 0 ? -1e5 : 0;
      model.add_body(std::move(block));
    }
  ContactPair pair               = contact_of("faces", "z-", "z+", ContactSurfaceKind::flat_facets);
  pair.options.edge_fading       = 0;
  pair.options.penalty.value     = 1;
  pair.options.depth_limit       = 1;
  pair.options.penetration_limit = 0.1;
  model.contacts.push_back(pair);
  const std::string message = fail(model);
  check("sinking surface is named",
        contains(message, "penetration exceeds the limit at time 0.0011") &&
          contains(message, "faces side: \"falling\", tooth or group 0, facet ") &&
          contains(message, "deep in \"resting\", tooth or group 0, facet ") &&
          contains(message, "(limit 100 um, Contact/abort penetration ratio)"));
  // 0.11 mm at 1e5 mm/s are 1.1 us; the springs take 1e-7 of the energy on that way.
  check("stopped in the step that passes the limit", has_text(message, " is 10"));
}

/** A block that comes so fast that the wall's springs, as stiff as the step allows, are passed in
 * a few steps; and one that bounces between two samples. */
Model make_thrown_block(const double speed)
{
  Model model;
  Body  block("block", make_block(Vector3(4, 4, 4), {{2, 2, 2}}), Material());
  block.velocity[2] = -speed;
  RigidWall wall;
  wall.name     = "floor";
  wall.nodes    = block.node_set("z-");
  wall.normal   = Vector3::UnitZ();
  wall.point[2] = -0.01;
  model.add_body(std::move(block));
  model.walls.push_back(wall);
  return model;
}

void pass_wall()
{
  // Three times the speed of waves.
  const std::string message = fail(make_thrown_block(1.5e7));
  check("a body behind a wall is named",
        contains(message, "penetration exceeds the limit at time ") &&
          contains(message, "contact \"floor\": body \"block\", node ") &&
          contains(message, " um behind the wall (limit 1000 um, half a facet)"));
}

void bounce()
{
  const double speed = 1000;
  const Model  model = make_thrown_block(speed);
  OneSolver    run(model, undamped());
  Observers    none; // the first and the last state are measured, both in flight
  run.solver.run(run.state, 5e-5, none);
  const ContactLosses &losses = run.solver.contact_losses();
  check("the end of the bounce is a loss of contact", losses.count >= 1);
  // 0.01 mm at 1 m/s are 10 us; contact lasts some passages of waves of 0.8 us each way.
  check("its time", losses.first > 1e-5 && losses.first < 2e-5);
  check("time without contact", losses.duration > 0 && losses.duration < 4e-5);
  check("the energy of approach is the scale of the error",
        run.state.measured.energy.scale >=
          (1 - 1e-12) * 0.5 * model.bodies[0].mass() * speed * speed);
}

/** Flight and spin have kinetic energy alone: its round-off is no error of energy. */
void fly()
{
  Model model;
  Body  block("block", make_block(Vector3(10, 2, 2), {{5, 1, 1}}), Material());
  block.velocity[0] = 1e5;
  model.add_body(std::move(block));
  OneSolver run(model, undamped());
  double    error     = 0;
  auto      observers = watch(10, [&](const State &state) {
    raise_to(error, std::abs(state.measured.energy.error()));
  });
  run.solver.run(run.state, 1e4 * run.state.dt, observers);
  // Round-off, some 1e-15 of the kinetic energy, over the floor, 1e-10 of it.
  check_below("energy error of rigid flight", error, 1e-3);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {invert, sink, pass_wall, bounce, fly});
}
