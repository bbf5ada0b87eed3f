// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Nodal update and operator in an instruction set (generic, or the one that is named) and in every
// layout give the same numbers; error of hourglass blocks in single precision; step without the
// worst elements.
#include "../instruction_sets.h"
#include "../model_parts.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/dynamics/motion/nodal_update.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/model.h>

#include <random>

using namespace vfife;

/** n numbers in [-1, 1], the same everywhere. */
std::vector<double> random_numbers(const std::size_t n)
{
  static std::mt19937 generator(5);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < n; ++i)
    numbers.push_back(2. * generator() / 4294967295. - 1.);
  return numbers;
}

Vector3 node(const std::vector<double> &records, const std::size_t i)
{
  return Eigen::Map<const Vector3>(&records[4 * i]);
}

/** The formulas of nodal_update.h, written down node by node; numbers of order one. */
void check_update(const InstructionSet set, const bool use_axis)
{
  // First and last node are not multiples of the lanes; the last ones must stay as they are.
  const std::size_t          n = 31, first = 3, last = 29;
  const double               dt = 0.25;
  std::vector<double>        x = random_numbers(4 * n), v = random_numbers(4 * n);
  const std::vector<double>  f = random_numbers(4 * n), x_old = x, v_old = v;
  std::vector<unsigned char> owned(n, 1);
  owned[5] = owned[6] = owned[12] = owned[28] = 0;
  const std::vector<double> more              = random_numbers(18);
  BodyDamping               damping;
  damping.zeta           = 0.7;
  damping.rigid.velocity = node(more, 0);
  damping.rigid.omega    = node(more, 1);
  damping.mesh.velocity  = node(more, 2);
  damping.mesh.omega     = node(more, 3);
  UpdateAxis axis;
  axis.use_axis  = use_axis;
  axis.direction = Vector3(1, 2, -2) / 3.;
  axis.point     = Vector3(0.3, -0.2, 0.9);

  const UpdateSums sums =
    update_nodes(first,
                 last,
                 dt,
                 damping,
                 axis,
                 {owned.data(), f.data(), x.data(), v.data(), x.data(), v.data()},
                 nullptr,
                 set);
  // The same beside the old state, and what is measured on the way.
  std::vector<double> x_beside = x_old, v_beside = v_old;
  NodalMotion         motion, motion_expected;
  const UpdateSums    sums_beside = update_nodes(
    first,
    last,
    dt,
    damping,
    axis,
    {owned.data(), f.data(), x_old.data(), v_old.data(), x_beside.data(), v_beside.data()},
    &motion,
    set);

  const double        a          = 0.5 * damping.zeta * dt;
  std::vector<double> x_expected = x_old, v_expected = v_old;
  UpdateSums          expected;
  for (std::size_t i = first; i < last; ++i)
    {
      const Vector3 u    = damping.rigid.at(node(x_old, i));
      const Vector3 slip = damping.mesh.at(node(x_old, i));
      const Vector3 w =
        ((1 - a) * node(v_old, i) + dt * (node(f, i) * x_old[4 * i + 3] - slip) + 2 * a * u) /
        (1 + a);
      Eigen::Map<Vector3>(v_expected.data() + 4 * i) = w;
      Eigen::Map<Vector3>(x_expected.data() + 4 * i) += dt * w;
      if (!owned[i])
        continue;
      const double  m    = v_old[4 * i + 3];
      const Vector3 mean = 0.5 * (node(v_old, i) + w);
      expected.kinetic += 0.5 * m * node(v_old, i).dot(w);
      expected.damping_power += damping.zeta * m * (mean - u).dot(mean);
      expected.mesh_power += m * slip.dot(mean);
      if (use_axis)
        expected.damping_torque -=
          damping.zeta * m *
          axis.direction.dot(Vector3((node(x_old, i) - axis.point).cross(mean - u)));
      add_node_moments(axis, m, node(x_expected, i), w, expected);
      motion_expected.add(axis, m, node(x_old, i), node(v_old, i), w);
    }
  const std::string name =
    std::string("update, ") + name_of(set) + (use_axis ? ", axis" : ", free");
  // Numbers of order one, sums of 26 of them.
  check_below(name + ": positions", largest_difference(x, x_expected), 1e-15);
  check_below(name + ": velocities", largest_difference(v, v_expected), 2e-15);
  check_below(name + ": sums",
              std::abs(sums.kinetic - expected.kinetic) +
                std::abs(sums.damping_power - expected.damping_power) +
                std::abs(sums.mesh_power - expected.mesh_power) +
                std::abs(sums.damping_torque - expected.damping_torque) +
                std::abs(sums.axial_momentum - expected.axial_momentum) +
                std::abs(sums.axial_inertia - expected.axial_inertia) +
                (sums.momentum - expected.momentum).norm() +
                (sums.first_moment - expected.first_moment).norm() +
                (sums.angular_momentum - expected.angular_momentum).norm() +
                (sums.second_moment - expected.second_moment).norm(),
              1e-13);
  check_below(name + ": beside the old state",
              largest_difference(x_beside, x) + largest_difference(v_beside, v) +
                std::abs(sums_beside.kinetic - sums.kinetic),
              1e-15);
  check_below(name + ": motion",
              (motion.momentum - motion_expected.momentum).norm() +
                (motion.angular_momentum - motion_expected.angular_momentum).norm() +
                std::abs(motion.speed - motion_expected.speed) +
                std::abs(motion.turning_mass - motion_expected.turning_mass) +
                std::abs(motion.mass - motion_expected.mass) +
                (motion.change - motion_expected.change).norm() +
                std::abs(motion.square_of_change - motion_expected.square_of_change),
              1e-13);
}

/** Forces of a disc turned and strained by @p strain, in the order of the model's nodes. */
std::vector<double>
compute_forces(const Model &model, const OperatorLayout &layout, const double strain)
{
  const Communicator alone(MPI_COMM_SELF);
  VfifeOperator    vfife(model, FrameKind::polar, StiffnessKind::incompatible_modes, alone, layout);
  const Partition &partition = vfife.partition();
  NodeField        positions = vfife.make_field(), forces = vfife.make_field();
  const Matrix3    turn = rotation_about(Vector3(1, -2, 2) / 3., 2.);
  for (const std::uint32_t i : partition.nodes())
    {
      const Vector3 X = model.bodies[0].node_positions()[partition.global_node[i]];
      positions.set(i,
                    turn *
                      (X + strain * Vector3(std::sin(X[1]), std::sin(2 * X[2]), std::cos(X[0]))));
    }
  vfife.compute_internal_forces(positions, forces);
  std::vector<double> sorted;
  for (const std::uint32_t local : partition.local_node)
    for (unsigned int c = 0; c < 3; ++c)
      sorted.push_back(forces.value(local)[c]);
  return sorted;
}

void check_worst_elements()
{
  // Three thin elements before eight cubes.
  Model model = model_of(Body("thin", make_block(Vector3(3, 1, 0.1), {{3, 1, 1}}), Material()));
  model.add_body(Body("thick", make_block(Vector3(8, 1, 1), {{8, 1, 1}}), Material()));
  const Communicator  alone(MPI_COMM_SELF);
  const VfifeOperator vfife(model, FrameKind::polar, StiffnessKind::incompatible_modes, alone);
  const double        step = vfife.limiting_element().stable_step();
  check("worst elements: without none", vfife.stable_step_without(0) == step);
  check("worst elements: without two of three alike", vfife.stable_step_without(2) == step);
  check("worst elements: without all thin ones", vfife.stable_step_without(3) > 3 * step);
  check("worst elements: more than there are",
        vfife.stable_step_without(100) == vfife.stable_step_without(3));
}

void check_layouts(const InstructionSet set)
{
  Model          model = model_of(Body("disc", make_disc(5., 2., {{4, 3, 3}}), Material()));
  OperatorLayout plain;
  plain.instruction_set  = InstructionSet::generic;
  const auto   reference = compute_forces(model, plain, 1e-3);
  const double size      = largest_size(reference);

  OperatorLayout layout;
  layout.instruction_set = set;
  const std::string name = std::string("forces, ") + name_of(set);
  // Coordinates of 5 mm in elements of 1 mm strained by 1e-3 lose four digits of sixteen.
  layout.share_constants  = true;
  layout.single_hourglass = false;
  check_below(name + ", shared",
              largest_difference(compute_forces(model, layout, 1e-3), reference) / size,
              1e-11);
  layout.share_constants = false;
  check_below(name + ", own",
              largest_difference(compute_forces(model, layout, 1e-3), reference) / size,
              1e-11);
  // Single precision rounds by at most 6e-8 of each number of H; more than round-off shows
  // that it is in use.
  layout.single_hourglass = true;
  const double single = largest_difference(compute_forces(model, layout, 1e-3), reference) / size;
  check(name + ", own, single", single > 1e-11 && single < 6e-8);
  const double rigid = largest_size(compute_forces(model, layout, 0.));
  // 2e5 MPa x 5 mm x 1 mm x 1e-16 times some operations.
  check_below(name + ", own, single: rigid rotation gives no force", rigid, 2e-9);
}

void check_set(const InstructionSet set)
{
  for (const bool use_axis : {true, false})
    check_update(set, use_axis);
  check_layouts(set);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  if (argc > 1)
    return run_instruction_set(argv[1], check_set);
  check_set(InstructionSet::generic);
  check_worst_elements();
  return 0;
}
