// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Unloaded tooth contact analysis against the recipe's numbers and against a search for the
// smallest gap.
#include "../tests.h"
#include "gap_search.h"
#include "paper_pair.h"

#include <vfife/gear/unloaded_contact/unloaded_contact.h>

using namespace vfife;

void check_lag(const GearPair &pair, const UnloadedContact &drive)
{
  double worst = 0, worst_search = 0, worst_geometry = 0;
  for (double p = -0.9; p <= 1.001; p += 0.1)
    {
      const double               rot1  = drive.reference() + p * drive.pitch();
      const UnloadedContactPoint point = drive.contact(rot1, 0);
      const double               fit   = 7.199 * p * p + 0.757 * p * p * p - 0.008 * p * p * p * p;
      raise_to(worst, std::abs(point.lag / arcsecond - fit));
      const RigidMotion one = pair.pinion_placement(rot1), other = pair.gear_placement(point.rot2);
      worst_geometry = largest_of(
        {worst_geometry,
         (one(point.pinion.position) - other(point.gear.position)).norm(),
         (one.rotation * point.pinion.normal + other.rotation * point.gear.normal).norm(),
         (one(point.pinion.position) - point.position).norm()});
      if (std::abs(p) < 0.81)
        {
          // start the search well beside the point of contact
          const double rot2 =
            gap_search(pair, MeshSide::drive, rot1, point.pinion_L_h + Vector2(0.8, -0.2));
          raise_to(worst_search, std::abs(rot2 - point.rot2) / arcsecond);
        }
    }
  check_below("lag against the recipe's polynomial [arcsec]", worst, 0.01);
  check_below("lag against the gap search, |p| <= 0.8 [arcsec]", worst_search, 0.002);
  check_below("points and normals coincide [mm]", worst_geometry, 1e-11);
}

void check_hand_over(const GearPair &pair, const UnloadedContact &drive)
{
  const double               hand_over = drive.reference() + 0.487 * drive.pitch();
  const UnloadedContactPoint before    = drive.contact(hand_over, 0),
                             after     = drive.contact(hand_over, -1);
  // the place is rounded to 0.0005 pitches, where the two lags cross with slopes of 7.5 arcsec a
  // pitch
  check_close("lag at the transfer point, pair 0 [arcsec]", before.lag / arcsecond, 1.795, 0.005);
  check_close("lag at the transfer point, pair -1 [arcsec]", after.lag / arcsecond, 1.795, 0.005);
  check("pair 0 touches before, pair -1 after",
        drive.touching(hand_over - 0.01 * drive.pitch()).pair == 0 &&
          drive.touching(hand_over + 0.01 * drive.pitch()).pair == -1);

  // one pitch later everything repeats, a gear pitch further
  const UnloadedContactPoint here = drive.touching(drive.reference() + 0.2 * drive.pitch());
  const UnloadedContactPoint next = drive.touching(drive.reference() + 1.2 * drive.pitch());
  check("next pair", here.pair == 0 && next.pair == -1);
  check_close("next lag", next.lag, here.lag, 1e-13);
  check_close("next gear rotation", next.rot2, here.rot2 - pair.gear().pitch(), 1e-13);
  check_close("lag is the deviation of the gear",
              here.rot2 - pair.rot2_reference() +
                pair.speed_ratio() * (here.rot1 - pair.rot1_reference()),
              here.lag,
              1e-13);
}

void check_path(const UnloadedContact &drive)
{
  // the recipe found -0.960 and 1.000 on a grid of 0.02; the borders themselves lie within one step
  // of it
  const auto range = drive.path_range();
  check("path range",
        range.first / drive.pitch() <= -0.960 && range.first / drive.pitch() > -0.980 &&
          range.second / drive.pitch() >= 1.000 && range.second / drive.pitch() < 1.020);
  check_close("contact ratio of the path",
              (range.second - range.first) / drive.pitch(),
              1.97,
              0.01);
  check_close("path starts at L2 [mm]",
              drive.contact(drive.reference() - 0.96 * drive.pitch(), 0).gear_L_h[0],
              121.0,
              0.06);
  check_close("path ends at L2 [mm]",
              drive.contact(drive.reference() + drive.pitch(), 0).gear_L_h[0],
              111.7,
              0.06);
}

void check_coast(const GearPair &pair, const UnloadedContact &drive, const UnloadedContact &coast)
{
  // coast: plausible only (no reference): a lag of a few arcsec, centred, on both flanks over more
  // than a pitch
  const auto   coast_range = coast.path_range();
  const double half        = coast.pitch() / 2;
  check("coast path spans more than a pitch about the mean contact",
        coast_range.first < -half && coast_range.second > half);
  for (const double sign : {-1., 1.})
    {
      const double lag = coast.contact(coast.reference() + sign * half, 0).lag / arcsecond;
      check("coast lag half a pitch away between 0.1 and 5 arcsec", lag > 0.1 && lag < 5.);
    }
  // between the touching drive and coast flanks the gear can be turned by the backlash; the
  // transmission errors of both sides differ from it by a few arcsec
  const double play =
    drive.touching(pair.rot1_reference()).rot2 - coast.touching(pair.rot1_reference()).rot2;
  check_close("backlash angle of the gear [arcsec]",
              play / arcsecond,
              pair.backlash_angle() / arcsecond,
              5.);
}

/** Ellipse at 6.35 um, its inclination and that of the path to the lengthwise direction of the gear
 * tooth. */
void check_ellipse(const GearPair &pair, const UnloadedContact &drive)
{
  const UnloadedContactPoint point   = drive.contact(drive.reference(), 0);
  const ContactEllipse       ellipse = drive.ellipse(point, 0.00635);
  // half a unit of the last digit given
  check_close("smaller relative curvature", ellipse.relative_curvatures[0], 4.0749e-4, 6e-9);
  check_close("larger relative curvature", ellipse.relative_curvatures[1], 6.0966e-2, 6e-7);
  check_close("ellipse along", ellipse.semi_axes[0], 5.583, 6e-4);
  check_close("ellipse across", ellipse.semi_axes[1], 0.456, 6e-4);

  const Matrix3 R     = pair.gear_placement(point.rot2).rotation;
  const Flank  &flank = pair.gear().generated_flank(pair.gear_side(MeshSide::drive));
  const double  L = point.gear_L_h[0], h = point.gear_L_h[1], e = 1e-3;
  const Vector3 lengthwise =
    (R * (flank.point_at(L + e, h).position - flank.point_at(L - e, h).position)).normalized();
  const Vector3 across = point.normal.cross(lengthwise);
  const auto    angle  = [&](const Vector3 &direction) {
    return std::atan(direction.dot(across) / direction.dot(lengthwise)) / degree;
  };
  check_close("major axis to the lengthwise direction [deg]",
              angle(ellipse.major_direction),
              -10.5,
              0.05);
  const double step = 0.01 * drive.pitch();
  check_close("path to the lengthwise direction [deg]",
              angle(R * (drive.contact(drive.reference() + step, 0).gear.position -
                         drive.contact(drive.reference() - step, 0).gear.position)),
              20.,
              0.5);
}

/** Turn of the gear to the drive and coast flank when it is mounted 0.1 mm too near to the apex. */
void check_mounting(const GearPair &pair)
{
  GearPairOptions options  = paper::options();
  options.gear_axial_shift = -0.1;
  const GearPair shifted(options);
  const double   expected[2] = {-35.6, 111.6};
  for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
    {
      const UnloadedContact before(pair, side), after(shifted, side);
      const double          rot1 = before.reference();
      check_close("gear shifted by -0.1 mm, " +
                    std::string(side == MeshSide::drive ? "drive" : "coast") + " limit [arcsec]",
                  (after.touching(rot1).rot2 - before.touching(rot1).rot2) / arcsecond,
                  expected[side == MeshSide::drive ? 0 : 1],
                  0.06);
    }
  // points of a pair with every error coincide in the placements
  options.pinion_axial_shift = 0.02;
  options.offset             = -0.03;
  options.shaft_angle_error  = 0.01 * degree;
  const GearPair             skew(options);
  const UnloadedContact      drive(skew);
  const UnloadedContactPoint point = drive.touching(skew.rot1_reference());
  const RigidMotion one   = skew.pinion_placement(point.rot1 + point.pair * skew.pinion().pitch());
  const RigidMotion other = skew.gear_placement(point.rot2 - point.pair * skew.gear().pitch());
  check_below("skew pair: points coincide [mm]",
              (one(point.pinion.position) - other(point.gear.position)).norm(),
              1e-11);
  check_below("skew pair: normals are opposite",
              (one.rotation * point.pinion.normal + other.rotation * point.gear.normal).norm(),
              1e-11);
}

int main()
{
  const GearPair        pair(paper::options());
  const UnloadedContact drive(pair), coast(pair, MeshSide::coast);
  check_lag(pair, drive);
  check_hand_over(pair, drive);
  check_path(drive);
  check_coast(pair, drive, coast);
  check_ellipse(pair, drive);
  check_mounting(pair);
  return 0;
}
