// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The paper's pair: derived settings, mean contact, assembly and backlash.
#include "../refusal.h"
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/gear/unloaded_contact/unloaded_contact.h>

using namespace vfife;

struct Reference
{
  std::string name;
  double      t, phi, s, L, h;
  Vector3     position, normal;
  Vector2     curvatures;
};

void compare(const Reference &reference, const Flank &flank, const GeneratedPoint &point)
{
  const Vector2 L_h        = flank.cone_coordinates(point.position);
  const Vector2 curvatures = flank.principal_curvatures(point);
  // half a unit of the last digit of the reference, somewhat rounded up
  check_close(reference.name + " t", point.t, reference.t, 1e-11);
  check_close(reference.name + " phi", point.phi, reference.phi, 1e-11);
  check_close(reference.name + " s", point.s, reference.s, 6e-6);
  check_close(reference.name + " L", L_h[0], reference.L, 6e-6);
  check_close(reference.name + " h", L_h[1], reference.h, 6e-6);
  check_below(reference.name + " position", (point.position - reference.position).norm(), 1e-6);
  check_below(reference.name + " normal", (point.normal - reference.normal).norm(), 1e-8);
  check_below(reference.name + " curvatures", (curvatures - reference.curvatures).norm(), 1e-7);
}

/** Distance and sum of normals of two flanks of tooth 0 (or tooth @p gear_tooth) placed at (rot1,
 * rot2). */
Vector2 mismatch(const GearPair &pair,
                 const MeshSide  side,
                 const double    rot1,
                 const double    rot2,
                 const int       gear_tooth)
{
  const MeanContact &mean = pair.mean_contact(side);
  const SurfacePoint a =
    pair.pinion().flank_point(pair.pinion_side(side), mean.pinion_L_h[0], mean.pinion_L_h[1]);
  const SurfacePoint b =
    pair.gear().flank_point(pair.gear_side(side), mean.gear_L_h[0], mean.gear_L_h[1]);
  const RigidMotion one   = pair.pinion_placement(rot1);
  const RigidMotion other = pair.gear_placement(rot2 + gear_tooth * pair.gear().pitch());
  return {(one(a.position) - other(b.position)).norm(),
          (one.rotation * a.normal + other.rotation * b.normal).norm()};
}

void check_derived(const GearPair &pair)
{
  const MeanContact &drive = pair.mean_contact(MeshSide::drive),
                    &coast = pair.mean_contact(MeshSide::coast);
  // 12 decimals are given; the iteration converges to round-off, which the stiffest value (phi)
  // feels most
  check_close("gear ratio of roll",
              pair.options().gear.convex.ratio_of_roll,
              1.056331241780,
              1e-11);
  check_close("gear outside point radius", pair.options().gear.concave.point_radius, 96.24, 1e-12);
  check_close("pinion concave ratio of roll", drive.ratio_of_roll, 3.005081151868, 1e-11);
  check_close("pinion convex ratio of roll", coast.ratio_of_roll, 3.130726290317, 1e-11);
  check_close("drive rot1", pair.rot1_reference(), 0.028971339436, 1e-11);
  check_close("drive rot2", pair.rot2_reference(), 0.007960674385, 1e-11);
  check_close("coast rot1", coast.rot1, 0.026965160191, 1e-11);
  check_close("coast rot2", coast.rot2, -0.005861632985, 1e-11);
  check_close("DELTA", pair.thickness_turn(), -0.038533425504, 1e-8); // its arm is rounded
  check_close("backlash [arcsec]", pair.backlash_angle() / arcsecond, 276., 0.5);
  check_close("mean arm", (drive.arm + coast.arm) / 2, 89.665, 0.0006);
  check_close("drive arm", drive.arm, 90.075, 0.0006);
}

void check_mean_contact(const GearPair &pair)
{
  const MeanContact &drive = pair.mean_contact(MeshSide::drive),
                    &coast = pair.mean_contact(MeshSide::coast);
  const GearMember &pinion = pair.pinion(), &gear = pair.gear();
  compare({"pinion concave",
           1.033237239627,
           0,
           2.73253,
           116.32157,
           0.65659,
           {38.237758, 0.444546, 109.858161},
           {-0.17757643, -0.80715939, 0.56299230},
           {-0.0094825, 0.0532374}},
          pinion.generated_flank(FlankSide::concave),
          drive.pinion);
  compare({"gear convex",
           -1.043309155042,
           -0.007536153500,
           3.51791,
           116.32176,
           -0.62323,
           {109.842325, -2.426491, 38.208835},
           {-0.56943817, -0.80745711, 0.15412069},
           {0.0068592, 0.0107594}},
          gear.generated_flank(FlankSide::convex),
          drive.gear);
  compare({"pinion convex",
           1.083187008340,
           0,
           2.82279,
           116.42882,
           0.84688,
           {38.346701, -2.885141, 109.898107},
           {-0.46078135, 0.83017657, -0.31382703},
           {0.0095677, 0.0512774}},
          pinion.generated_flank(FlankSide::convex),
          coast.pinion);
  compare({"gear concave",
           -1.055026769599,
           0.005549048209,
           3.33185,
           116.42915,
           -0.79970,
           {109.885374, 2.494339, 38.410549},
           {0.30903007, 0.81927672, 0.48299697},
           {-0.0094543, 0.0070997}},
          gear.generated_flank(FlankSide::concave),
          coast.gear);
}

void check_teeth(const GearPair &pair)
{
  const GearMember &pinion = pair.pinion(), &gear = pair.gear();
  check("pinion tooth from convex to concave",
        pinion.lower_side() == FlankSide::convex && pinion.upper_side() == FlankSide::concave);
  check("gear tooth from concave to convex",
        gear.lower_side() == FlankSide::concave && gear.upper_side() == FlankSide::convex);
  check_close("gear slot turn", gear.turn(FlankSide::concave), -2 * pi / 79, 1e-15);
  const double thickness[2][3] = {{2.690, 3.171, 3.486}, {4.756, 5.448, 6.157}};
  for (unsigned int i = 0; i < 3; ++i)
    {
      const double L = 101.49 + 15. * i;
      check_close("gear tooth thickness " + std::to_string(i),
                  gear.tooth_thickness(L, 0.),
                  thickness[0][i],
                  0.0006);
      check_close("pinion tooth thickness " + std::to_string(i),
                  pinion.tooth_thickness(L, 0.),
                  thickness[1][i],
                  0.0006);
    }
}

void check_assembly(const GearPair &pair)
{
  const MeanContact &coast = pair.mean_contact(MeshSide::coast);
  // assembled through the public interface, tooth 0 of both members touch on the drive side
  const Vector2 at_drive =
    mismatch(pair, MeshSide::drive, pair.rot1_reference(), pair.rot2_reference(), 0);
  check_below("teeth 0 touch at the reference [mm]", at_drive[0], 1e-11);
  check_below("opposite normals at the reference", at_drive[1], 1e-11);
  // and gear tooth 1 touches the other flank when the gear is turned by the backlash
  const double  rot1 = coast.rot1 - pair.thickness_turn();
  const double  rot2 = pair.rot2_reference() - pair.speed_ratio() * (rot1 - pair.rot1_reference());
  const Vector2 at_coast = mismatch(pair, MeshSide::coast, rot1, rot2 - pair.backlash_angle(), 1);
  check_below("tooth 1 of the gear touches after the backlash [mm]", at_coast[0], 1e-11);
  check_below("opposite normals there", at_coast[1], 1e-11);
}

void check_given_ratio_of_roll()
{
  // a given ratio of roll is kept, and the mean contact found with it
  GearPairOptions given              = paper::options();
  given.pinion.concave.ratio_of_roll = 3.0051;
  const GearPair shifted(given);
  check_close("given ratio of roll",
              shifted.mean_contact(MeshSide::drive).ratio_of_roll,
              3.0051,
              0.);
  check("it moves the mean contact from the given cradle angle",
        std::abs(shifted.mean_contact(MeshSide::drive).pinion.phi) > 1e-5);
  given.pinion.concave.ratio_of_roll = 3.2;
  check("an impossible ratio of roll is refused",
        entry_and_message_of([&] {
          const GearPair impossible(given);
        }).find("Gear pair/Pinion/Concave flank/ratio of roll: ") == 0);
}

void check_mirrored(const GearPair &pair)
{
  const MeanContact &drive = pair.mean_contact(MeshSide::drive);
  // the mirrored pair has the other hands, and drive and coast exchange their flanks
  GearPairOptions options = paper::options();
  std::swap(options.pinion.blank.hand, options.gear.blank.hand);
  for (GearMemberOptions *member : {&options.pinion, &options.gear})
    for (MachineSettings *settings : {&member->concave, &member->convex})
      {
        settings->cradle_angle = -settings->cradle_angle;
        settings->blank_offset = -settings->blank_offset;
      }
  const GearPair mirrored(options);
  check("mirrored: the convex pinion flank drives",
        mirrored.pinion_side(MeshSide::drive) == FlankSide::convex);
  check_close("mirrored ratio of roll",
              mirrored.mean_contact(MeshSide::coast).ratio_of_roll,
              drive.ratio_of_roll,
              1e-11);
  check_close("mirrored rot1", mirrored.mean_contact(MeshSide::coast).rot1, -drive.rot1, 1e-11);
  check_close("mirrored DELTA", mirrored.thickness_turn(), pair.thickness_turn(), 1e-11);
}

int main()
{
  const GearPair pair(paper::options());
  check_derived(pair);
  check_mean_contact(pair);
  check_teeth(pair);
  check_assembly(pair);
  check_given_ratio_of_roll();
  check_mirrored(pair);
  return 0;
}
