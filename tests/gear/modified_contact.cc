// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Unloaded contact of pairs whose pinion is cut with modified roll or a tilted cutter, against the
// search for the smallest gap, which knows neither normals nor the equation of meshing.
#include "../tests.h"
#include "gap_search.h"
#include "paper_pair.h"

#include <vfife/gear/unloaded_contact/contact_analysis.h>

using namespace vfife;

MachineSettings &pinion_settings(GearPairOptions &options, const MeshSide side)
{
  // drive: concave on convex
  return side == MeshSide::drive ? options.pinion.concave : options.pinion.convex;
}

double lag_at(const GearPair &pair, const MeshSide side, const double pitches)
{
  const UnloadedContact contact(pair, side);
  return contact.contact(contact.reference() + pitches * contact.pitch(), 0).lag / arcsecond;
}

/** Both the solution of the equations and the search, at places over a pitch. */
void check_search(const std::string &name, const GearPair &pair, const MeshSide side)
{
  const UnloadedContact contact(pair, side);
  double                worst = 0.;
  for (double p = -0.6; p < 0.61; p += 0.3)
    {
      const double rot1   = contact.reference() + p * contact.pitch();
      const auto   point  = contact.contact(rot1, 0);
      const double turned = rot1 + pair.pinion().turn(pair.pinion_side(side));
      // start well beside the point of contact
      const double rot2 = gap_search(pair, side, turned, point.pinion_L_h + Vector2(0.8, -0.2));
      raise_to(worst, std::abs(std::remainder(rot2 - point.rot2, 2. * pi)) / arcsecond);
    }
  check_below(name + ": lag against the search [arcsec]", worst, 0.002);
}
/**
 * With psi = Ra (phi - C phi^2 - D phi^3) the blank is behind by Ra (C phi^2 + D phi^3) where
 * phi = theta/Ra. On the flank that pushes on the drive side that is metal missing, which
 * changes the gear's lag by z1/z2 times it. First order: the contact point stays.
 */
void check_roll(const GearPair &plain, const MeshSide side, const double C, const double D)
{
  GearPairOptions options                          = paper::options();
  pinion_settings(options, side).second_order_roll = C;
  pinion_settings(options, side).third_order_roll  = D;
  const GearPair    pair(options);
  const std::string name =
    side_name(side) + (D == 0. ? ", second-order roll" : ", third-order roll");
  check_search(name, pair, side);
  const double Ra   = pair.mean_contact(side).ratio_of_roll;
  const double sign = side == MeshSide::drive ? 1. : -1.;
  for (const double p : {-.5, .5})
    {
      // at growing p the cradle turns back: phi = -theta/Ra
      const double phi      = -p * pair.pinion().pitch() / Ra;
      const double expected = sign * pair.speed_ratio() * Ra * (C + D * phi) * phi * phi;
      // its next order is about phi
      check_ratio(name + ": change of the lag over what the roll says",
                  (lag_at(pair, side, p) - lag_at(plain, side, p)) * arcsecond / expected,
                  .015);
    }
}

void check_tilt(const GearPair &plain, const MeshSide side)
{
  GearPairOptions options                      = paper::options();
  pinion_settings(options, side).cutter_tilt   = .5 * degree;
  pinion_settings(options, side).cutter_swivel = -pi / 2.;
  const GearPair pair(options);
  check_search(side_name(side) + ", tilted cutter", pair, side);
  check(side_name(side) + ", tilted cutter: another lag",
        std::abs(lag_at(pair, side, .5) - lag_at(plain, side, .5)) > .1);
}

int main()
{
  const GearPair plain(paper::options());
  for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
    {
      check_search(side_name(side), plain, side);
      check_roll(plain, side, .005, 0.);
      check_roll(plain, side, 0., .1);
      check_tilt(plain, side);
    }
  return 0;
}
