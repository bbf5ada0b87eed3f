// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Nodal forces of loads, torques, springs and walls on a body that is moved and strained: their
// resultants and moments against closed forms, energies, powers, steps.
#include "../model_parts.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/loads/nodal_loads.h>
#include <vfife/dynamics/loads/rigid_walls.h>
#include <vfife/dynamics/loads/torque_loads.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/mesh/primitives/primitives.h>

#include <functional>

using namespace vfife;

constexpr double       inner = 20, outer = 30, height = 6;
constexpr unsigned int around = 40;

/** A ring, turned and away from the origin, on its axis. */
Model make_ring_model()
{
  Model model = model_of({"ring", make_ring(inner, outer, height, {{2, around, 2}}), Material()});
  Body &ring  = model.bodies.front();
  ring.placement.rotation    = rotation_about(Vector3(1., 2., 2.).normalized(), 1.3);
  ring.placement.translation = Vector3(50., -20., 10.);
  ring.axis                  = {ring.placement(Vector3::Zero()), ring.placement.rotation.col(2)};
  return model;
}

/** A model on one rank with places, velocities and forces of its nodes. */
struct Moved
{
  Model         model;
  Communicator  communicator;
  VfifeOperator vfife;
  NodeField     positions, velocities, forces;

  /** @p motion: from the body frame to present places in the fixed frame. */
  Moved(Model &&of, const std::function<Vector3(const Vector3 &)> &motion)
    : model(std::move(of))
    , communicator(MPI_COMM_SELF)
    , vfife(model, FrameKind::polar, StiffnessKind::incompatible_modes, communicator)
    , positions(vfife.make_field())
    , velocities(positions)
    , forces(positions)
  {
    for (std::size_t i = 0; i < n(); ++i)
      positions.set(i, motion(model.bodies[0].node_positions()[partition().global_node[i]]));
  }

  const Partition &partition() const
  {
    return vfife.partition();
  }
  std::size_t n() const
  {
    return partition().n_local();
  }
  Vector3 place(const std::size_t i) const
  {
    return positions.value(i);
  }
  Vector3 force(const std::size_t i) const
  {
    return forces.value(i);
  }
  Vector3 resultant() const
  {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < n(); ++i)
      sum += force(i);
    return sum;
  }
  Vector3 moment(const Vector3 &centre) const
  {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < n(); ++i)
      sum += (place(i) - centre).cross(force(i));
    return sum;
  }
};

void torque()
{
  Model       model = make_ring_model();
  const Body &ring  = model.bodies.front();
  model.torques.push_back(torque_on(model, "inner", 5000));
  model.torques[0].ramp_time = 1e-3;
  const Axis    axis         = ring.axis;
  const Matrix3 turn         = rotation_about(axis.direction, 2.);
  Moved         moved(std::move(model), [&](const Vector3 &X) {
    return Vector3(axis.point + turn * (ring.placement(X) - axis.point));
  });
  TorqueLoads   torques(moved.model, moved.partition());
  torques.add_forces(.25e-3, moved.positions, moved.forces);
  check_close("torque: a quarter of its ramp [N mm]",
              moved.moment(axis.point).dot(axis.direction),
              1250.,
              1e-9);
  moved.forces.set_zero();
  torques.add_forces(1., moved.positions, moved.forces);
  check_below("torque: moment less its value [N mm]",
              (moved.moment(axis.point) - 5000. * axis.direction).norm(),
              1e-8);
  check_below("torque: no resultant [N]", moved.resultant().norm(), 1e-10);
  // Everywhere the same traction T/(A r), along the circle.
  const Torque &load      = moved.model.torques.front();
  const double  traction  = 5000 / (sum_of(load.areas) * inner);
  double        deviation = 0;
  for (std::size_t k = 0; k < load.nodes.size(); ++k)
    {
      const std::uint32_t local   = moved.partition().local_node[load.nodes[k]];
      const Vector3       tangent = axis.direction.cross(moved.place(local) - axis.point) / inner;
      raise_to(deviation, (moved.force(local) - load.areas[k] * traction * tangent).norm());
    }
  check_below("torque: constant traction along the circle [N]", deviation, 1e-12);
  for (std::size_t i = 0; i < moved.n(); ++i)
    moved.velocities.set(i, 30. * axis.direction.cross(moved.place(i) - axis.point));
  check_close("torque: its power at 30 rad/s, half [mJ/s]",
              torques.half_power(moved.velocities),
              .5 * 5000 * 30,
              1e-7);
}

/** On a face with a node on the axis, away from the origin: that node has no tangent. */
void torque_on_axis()
{
  Model model               = model_of({"bar", make_cylinder(8., 20., {{4, 1, 2}}), Material()});
  Body &bar                 = model.bodies.front();
  bar.placement.rotation    = rotation_about(Vector3(1., 2., 2.).normalized(), 1.3);
  bar.placement.translation = Vector3(50., -20., 10.);
  bar.axis                  = {bar.placement.translation, bar.placement.rotation.col(2)};
  model.torques.push_back(torque_on(model, "top", 5000));
  const Axis  axis = bar.axis;
  Moved       moved(std::move(model), bar.placement);
  TorqueLoads torques(moved.model, moved.partition());
  torques.add_forces(1., moved.positions, moved.forces);
  check_below("torque with a node on the axis: no resultant [N]", moved.resultant().norm(), 1e-9);
  check_close("torque with a node on the axis: its moment [N mm]",
              moved.moment(axis.point).dot(axis.direction),
              5000.,
              1e-8);
  moved.model.torques.front().nodes = moved.model.bodies.front().node_set("axis");
  moved.model.torques.front().areas.assign(moved.model.torques.front().nodes.size(), 1.);
  print_refusal([&] { const TorqueLoads none(moved.model, moved.partition()); });
}

void loads()
{
  const Vector3 vector(100., -200., 300.);
  for (const LoadKind kind : {LoadKind::force, LoadKind::acceleration, LoadKind::moment})
    {
      Model model = make_ring_model();
      Load  load;
      load.name   = "load";
      load.kind   = kind;
      load.vector = vector;
      load.nodes  = kind == LoadKind::acceleration ? all_nodes(model.bodies[0])
                                                   : model.bodies[0].node_set("top");
      model.loads.push_back(load);
      const Body  &ring = model.bodies.front();
      const double mass = ring.mass();
      Moved        moved(std::move(model),
                  [&](const Vector3 &X) { return Vector3(1.1 * X + Vector3(3., 4., 5.)); });
      NodalLoads   nodal(moved.model, moved.vfife, moved.communicator);
      nodal.add_part(.5, moved.positions, moved.forces);
      const std::string name  = kind == LoadKind::force          ? "force"
                                : kind == LoadKind::acceleration ? "acceleration"
                                                                 : "moment";
      const Vector3     force = (kind == LoadKind::force          ? .5
                                 : kind == LoadKind::acceleration ? .5 * mass
                                                                  : 0.) *
                            vector;
      // The ring's centre moves to (3, 4, 5), its top to 1.1 times its height above.
      const Vector3 centre =
        Vector3(3., 4., 5. + (kind == LoadKind::acceleration ? .55 : 1.1) * height);
      check_below(name + ": resultant less half of it [N]",
                  (moved.resultant() - force).norm(),
                  1e-9);
      check_below(name + ": moment about the centre [N mm]",
                  (moved.moment(centre) - (kind == LoadKind::moment ? .5 : 0.) * vector).norm(),
                  1e-8);
    }
}

void pressure()
{
  Model model = make_ring_model();
  model.loads.push_back(pressure_on(model.bodies[0].node_set("outer"), 7));
  const RigidMotion place = model.bodies[0].placement;
  // Twice as wide and half as high again: pressure acts on the present faces.
  Moved      moved(std::move(model),
              [&](const Vector3 &X) { return place(Vector3(2. * X[0], 2. * X[1], 1.5 * X[2])); });
  NodalLoads nodal(moved.model, moved.vfife, moved.communicator);
  nodal.add_forces(0., moved.positions, moved.forces);
  double inward = 0;
  for (std::size_t i = 0; i < moved.n(); ++i)
    {
      const Vector3 x = place.rotation.transpose() * (moved.place(i) - place.translation);
      const Vector3 r = place.rotation * Vector3(x[0], x[1], 0.).normalized();
      inward -= r.dot(moved.force(i));
    }
  // Chords of 2 R sin(pi/n), their normals pi/n from the nodes.
  const double half = pi / around, chord = 2 * 2 * outer * std::sin(half);
  check_close("pressure: sum towards the axis [N]",
              inward,
              7 * around * chord * 1.5 * height * std::cos(half),
              1e-8);
  check_below("pressure all around: no resultant [N]", moved.resultant().norm(), 1e-9);
}

Model make_sprung_bar()
{
  return model_of({"bar", make_block(Vector3(8., 2., 2.), {{4, 1, 1}}), Material()});
}

/** To the ground, at the bar's left end. */
Load make_spring(const Model &model, const Vector3 &stiffness)
{
  Load load;
  load.kind   = LoadKind::spring;
  load.vector = stiffness;
  load.nodes  = model.bodies[0].node_set("x-");
  return load;
}

void springs()
{
  Model model = make_sprung_bar();
  model.loads.push_back(make_spring(model, Vector3(1000., 0., 300.)));
  const Vector3 way(.01, .02, -.03);
  const double  corner = model.bodies[0].node_masses()[model.loads[0].nodes[0]];
  Moved         moved(std::move(model), [&](const Vector3 &X) { return Vector3(X + way); });
  NodalLoads    nodal(moved.model, moved.vfife, moved.communicator);
  nodal.add_forces(0., moved.positions, moved.forces);
  check_below("springs: -k times the way [N]",
              (moved.resultant() - Vector3(-10., 0., 9.)).norm(),
              1e-12);
  check_close("springs: energy [mJ]",
              nodal.compute_spring_energy(moved.positions),
              .5 * (1000. * 1e-4 + 300. * 9e-4),
              1e-14);
  // 4/dt^2 = 4/step^2 + k/m, a quarter of the stiffness on each corner
  const double step = 1e-6;
  check_ratio("springs: step",
              4 / std::pow(nodal.vote_on_step(step), 2) / (4 / (step * step) + 250. / corner),
              1e-12);
  NodalLoads none(moved.model, moved.vfife, moved.communicator);
  check_close(
    "springs: full whatever the part of the loads [N]",
    [&] {
      moved.forces.set_zero();
      none.add_part(0., moved.positions, moved.forces);
      return moved.resultant()[0];
    }(),
    -10.,
    1e-12);
}

/** Several springs act on a node with their stiffnesses added up along each direction. */
void springs_side_by_side()
{
  Model model = make_sprung_bar();
  for (const Vector3 &stiffness : {Vector3(1000., 0., 300.), Vector3(200., 100., 900.)})
    model.loads.push_back(make_spring(model, stiffness));
  const double     corner = model.bodies[0].node_masses()[model.loads[0].nodes[0]];
  Communicator     communicator(MPI_COMM_SELF);
  VfifeOperator    vfife(model, FrameKind::polar, StiffnessKind::incompatible_modes, communicator);
  const NodalLoads nodal(model, vfife, communicator);
  // 1200 N/mm along x and along z, a quarter on each corner.
  const double step = 1e-6;
  check_ratio("springs side by side: step",
              4 / std::pow(nodal.vote_on_step(step), 2) / (4 / (step * step) + 300. / corner),
              1e-12);
}

void wall()
{
  Model      model;
  const auto n = model.add_body({"bar", make_block(Vector3(8., 2., 2.), {{4, 2, 2}}), Material()});
  RigidWall  wall;
  wall.nodes  = model.bodies[n].node_set("x-");
  wall.point  = Vector3(-5., 100., 100.);
  wall.normal = Vector3(.8, .6, 0.);
  for (const double value : {3e4, 2e4})
    {
      wall.penalty.value = value;
      model.walls.push_back(wall);
    }
  // The end face lies 0.02 mm behind the wall, parallel to it.
  const Matrix3 turn  = rotation_about(Vector3::UnitZ(), std::atan2(.6, .8));
  const Vector3 start = wall.point - .02 * wall.normal;
  Moved      moved(std::move(model), [&](const Vector3 &X) { return Vector3(start + turn * X); });
  RigidWalls walls(moved.model, moved.partition(), moved.communicator);
  walls.add_forces(moved.positions, moved.forces);
  const double penalty = 5e4, force = penalty * .02 * 4.;
  check_below("walls: penalty times depth times area, along the normal [N]",
              (moved.resultant() - force * wall.normal).norm(),
              1e-9 * force);
  const RigidWalls::Results results = walls.collect_results();
  check_ratio("walls: force over its formula", results.force / force, 1e-12);
  check_ratio("walls: energy over force times half the depth",
              results.energy / (.01 * force),
              1e-10);
  check_close("walls: penetration [mm]", results.penetration, .02, 1e-12);
  // Pressure bears any step; springs that stick take their half: 4/dt^2 (1 - f/4) = 4/step^2.
  const double step = 1e-6;
  check_ratio("walls: step", walls.vote_on_step(step) / step, 1e-15);
  moved.model.walls[0].friction.coefficient = .1;
  const RigidWalls rough(moved.model, moved.partition(), moved.communicator);
  check_close("walls with friction: step",
              rough.vote_on_step(step) / step,
              std::sqrt(1. - .5 / 4.),
              1e-12);

  // By default the penalty is that of the facets, 5 E/(1 - nu^2)/h with h = 1 mm, whatever the
  // step.
  moved.model.walls.pop_back();
  moved.model.walls[0].penalty = PenaltyOptions(1);
  RigidWalls     stiff(moved.model, moved.partition(), moved.communicator);
  const Material steel;
  stiff.add_forces(moved.positions, moved.forces);
  check_ratio("walls: force with the penalty of the facets",
              stiff.collect_results().force * (1. - steel.poissons_ratio * steel.poissons_ratio) /
                (5. * steel.youngs_modulus * .02 * 4.),
              1e-10);
}

int main(int argc, char **argv)
{
  return run_parts(argc,
                   argv,
                   {torque, torque_on_axis, loads, pressure, springs, springs_side_by_side, wall});
}
