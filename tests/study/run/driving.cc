// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The model of a pair with either member driving, in both directions: the working flanks stand
// together at the start, the driver pushes, the load holds against it.
#include "../quick_pair.h"

#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/study/cases/gear/gear_case.h>

#include <deal.II/base/parameter_handler.h>

using namespace vfife;

/** Distance about its axis of a member's flank (of any tooth) from a point in the fixed frame. */
double distance_of_flank(const GearMember &member,
                         const FlankSide   side,
                         const Body       &body,
                         const Vector3    &P)
{
  const Vector3 x     = body.placement.rotation.transpose() * (P - body.placement.translation);
  const double  r     = std::hypot(x[0], x[1]);
  const Vector2 L_h   = member.blank().cone_coordinates({r, x[2]});
  const Vector3 flank = member.flank_point(side, L_h[0], L_h[1]).position;
  const double  angle = std::atan2(x[1], x[0]) - std::atan2(flank[1], flank[0]);
  return r * std::remainder(angle, member.pitch());
}

void check_model(const std::string &driving, const std::string &direction, const MeshSide side)
{
  const std::string name = driving + " drives, " + direction;
  std::ofstream("driving.prm") << quick_pair("set body type = rim only",
                                             "set elements through rim = 2",
                                             "0.01")
                               << "subsection Operation\n  set driving member = " << driving
                               << "\n  set direction of rotation = " << direction << "\nend\n";
  const ParameterFile      file("driving.prm");
  GearCase                 gear_case;
  dealii::ParameterHandler prm;
  gear_case.declare(prm, file);
  file.read_known(prm);
  std::ostringstream  text;
  Log                 log(text, true, Verbosity::quiet);
  const Model         model = gear_case.make_model(log);
  const GearPair      pair  = gear_case.make_pair();
  const Transmission &t     = *model.only_transmission();
  const ContactPair  &first = model.contacts.front();

  check(name + ": side", first.side == side_name(side) && gear_case.working_side() == side);
  check(name + ": driver and driven",
        model.bodies[t.driver].name() == driving && first.slave_body == t.driver &&
          first.master_body == t.driven && t.driven != t.driver);
  // round-off of coordinates of 100 mm
  check_below(
    name + ": pinion flank through the mean contact [mm]",
    distance_of_flank(pair.pinion(), pair.pinion_side(side), model.bodies[0], t.contact_point),
    1e-10);
  check_below(
    name + ": gear flank through the mean contact [mm]",
    distance_of_flank(pair.gear(), pair.gear_side(side), model.bodies[1], t.contact_point),
    1e-10);

  // the normal leads out of the driven member: the driver pushes along -n
  const auto moment = [&](const unsigned int body) {
    const Axis &axis = model.bodies[body].axis;
    return axis.direction.dot((t.contact_point - axis.point).cross(-t.contact_normal));
  };
  check_close(name + ": the push turns the driven member",
              t.driven_sense * moment(t.driven),
              t.arm,
              1e-9);
  check(name + ": and holds the driver", t.driver_sense * moment(t.driver) > 0.);
  check(name + ": the load is against the rotation",
        model.torques.front().body == t.driven &&
          model.torques.front().value * t.driven_sense < 0.);
  const double sense = direction == "forward" ? 1. : -1.;
  check_close(name + ": rate of the pinion", model.bodies[0].rate, sense * 20000. * pi / 30., 1e-9);
  check_close(name + ": exact ratio",
              model.bodies[1].rate / model.bodies[0].rate,
              -27. / 79.,
              1e-14);
  check_close(name + ": driver's rate",
              t.driver_rate * t.driver_sense,
              model.bodies[t.driver].rate,
              1e-9);
}

int main(int argc, char **argv)
{
  const MpiSession session(argc, argv);
  check_model("pinion", "forward", MeshSide::drive);
  check_model("pinion", "reverse", MeshSide::coast);
  check_model("gear", "forward", MeshSide::coast);
  check_model("gear", "reverse", MeshSide::drive);
  return 0;
}
