// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// How bodies are cut into shares, what find_shares() says of them, and that ranks send just that.
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/dynamics/operator/rank_shares.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/model.h>

using namespace vfife;

Model make_model(const std::array<unsigned int, 3> &first, const std::array<unsigned int, 3> &other)
{
  Model model;
  model.add_body(
    Body("block", make_block(Vector3(first[0], first[1], first[2]), first), Material()));
  model.add_body(Body("bar", make_block(Vector3(other[0], other[1], other[2]), other), Material()));
  return model;
}

/** A cube of 8 x 8 x 8 cells on eight ranks is eight cubes of 4 x 4 x 4: each has 3 neighbours
 * across a face of 25 nodes, 3 across an edge of 5 and 1 across a corner. A bar of 32 x 1 x 1 is
 * cut across, four nodes a cut, and none of its pieces has more than two neighbours. */
void check_cuts()
{
  const Model                  cube   = make_model({{8, 8, 8}}, {{1, 1, 1}});
  const std::vector<RankShare> shares = find_shares(cube, 8);
  // The one cell of the other body belongs to one rank and is no neighbour's.
  const bool cubes = std::all_of(shares.begin(), shares.end(), [](const RankShare &share) {
    return share.n_sent == 3 * 25 + 3 * 5 + 1 && share.n_neighbours == 7 &&
           (share.n_elements() == 64 || share.n_elements() == 65);
  });
  check("a cube is cut into cubes", cubes);

  Model bar;
  bar.add_body(Body("bar", make_block(Vector3(32, 1, 1), {{32, 1, 1}}), Material()));
  const auto of_bar = find_shares(bar, 16);
  check("a bar is cut across",
        std::all_of(of_bar.begin(), of_bar.end(), [](const RankShare &share) {
          return share.n_elements() == 2 && share.n_sent == 4 * share.n_neighbours &&
                 (share.n_neighbours == 1 || share.n_neighbours == 2);
        }));
  const auto    odd = find_shares(make_model({{7, 5, 3}}, {{11, 2, 1}}), 6);
  std::uint64_t sum = 0, least = odd[0].n_elements(), most = 0;
  for (const RankShare &share : odd)
    {
      sum += share.n_elements();
      least = std::min(least, share.n_elements());
      most  = std::max(most, share.n_elements());
    }
  check("every element has a rank, and ranks have equal shares",
        sum == 105 + 22 && most - least <= 2);
}

void check_traffic(const Communicator &world)
{
  const Model   model = make_model({{7, 5, 3}}, {{11, 2, 1}});
  VfifeOperator vfife(model, FrameKind::polar, StiffnessKind::full, world);
  NodeField     positions = vfife.make_field(), forces = vfife.make_field();
  const auto   &partition = vfife.partition();
  for (unsigned int b = 0; b < model.bodies.size(); ++b)
    for (const std::uint32_t i : partition.nodes(b))
      positions.set(
        i, model.bodies[b].node_positions()[partition.global_node[i] - model.bodies[b].first_node]);
  const Traffic before = world.traffic();
  vfife.compute_internal_forces(positions, forces);
  const Traffic   sent  = world.traffic() - before;
  const RankShare share = find_shares(model, world.size())[world.rank()];
  const bool same = sent.messages == share.n_neighbours && sent.message_bytes == share.bytes() &&
                    sent.reductions == 0 && share.n_elements() == vfife.n_local_elements();
  const bool all_same  = world.all(same);
  const bool all_sends = world.all(sent.messages > 0);
  if (world.is_root())
    check("ranks send what their shares say", all_same && all_sends);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  if (session.world().is_root())
    check_cuts();
  check_traffic(session.world());
  return 0;
}
