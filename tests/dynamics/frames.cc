// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One revolution of a free block in both element frames: leak of angular momentum, and whether it
// matters from which corner the nodes are numbered.
#include "../tests.h"
#include "one_solver.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/element/frame.h>
#include <vfife/mesh/body_mesh.h>

using namespace vfife;

const Vector3    size(20, 10, 4);
constexpr double rate = 20000;

struct Spin
{
  double  leak = 0; ///< change of the angular momentum over itself
  Vector3 corner;   ///< place of the corner that starts at the origin
};

/** @p turned: the block stands on its head, turned by 180 degrees about its short axis in the
 * body frame: numbering then starts at the opposite edge of the same block. */
Spin spin(const FrameKind frame, const bool turned)
{
  Model model;
  Body  block("block", make_block(size, {{8, 4, 2}}), Material());
  if (turned)
    {
      block.placement.rotation    = rotation_about(Vector3::UnitZ(), pi);
      block.placement.translation = Vector3(size[0], size[1], 0);
    }
  block.axis.point = 0.5 * size;
  block.rate       = rate;
  model.add_body(std::move(block));
  DynamicsOptions options = undamped();
  options.frame           = frame;
  options.safety          = 0.5;
  OneSolver run(model, options);
  Vector3   first     = Vector3::Zero(), last;
  auto      observers = watch(1, [&](const State &state) {
    if (state.step == 0)
      first = state.measured.angular_momentum;
    last = state.measured.angular_momentum;
  });
  run.solver.run(run.state, 2 * pi / rate, observers);

  Spin          result;
  const Vector3 start(turned ? size[0] : 0, turned ? size[1] : 0, 0);
  result.leak = (last - first).norm() / first.norm();
  for (unsigned int n = 0; n < model.bodies[0].n_nodes(); ++n)
    if ((model.bodies[0].node_positions()[n] - start).norm() < 1e-9)
      result.corner = run.state.node_position(run.state.partition->local_node[n]);
  return result;
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  for (const FrameKind frame : {FrameKind::polar, FrameKind::three_nodes})
    {
      const Spin   one = spin(frame, false), other = spin(frame, true);
      const double difference = (one.corner - other.corner).norm();
      if (argc > 1)
        std::cout << word_of(frame, frame_choices()) << " leak " << one.leak << ' ' << other.leak
                  << ", numbering " << difference << " mm" << std::endl;
      if (frame == FrameKind::polar)
        {
          // Round-off of some 500 steps.
          check_below("polar: leak of angular momentum", largest_of(one.leak, other.leak), 1e-12);
          check_below("polar: numbering [mm]", difference, 1e-10);
        }
      else
        {
          // Moments of the order of the strain, 1e-3, times the strain; doc/theory/element.md has
          // the numbers.
          check("three nodes: leaks, but little", one.leak > 1e-8 && one.leak < 1e-4);
          check("three nodes: numbering matters, but little",
                difference > 1e-7 && difference < 1e-3);
        }
    }
  return 0;
}
