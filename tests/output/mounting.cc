// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// How two members stand to each other: the mounting errors of a pair are found again from where
// they put its members, and the motion of its bores tells the same.
#include "../gear/paper_pair.h"
#include "../made_state.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/output/measures/mounting.h>
#include <vfife/output/measures/pair_mounting.h>

using namespace vfife;

MountedMember member(const RigidMotion &placement)
{
  return {placement.translation, placement.rotation.col(2)};
}

void check_mounting(const std::string &name, const Mounting &found, const GearPairOptions &asked)
{
  check_close(name + "offset [mm]", found.offset, asked.offset, 1e-12);
  check_close(name + "pinion shift [mm]", found.pinion_shift, asked.pinion_axial_shift, 1e-12);
  check_close(name + "gear shift [mm]", found.gear_shift, asked.gear_axial_shift, 1e-12);
  check_close(name + "shaft angle [rad]", found.shaft_angle, asked.shaft_angle_error, 1e-14);
}

GearPairOptions with_errors()
{
  GearPairOptions asked    = paper::options();
  asked.offset             = -0.03;
  asked.pinion_axial_shift = 0.05;
  asked.gear_axial_shift   = -0.07;
  asked.shaft_angle_error  = 2e-4;
  return asked;
}

void placements()
{
  const GearPair designed(paper::options()), mounted(with_errors());
  // A turn about its own axis changes no member's mounting.
  const auto mounting = [](const GearPair &pair) {
    return find_mounting(member(pair.pinion_placement(0.3)), member(pair.gear_placement(-1.)));
  };
  check_mounting("", mounting(mounted) - mounting(designed), with_errors());
  check("parallel axes are refused",
        refuses<NumericalError>([] { find_mounting(MountedMember(), MountedMember()); }));
}

/** Rings on shafts that stand where the pair's members do, moved to where the errors put them and
 * turned about their own axes. */
void bores()
{
  const GearPair designed(paper::options()), mounted(with_errors());
  Model          model;
  Transmission   t;
  for (unsigned int b = 0; b < 2; ++b)
    {
      Body body(b == 0 ? "pinion" : "gear", make_ring(20., 30., 12., {{1, 12, 2}}), Material());
      body.placement     = b == 0 ? designed.pinion_placement(0.) : designed.gear_placement(0.);
      body.axis          = {body.placement.translation, body.placement.rotation.col(2)};
      body.turns_on_axis = body.floats = true;
      model.add_body(std::move(body));
    }
  t.driver_bore       = model.bodies[0].node_set("inner");
  t.driven_bore       = model.bodies[1].node_set("inner");
  model.transmissions = {t};
  const PairMounting mounting(model);
  const auto         moved = [&](const Body &body, const unsigned int i, const double turn) {
    const RigidMotion to =
      body.name() == "pinion" ? mounted.pinion_placement(turn) : mounted.gear_placement(turn);
    return to(body.node_positions()[i]);
  };
  const State state =
    made_state(model, [&](const Body &body, const unsigned int i, const Vector3 &) {
      return moved(body, i, body.name() == "pinion" ? 2.5 : -0.9);
    });
  check_mounting(
    "bores of a state: ", mounting.measure(state, Communicator(MPI_COMM_SELF)), with_errors());

  check_mounting("bores by their motions: ",
                 mounting.measure([&](const unsigned int b, const BodyRing &bore) {
                   return bore.measure([&](const std::size_t i) {
                     return moved(model.bodies[b], bore.nodes()[i], b == 0 ? 1.3 : -.2);
                   });
                 }),
                 with_errors());
  // A driver that turns as prescribed stays where it is.
  model.transmissions.front().driver_bore.clear();
  const Mounting gear_alone = PairMounting(model).measure(state, Communicator(MPI_COMM_SELF));
  check_close("the gear alone: its shift", gear_alone.gear_shift, -0.07, 1e-12);
  check_below("the gear alone: none of the pinion", gear_alone.pinion_shift, 1e-12);
}

int main(int argc, char **argv)
{
  return run_parts(argc, argv, {placements, bores});
}
