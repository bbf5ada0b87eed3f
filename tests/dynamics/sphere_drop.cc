// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic sphere falls on a rigid plane: Hertz's theory of impact.
#include "../parts.h"
#include "../tests.h"
#include "one_solver.h"

#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/boundary_surface.h>

using namespace vfife;

constexpr double radius = 10, gap = 1e-3, speed = 2e4; // [mm], [mm], [mm/s]

Model make_model(const ContactTime time)
{
  Model model;
  Body  ball("ball", make_sphere(radius, {{12, 5}}), Material());
  ball.placement.translation[2] = radius + gap;
  ball.velocity[2]              = -speed;
  model.add_body(std::move(ball));

  Body plane("plane", make_block(Vector3(8, 8, 1), {{6, 6, 1}}, Vector3(-4, -4, -1)), Material());
  std::vector<unsigned int> nodes(plane.n_nodes());
  for (unsigned int n = 0; n < nodes.size(); ++n)
    nodes[n] = n;
  model.add_body(std::move(plane));
  model.constraints.push_back({"plane", ConstraintKind::held, 1, nodes});

  model.contacts.push_back(contact_of("impact", "outer", "z+", ContactSurfaceKind::smooth_patches));
  ContactOptions &options = model.contacts.back().options;
  options.time            = time;
  options.penalty.value   = 4.4e5; // [N/mm^3]
  return model;
}

void fall(const ContactTime time)
{
  const Model     model   = make_model(time);
  DynamicsOptions options = undamped();
  if (time == ContactTime::explicit_)
    options.step_bound = StepBound::element;
  OneSolver run(model, options);

  const Material &material = model.bodies[0].materials().front();
  const double    mass     = model.bodies[0].mass();
  // F = k d^1.5 of a sphere on a rigid plane; Johnson 1985, section 11.4
  const double k = 4. / 3. * material.youngs_modulus /
                   (1 - material.poissons_ratio * material.poissons_ratio) * std::sqrt(radius);
  const double depth = std::pow(5. * mass * speed * speed / (4. * k), 0.4);
  const double peak = k * std::pow(depth, 1.5), duration = 2.9432 * depth / speed;

  double      largest = 0, first = -1, last = -1, impulse = 0, velocity = 0, energy = 0, error = 0;
  const auto &masses    = run.solver.vfife_operator().masses();
  auto        observers = watch(1, [&](const State &state) {
    const double force = state.measured.contact_force;
    raise_to(largest, force);
    impulse += force * state.dt;
    if (force > 0)
      {
        first = first < 0 ? state.time : first;
        last  = state.time;
      }
    double p = 0;
    for (std::uint32_t i = 0; i < state.partition->first_local_node[1]; ++i)
      p += masses[i] * state.node_velocity(i)[2];
    velocity = p / mass;
    raise_to(energy, std::abs(state.measured.energy.residual()) / (0.5 * mass * speed * speed));
    // Before the touch it is round-off of the flight over next to nothing.
    if (first >= 0)
      raise_to(error, std::abs(state.measured.energy.error()));
  });
  run.solver.run(run.state, 1.3 * duration + gap / speed, observers);

  // Elements of 1.3 mm under a contact of 1.4 mm radius; 1.6 % and 1.1 % are measured.
  check_ratio("force peak over Hertz's", largest / peak, 0.03);
  check_ratio("duration over Hertz's", (last - first) / duration, 0.03);
  check_ratio("velocity afterwards over that before",
              velocity / speed,
              0.005); // waves keep the rest
  check_ratio("impulse over change of momentum", impulse / (mass * (speed + velocity)), 1e-6);
  check_below("energy residual over that of flight",
              energy,
              time == ContactTime::implicit ? 1e-6 : 1e-4);
  // The plane is held, so all of the flight's energy takes part: the error is this residual, also
  // at the first touch, when nothing else has been exchanged yet.
  check_ratio("largest energy error over the residual", error / energy, 1e-9);
  check("contact is lost once", run.solver.contact_losses().count == 1);
}

void fall_explicitly()
{
  fall(ContactTime::explicit_);
}

/** At a step that explicit springs would not bear. */
void fall_implicitly()
{
  fall(ContactTime::implicit);
}

/** Force histories of all contacts until the middle of the impact [N], at the step @p dt [s]. */
std::vector<std::vector<double>> forces_of(const Model &model, const double dt)
{
  DynamicsOptions options = undamped();
  options.step_bound      = StepBound::element;
  OneSolver run(model, options);
  run.solver.set_step(dt);
  run.solver.start(run.state);
  std::vector<std::vector<double>> forces(model.contacts.size());
  auto                             observers = watch(1, [&](const State &state) {
    for (std::size_t i = 0; i < forces.size(); ++i)
      forces[i].push_back(state.measured.contact_forces[i].norm());
  });
  run.solver.run(run.state, 1.5e-5, observers);
  return forces;
}

/** Two spheres on two planes, one contact explicit, one implicit: each force is that of the
 * sphere alone. */
void fall_both_ways()
{
  const Model one = make_model(ContactTime::explicit_), other = make_model(ContactTime::implicit);
  Model       both = make_model(ContactTime::explicit_);
  for (unsigned int b = 0; b < 2; ++b)
    {
      const Body &body = other.bodies[b];
      auto        mesh = b == 0 ? make_sphere(radius, {{12, 5}})
                                : make_block(Vector3(8, 8, 1), {{6, 6, 1}}, Vector3(-4, -4, -1));
      Body        second(body.name() + " 2", std::move(mesh), Material());
      second.placement = body.placement;
      second.placement.translation[0] += 50;
      second.velocity = body.velocity;
      both.add_body(std::move(second));
    }
  both.constraints.push_back(other.constraints[0]);
  both.constraints.back().name = "second plane";
  both.constraints.back().body = 3;
  both.contacts.push_back(other.contacts[0]);
  both.contacts.back().side        = "second impact";
  both.contacts.back().slave_body  = 2;
  both.contacts.back().master_body = 3;

  DynamicsOptions options = undamped();
  options.step_bound      = StepBound::element;
  const double dt         = 0.9 * OneSolver(both, options).solver.stable_step();
  const auto   mixed      = forces_of(both, dt);
  const auto   single     = {forces_of(one, dt)[0], forces_of(other, dt)[0]};
  unsigned int i          = 0;
  for (const std::vector<double> &expected : single)
    {
      const std::string name  = i == 0 ? "explicit" : "implicit";
      double            worst = 0, most = 0;
      check("two spheres, steps", expected.size() == mixed[i].size());
      for (std::size_t k = 0; k < std::min(expected.size(), mixed[i].size()); ++k)
        {
          raise_to(worst, std::abs(expected[k] - mixed[i][k]));
          raise_to(most, expected[k]);
        }
      check("two spheres, " + name + ": touches", most > 100);
      // Places are 50 mm farther from the origin, round-off of 1e-14 mm times the penalty.
      check_below("two spheres, " + name + ": force", worst / most, 1e-8);
      ++i;
    }
  check("two spheres: the ways differ", mixed[0] != mixed[1]);
}

/**
 * The quarter x, y > 0 of the sphere with cells crowded at its lower pole: moved by the map of
 * the ball onto itself that keeps angles and shrinks by (1 - c)/(1 + c) there, as much as it
 * grows at the upper one.
 */
std::unique_ptr<BodyMesh> make_crowded_quarter(const std::array<unsigned int, 2> &counts,
                                               const double                       c)
{
  const auto                whole = make_sphere(1., counts);
  const auto               &old   = whole->triangulation.get_vertices();
  const Vector3             a(0., 0., -c);
  std::vector<Vector3>      nodes;
  std::vector<CellNodes>    cells;
  std::vector<unsigned int> numbers(old.size(), old.size());
  for (const auto &cell : whole->triangulation.active_cell_iterators())
    {
      if (!(cell->center()[0] > 0 && cell->center()[1] > 0))
        continue;
      cells.emplace_back();
      for (unsigned int v = 0; v < 8; ++v)
        {
          unsigned int &number = numbers[cell->vertex_index(v)];
          if (number == old.size())
            {
              const auto   &vertex = cell->vertex(v);
              const Vector3 x(vertex[0], vertex[1], vertex[2]);
              number = nodes.size();
              nodes.push_back(radius / (1. + 2. * a.dot(x) + c * c * x.squaredNorm()) *
                              ((1. + 2. * a.dot(x) + x.squaredNorm()) * a + (1. - c * c) * x));
            }
          cells.back()[v] = number;
        }
    }
  auto mesh = std::make_unique<BodyMesh>();
  create_triangulation(*mesh, nodes, cells);
  const auto side = [&](const std::string &name, const auto &selected) {
    add_named_side(*mesh, name, [&](const unsigned int i) { return selected(nodes[i]); });
  };
  side("x-", [](const Vector3 &x) { return x[0] < 1e-9; });
  side("y-", [](const Vector3 &x) { return x[1] < 1e-9; });
  side("outer", [](const Vector3 &x) { return x.norm() > (1. - 1e-9) * radius; });
  // Their means over the facets around would lean at the planes of symmetry.
  FacetSurface &outer = mesh->surfaces["outer"];
  for (std::size_t i = 0; i < outer.normals.size(); ++i)
    outer.normals[i] = outer.positions[i].normalized();
  return mesh;
}

Constraint symmetry(const unsigned int body, const Body &of, const unsigned int direction)
{
  Constraint plane =
    hold(of.node_set(direction == 0 ? "x-" : "y-"), {{direction == 0, direction == 1, false}});
  plane.body = body;
  return plane;
}

/** Quarters of two spheres with facets from 0.15 to 12 mm, and the default penalty, which facets
 * far away from the contact have no part in. */
void crowded_spheres()
{
  constexpr double slow = 1e3; // of one to the other [mm/s]
  Model            model;
  for (const double side : {1., -1.})
    {
      Body ball("ball", make_crowded_quarter({{12, 6}}, .8), Material());
      if (side < 0)
        {
          // Turned by half a turn about the line x = y, which takes the quarter to itself.
          Matrix3 turn;
          turn << 0, 1, 0, 1, 0, 0, 0, 0, -1;
          ball.placement.rotation = turn;
        }
      ball.placement.translation[2] = side * (radius + .05 * gap);
      ball.velocity[2]              = -.5 * side * slow;
      model.add_body(std::move(ball));
    }
  for (unsigned int b = 0; b < 2; ++b)
    for (const unsigned int direction : {0u, 1u})
      {
        model.constraints.push_back(symmetry(b, model.bodies[b], direction));
        // Axes of the fixed frame: of the turned body x is y.
        if (b == 1)
          {
            auto &prescribed = model.constraints.back().prescribed;
            std::swap(prescribed[0], prescribed[1]);
          }
      }
  model.contacts.push_back(
    contact_of("impact", "outer", "outer", ContactSurfaceKind::smooth_patches));

  OneSolver      run(model, undamped());
  const Material steel;
  const double   modulus =
    .5 * steel.youngs_modulus / (1 - steel.poissons_ratio * steel.poissons_ratio);
  const double mass  = 2. * model.bodies[0].mass(); // two quarters against two: m1 m2/(m1 + m2)
  const double k     = 4. / 3. * modulus * std::sqrt(.5 * radius);
  const double depth = std::pow(5. * mass * slow * slow / (4. * k), .4);
  const double peak = k * std::pow(depth, 1.5), duration = 2.9432 * depth / slow;
  double       largest = 0, first = -1, last = -1, residual = 0;
  auto         observers = watch(1, [&](const State &state) {
    const double force = state.measured.contact_force;
    raise_to(largest, 4. * force);
    if (force > 0)
      {
        first = first < 0 ? state.time : first;
        last  = state.time;
      }
    raise_to(residual, std::abs(state.measured.energy.residual()));
  });
  run.solver.run(run.state, 1.1 * duration, observers);
  check_ratio("crowded spheres, force peak over Hertz's", largest / peak, .03);
  check_ratio("crowded spheres, duration over Hertz's", (last - first) / duration, .03);
  check_below("crowded spheres, energy residual over that of flight",
              residual / (.25 * mass * slow * slow / 2.),
              1e-5);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {fall_explicitly, fall_implicitly, fall_both_ways, crowded_spheres});
}
