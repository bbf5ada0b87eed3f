// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Errors of manufacture on the flanks: splines on the grid, ease-off terms by the geometry of the
// moved flank, pitch deviations and eccentricity in the unloaded contact by their closed forms, and
// contact of modified flanks against the search for the smallest gap.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"
#include "gap_search.h"
#include "paper_pair.h"

#include <vfife/gear/unloaded_contact/unequal_teeth.h>

using namespace vfife;

constexpr double um = 1e-3;

/** A product of cubics, which the grid must give back everywhere. */
double cubic(const double u, const double v)
{
  return (1. + u * (2. - u * (3. - 1.5 * u))) * (.5 - v * (1. - v * (2. + v)));
}

void splines()
{
  for (const auto &[rows, columns] : {std::pair(5, 9), std::pair(4, 4), std::pair(12, 6)})
    {
      Eigen::MatrixXd values(rows, columns);
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
          values(i, j) = cubic(j / (columns - 1.), i / (rows - 1.));
      const BicubicGrid grid(values);
      double            off = 0., slope_off = 0.;
      constexpr double  step = 1e-6;
      for (double u = 0.; u < 1.; u += .07)
        for (double v = 0.; v < 1.; v += .09)
          {
            raise_to(off, std::abs(grid.value(u, v) - cubic(u, v)));
            const Vector2 slope((cubic(u + step, v) - cubic(u - step, v)) / (2. * step),
                                (cubic(u, v + step) - cubic(u, v - step)) / (2. * step));
            raise_to(slope_off, (grid.gradient(u, v) - slope).norm());
          }
      const std::string name = std::to_string(rows) + " x " + std::to_string(columns);
      check_below(name + ": cubics are met", off, 1e-13);
      check_below(name + ": and their slopes", slope_off, 1e-8);
      check_close(name + ": constant beyond the toe", grid.value(-.3, .4), cubic(0., .4), 1e-13);
      check_close(name + ": constant beyond tip and heel",
                  grid.value(2., 1.5),
                  cubic(1., 1.),
                  1e-13);
      check(name + ": no slope across the border", grid.gradient(1.2, .5)[0] == 0.);
    }
  Eigen::MatrixXd small(2, 3);
  small << 0., 1., 4., 2., 3., 6.; // 4 u^2 + 2 v
  check_close("3 columns are a parabola, 2 rows a line",
              BicubicGrid(small).value(.3, .6),
              4. * .09 + 1.2,
              1e-14);
}

/** Five terms at once, each of which shows at some places alone. */
void terms()
{
  GearPairOptions options = paper::options();
  EaseOffTerms   &t       = options.gear_errors.convex.terms;
  t.pressure_angle        = 12. * um;
  t.spiral_angle          = -8. * um;
  t.profile_crowning      = 5. * um;
  t.lengthwise_crowning   = 9. * um;
  t.bias                  = 6. * um;
  const GearPair    pair(options);
  const GearMember &gear  = pair.gear();
  const Flank       plain = gear.generated_flank(FlankSide::convex),
              moved       = gear.shared_flank(FlankSide::convex);
  const Blank &blank      = gear.blank();
  // u, v and what the sum of the terms is there
  const double places[][3] = {{.5, .5, 0.},
                              {0., .5, -9. + 4.},
                              {1., .5, -9. - 4.},
                              {.5, 0., -5. - 6.},
                              {.5, 1., -5. + 6.},
                              {1., 1., -14. + 2. + 1.5},
                              {0., 1., -14. + 10. - 1.5}};
  for (const auto &place : places)
    {
      const double L = blank.inner_cone_distance() + place[0] * blank.face_width;
      // straight lines between the ends, at which the flank starts at its fillet
      double low[2];
      for (const int end : {0, 1})
        {
          const double at = blank.inner_cone_distance() + end * blank.face_width;
          low[end]        = blank.coordinates_of(
            gear.fillet_point(FlankSide::convex, at, gear.fillet_end(FlankSide::convex))
              .position)[1];
        }
      const double      start = low[0] + place[0] * (low[1] - low[0]);
      const double      h     = start + place[1] * (blank.addendum(L) - start);
      const auto        point = plain.point_at(L, h);
      const auto        there = moved.evaluate(point.t, point.phi);
      const std::string name  = "terms at u = " + std::to_string(place[0]).substr(0, 3) +
                               ", v = " + std::to_string(place[1]).substr(0, 3);
      check_close(name + " [um]",
                  -(there.position - point.position).dot(point.normal) / um,
                  place[2],
                  1e-9);
      // the normal by differences of moved points
      constexpr double step       = 1e-4;
      const auto       difference = [&](const double dt, const double dphi) -> Vector3 {
        return moved.evaluate(point.t + dt, point.phi + dphi).position -
               moved.evaluate(point.t - dt, point.phi - dphi).position;
      };
      const Vector3 normal = difference(step, 0.).cross(difference(0., step)).normalized();
      check_below(name + ": normal against differences", normal.cross(there.normal).norm(), 2e-8);
    }
}

/** Against the search over points, both sides. */
void contact_of_modified_flanks()
{
  GearPairOptions options                                = paper::options();
  options.gear_errors.convex.terms.lengthwise_crowning   = 10. * um;
  options.gear_errors.convex.terms.bias                  = 8. * um;
  options.pinion_errors.concave.terms.profile_crowning   = 6. * um;
  options.pinion_errors.concave.terms.spiral_angle       = 10. * um;
  options.gear_errors.concave.terms.pressure_angle       = -5. * um;
  options.pinion_errors.convex.terms.lengthwise_crowning = 7. * um;
  const GearPair pair(options), plain(paper::options());
  for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
    {
      const UnloadedContact contact(pair, side), before(plain, side);
      double                worst = 0., change = 0.;
      for (double p = -.6; p < .61; p += .3)
        {
          const double rot1   = contact.reference() + p * contact.pitch();
          const auto   point  = contact.contact(rot1, 0);
          const double turned = rot1 + pair.pinion().turn(pair.pinion_side(side));
          const double rot2   = gap_search(pair, side, turned, point.pinion_L_h + Vector2(.8, -.2));
          raise_to(worst, std::abs(std::remainder(rot2 - point.rot2, 2. * pi)) / arcsecond);
          change = std::max(change, std::abs(point.lag - before.contact(rot1, 0).lag) / arcsecond);
        }
      check_below(side_name(side) + ", modified: lag against the search [arcsec]", worst, .002);
      check(side_name(side) + ", modified: another lag", change > 1.);
    }
}

double lag_of(const GearPair &pair, const MeshSide side, const int k, const double pitches)
{
  const UnloadedContact contact(pair, side, k);
  return contact.contact(contact.reference() + pitches * contact.pitch(), 0).lag;
}

/** The flank that a member pushes with on a side. */
FlankErrorOptions &working(GearPairOptions &options, const MeshSide side, const bool on_pinion)
{
  MemberErrorOptions &errors = on_pinion ? options.pinion_errors : options.gear_errors;
  // drive: concave pinion on convex gear
  return (side == MeshSide::drive) == on_pinion ? errors.concave : errors.convex;
}

/** A tooth of the gear turned by F/r shifts the lag by just that; one of the pinion reaches each
 * place F/r1 earlier and is ahead by z1/z2 of it. */
void pitch()
{
  constexpr double F = 10. * um;
  for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
    {
      const GearPair  plain(paper::options());
      const double    sign    = side == MeshSide::drive ? 1. : -1.;
      GearPairOptions options = paper::options();
      // alone displaced: the first of three teeth in mesh, by a list that returns to zero
      const int   tooth = 5;
      std::string list;
      for (int k = 0; k < 79; ++k)
        list += (k == 0 ? "" : ", ") + std::string(k == tooth       ? "10"
                                                   : k == tooth + 1 ? "-10"
                                                                    : "0");
      working(options, side, false).pitch_list = list;
      const GearPair gear(options);
      const int      pair_of_tooth = side == MeshSide::drive ? -tooth : 1 - tooth;
      const double   r2            = 116.49 * std::sin(plain.gear().blank().pitch_angle);
      double         off           = 0.;
      for (const double p : {-.5, 0., .5})
        raise_to(off,
                 std::abs(lag_of(gear, side, pair_of_tooth, p) -
                          lag_of(plain, side, pair_of_tooth, p) + F / r2));
      // along the normal instead of round the axis: second order in F over the radii of curvature
      check_below(side_name(side) + ", gear tooth: lag against -F/r [arcsec]",
                  off / arcsecond,
                  2e-3);
      check_close(side_name(side) + ", other gear tooth",
                  lag_of(gear, side, pair_of_tooth - 1, .3),
                  lag_of(plain, side, pair_of_tooth - 1, .3),
                  1e-13);

      options                                      = paper::options();
      working(options, side, true).pitch_amplitude = F;
      working(options, side, true).pitch_order     = 2;
      working(options, side, true).pitch_phase     = .4;
      const GearPair pinion(options);
      const double   r1 = 116.49 * std::sin(plain.pinion().blank().pitch_angle);
      off               = 0.;
      for (const int k : {0, 3, 20})
        for (const double p : {-.5, 0., .5})
          {
            const double turn  = F * std::cos(2. * pi * 2 * k / 27. - .4) / r1;
            const double ahead = sign * turn / plain.pinion().pitch();
            raise_to(off,
                     std::abs(lag_of(pinion, side, k, p) -
                              (lag_of(plain, side, k, p + ahead) - plain.speed_ratio() * turn)));
          }
      check_below(side_name(side) + ", pinion teeth: lag against the turned tooth [arcsec]",
                  off / arcsecond,
                  2e-3);
    }
}

/** The mean contact of tooth k: flanks displaced by the vector c, which is turned by k pitches
 * against tooth 0, touch n . c/arm earlier. */
void runout()
{
  constexpr double e = 2. * um, direction = 1.1;
  GearPairOptions  options                   = paper::options();
  options.gear_errors.eccentricity           = e;
  options.gear_errors.eccentricity_direction = direction;
  const GearPair     pair(options), plain(paper::options());
  const MeanContact &mean = plain.mean_contact(MeshSide::drive);
  // tooth 0 in the body: its middle at L = A_m is where directions are counted from
  const SurfacePoint upper = plain.gear().flank_point(plain.gear().upper_side(), 116.49, 0.);
  const double       r     = std::hypot(upper.position[0], upper.position[1]);
  const double       middle =
    polar_angle(upper.position) - plain.gear().tooth_thickness(116.49, 0.) / (2. * r);
  double off = 0., amplitude = 0.;
  for (int tooth = 0; tooth < 79; ++tooth)
    {
      const double  angle = middle + direction - tooth * plain.gear().pitch();
      const Vector3 c     = e * Vector3(std::cos(angle), std::sin(angle), 0.);
      // the gear's tooth moved towards the pinion is ahead of where it has to be
      const double expected = mean.gear.normal.dot(c) / mean.arm;
      const double found =
        lag_of(pair, MeshSide::drive, -tooth, 0.) - lag_of(plain, MeshSide::drive, -tooth, 0.);
      raise_to(off, std::abs(found - expected));
      amplitude = std::max(amplitude, std::abs(found));
    }
  check_ratio("eccentric gear: amplitude of a turn over e |n transverse|/arm",
              amplitude / (e * mean.gear.normal.head<2>().norm() / mean.arm),
              2e-3);
  // the place of contact moves by what the normals tilt: second order
  check_below("eccentric gear: each tooth [arcsec]", off / arcsecond, .01);

  // A large one is the pair with an offset, while it lies across the pinion's axis: no first
  // order in this comparison. It turns with the gear, so the lag counts.
  GearPairOptions mounting                   = paper::options();
  mounting.offset                            = 30. * um;
  const double lag                           = lag_of(GearPair(mounting), MeshSide::drive, 0, 0.);
  options.gear_errors.eccentricity           = 30. * um;
  options.gear_errors.eccentricity_direction = -pi / 2 - middle - mean.rot2 - lag;
  check_close("eccentric gear as an offset of the pinion [arcsec]",
              lag_of(GearPair(options), MeshSide::drive, 0, 0.) / arcsecond,
              lag / arcsecond,
              .005); // moved along the normals: second order

  // Wobble: the mean pitch circle moves by a cos(theta - direction) along the axis, as measured
  // on the deviated surface; its tilt about the axis' point does the rest.
  options                              = paper::options();
  options.gear_errors.wobble           = 15. * um;
  options.gear_errors.wobble_direction = .7;
  const GearPair      wobbling(options);
  const MemberErrors &errors = wobbling.gear().errors();
  for (const unsigned int tooth : {0u, 30u})
    {
      const double  theta = middle + tooth * plain.gear().pitch();
      const Vector3 at =
        rotation_about(Vector3::UnitZ(), middle) * Vector3(r, 0., upper.position[2]);
      const Vector3 moved = errors.of_tooth(FlankSide::convex, tooth).shift.at(at);
      check_close("wobble of tooth " + std::to_string(tooth) + " along the axis [um]",
                  moved[2] / um,
                  15. * std::cos(theta - middle - .7),
                  1e-9);
      check_below("and across it", moved.head<2>().norm() / um, 1e-9);
    }
}

/** Offsets that are no small deviations any more. */
void large_deviations()
{
  const auto refuse = [](const auto &set) {
    GearPairOptions options = paper::options();
    set(options.gear_errors);
    print_refused_entry([&options] { const GearPair pair(options); });
  };
  refuse([](MemberErrorOptions &errors) { errors.eccentricity = 500. * um; });
  refuse([](MemberErrorOptions &errors) { errors.convex.terms.profile_crowning = -500. * um; });
  refuse([](MemberErrorOptions &errors) { errors.concave.pitch_amplitude = 500. * um; });
}

int main()
{
  return run_parts({splines, terms, contact_of_modified_flanks, pitch, runout, large_deviations});
}
