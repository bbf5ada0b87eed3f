// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Shear stress of a ring whose inner radius is turned against the outer one, as fields and probes
// have it, while the ring has turned about an axis askew: the closed form of plane elasticity.
#include "../model_parts.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/dynamics/watch/measurement.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/measures/node_stresses.h>

#include <array>

using namespace vfife;

constexpr double inner = 20, outer = 40, twist = 1e-4; // [mm], [mm], [rad]
/** u_theta = B (1/r - r/b^2): none outside, the twist inside [mm^2]. */
constexpr double B = twist * inner * inner * outer * outer / (outer * outer - inner * inner);

Model make_model()
{
  Body ring("ring", make_ring(inner, outer, 5, {{10, 96, 1}}), Material());
  place_on_axis(ring, Vector3(1, 2, 3), Vector3(1, 2, 2));
  return model_of(std::move(ring));
}

/** @p turn: of the body by now [rad]. */
State make_state(const Model &model, const VfifeOperator &vfife, const double turn)
{
  const Body   &ring = model.bodies[0];
  const Matrix3 now  = rotation_about(ring.axis.direction, turn) * ring.placement.rotation;
  State         state;
  state.partition = std::make_shared<const Partition>(vfife.partition());
  state.position = state.velocity = vfife.make_field();
  state.body_motion.push_back({now, ring.axis.point});
  for (const std::uint32_t i : vfife.partition().nodes())
    {
      const Vector3 &X = ring.node_positions()[vfife.partition().global_node[i]];
      const double   r = X.head<2>().norm(), u = B * (1 / r - r / (outer * outer));
      state.position.set(i, ring.axis.point + now * (X + u / r * Vector3(-X[1], X[0], 0.)));
    }
  return state;
}

/** Largest error of tau = G (du/dr - u/r) = -2 G B/r^2 inside, over tau there, and largest other
 * component. */
struct Errors
{
  double shear = 0, others = 0;

  void add(const double r, const std::array<double, 6> &stress)
  {
    const double tau = -2 * Material().mu() * B / (r * r);
    raise_to(shear, std::abs(stress[3] / tau - 1));
    for (const unsigned int c : {0, 1, 2, 4, 5})
      raise_to(others, std::abs(stress[c] / tau));
  }
};

void check_shear(const FrameKind frame, const double turn)
{
  Model       model = make_model();
  const Body &ring  = model.bodies[0];
  Errors      fields, probes;
  double      difference = 0;
  for (unsigned int i = 0; i < ring.n_nodes(); ++i)
    if (ring.node_positions()[i].head<2>().norm() > inner + 1 &&
        ring.node_positions()[i].head<2>().norm() < outer - 1 && i % 7 == 0)
      model.probes.push_back({"here", 0, i});
  const Communicator  alone(MPI_COMM_SELF);
  const auto          kind = StiffnessKind::incompatible_modes;
  const VfifeOperator vfife(model, frame, kind, alone);
  const State         state    = make_state(model, vfife, turn);
  const auto          stresses = compute_node_stresses(model, state, kind, frame, alone);
  const auto          values   = measure_probes(model, model.probes, state, vfife, alone);
  for (std::size_t p = 0; p < values.size(); ++p)
    {
      const unsigned int node = model.probes[p].node;
      const double       r    = ring.node_positions()[node].head<2>().norm();
      fields.add(r, stresses[node]);
      probes.add(r, values[p].stress);
      for (unsigned int c = 0; c < 6; ++c)
        raise_to(difference, std::abs(stresses[node][c] - values[p].stress[c]));
    }
  const std::string name = std::string(frame == FrameKind::polar ? "polar" : "three nodes") +
                           (turn == 0 ? ", at rest: " : ", turned: ");
  // Cells of 2 mm beside radii of 22 mm: h^2/r^2 of the closed form's variation, 0.8 %.
  check_below(name + "shear stress of fields over the closed form", fields.shear, 0.01);
  check_below(name + "other components", fields.others, 0.01);
  check_below(name + "shear stress of probes over the closed form", probes.shear, 0.01);
  check_below(name + "other components", probes.others, 0.01);
  // Fields take the sectors' elements for turned copies of one, probes each by itself.
  check_below(name + "fields over probes [MPa]", difference, 1e-8);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  for (const FrameKind frame : {FrameKind::polar, FrameKind::three_nodes})
    for (const double turn : {0., 2.5})
      check_shear(frame, turn);
  return 0;
}
