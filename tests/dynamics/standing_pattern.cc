// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A turning pinion whose displacement stands still in space: velocities and forces of inertia
// against the derivatives of the displacement that is put on.
#include "../mesh/paper_members.h"
#include "../tests.h"
#include "one_solver.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/dynamics/equilibrium/standing_pattern.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/node_set_names.h>

using namespace vfife;

constexpr double rate = -700., radial = 0.02, tangential = 0.01, axial = 0.03, waves = 2.;

struct Field
{
  Vector3 value, slope, curvature; ///< components r, theta, z [mm], [mm/rad], [mm/rad^2]

  explicit Field(const double phi)
  {
    const double c = std::cos(waves * phi), s = std::sin(waves * phi);
    value     = Vector3(radial * c, tangential * s, axial * s);
    slope     = waves * Vector3(-radial * s, tangential * c, axial * c);
    curvature = -waves * waves * value;
  }
};

int main(int argc, char **argv)
{
  const MpiSession session(argc, argv);
  // mounted with its axis along x, to see that the axis is used and not z
  RigidMotion placement;
  placement.rotation << 0., 0., 1., 1., 0., 0., 0., 1., 0.;
  placement.translation = Vector3(3., -2., 5.);

  Model model;
  Body  pinion("pinion",
              make_gear_body(paper::pinion(), coarse(pinion_body_defaults())),
              Material());
  pinion.placement      = placement;
  pinion.axis.point     = placement.translation;
  pinion.axis.direction = placement.rotation.col(2);
  pinion.turns_on_axis  = true;
  pinion.rate           = rate;
  model.add_body(std::move(pinion));
  const Body &body = model.bodies[0];
  model.constraints.push_back(
    {"bore", ConstraintKind::free_rotation, 0, body.node_set(node_set::bore)});
  OneSolver run(model, undamped());

  std::vector<Vector3> velocity(body.n_nodes()), acceleration(body.n_nodes());
  for (unsigned int n = 0; n < body.n_nodes(); ++n)
    {
      const Vector3 &x   = body.node_positions()[n];
      const double   phi = std::atan2(x[1], x[0]);
      const Matrix3  cylindrical(placement.rotation * rotation_about(Vector3::UnitZ(), phi));
      const Field    field(phi);
      velocity[n] = rate * (cylindrical * field.slope);
      acceleration[n] =
        rate * rate * (cylindrical * (field.curvature + 2. * Vector3::UnitZ().cross(field.slope)));
      run.state.position.set(run.state.partition->local_node[n],
                             placement(x) + cylindrical * field.value);
    }

  StandingPattern pattern(model, run.communicator);
  pattern.update(run.state);
  const std::size_t         size = run.state.position.n_nodes();
  NodeField                 velocities(size), forces(size);
  const std::vector<double> masses(size, 2.);
  pattern.add_velocities(velocities);
  pattern.add_forces(masses, forces);
  double wrong_velocity = 0., wrong_force = 0., largest = 0.;
  for (unsigned int n = 0; n < body.n_nodes(); ++n)
    {
      const std::uint32_t i = run.state.partition->local_node[n];
      raise_to(largest, velocity[n].norm());
      raise_to(wrong_velocity, (velocities.value(i) - velocity[n]).norm());
      raise_to(wrong_force, (forces.value(i) + 2. * acceleration[n]).norm());
    }
  // error of the fourth-order differences, (waves h)^4/30 with h = 2 pi/27
  const double error = std::pow(waves * 2. * pi / 27., 4) / 30.;
  check_below("velocity", wrong_velocity / largest, 1.01 * error);
  check_below("force of inertia, per 2 m Omega and velocity",
              wrong_force / (4. * std::abs(rate) * largest),
              1.5 * error);

  // Spin about another line takes no sector to the place of the next: nothing stands still.
  model.bodies[0].axis.direction = Vector3(1., 1., 0.).normalized();
  pattern.update(run.state);
  NodeField none(size);
  pattern.add_velocities(none);
  largest = 0.;
  for (unsigned int n = 0; n < body.n_nodes(); ++n)
    raise_to(largest, none.value(n).norm());
  check("no pattern about another axis", largest == 0.);
  return 0;
}
