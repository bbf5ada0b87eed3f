// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Flanks and fillets cut with modified roll and a tilted cutter, against the envelope of the moving
// cutter: no normals, no equation of meshing, only distances from the cutter in its positions.
#include "../tests.h"
#include "paper_pair.h"

#include <functional>

using namespace vfife;

/** The cutter in its positions against the blank. */
class MovingCutter
{
public:
  /** Only positions near the cradle's rotation @p near are looked at: far from it the blank is
   * inside the cup, where other slots are cut. */
  MovingCutter(const MachineSettings &settings, const double near)
    : settings_(settings)
    , near_(near)
  {
  }

  /** Coordinates (radius, height) of a point of the blank in the cutter when the cradle has turned
   * by phi. */
  Vector2 in_cutter(const Vector3 &body, const double phi) const
  {
    const MachineSettings &o = settings_;
    const double           g = o.machine_root_angle, S = o.radial_distance;
    const Vector3          axis(std::cos(g), 0., -std::sin(g));
    // blank frame at rest in the machine, turned back by the blank's rotation about its axis
    Matrix3 blank;
    blank.col(0)      = Vector3(std::sin(g), 0., std::cos(g));
    blank.col(1)      = axis.cross(blank.col(0));
    blank.col(2)      = axis;
    const double  psi = o.ratio_of_roll * (phi - o.second_order_roll * phi * phi -
                                          o.third_order_roll * phi * phi * phi);
    const Vector3 apex =
      Vector3(0., o.blank_offset, -o.sliding_base) + o.machine_center_to_back * axis;
    const Vector3 machine = apex + rotation_about(axis, -psi) * (blank * body);
    // cradle: at phi = 0 the cutter is tilted about the swivelled direction, then all turns by phi
    const Vector3 in_cradle = rotation_about(Vector3::UnitZ(), -phi) * machine;
    const Vector3 center    = S * Vector3(std::cos(o.cradle_angle), std::sin(o.cradle_angle), 0.);
    const double  j         = o.cradle_angle + o.cutter_swivel;
    const Vector3 c =
      rotation_about(Vector3(std::cos(j), std::sin(j), 0.), -o.cutter_tilt) * (in_cradle - center);
    return {std::hypot(c[0], c[1]), c[2]};
  }

  /** Least signed distance over the cradle's rotations from the blade's straight side. */
  double least_distance_from_blade(const Vector3 &body) const
  {
    const double sigma = settings_.sigma(), al = settings_.blade_angle;
    return least([&](const double phi) {
      const Vector2 c = in_cutter(body, phi);
      return (sigma * (c[0] - settings_.point_radius) - c[1] * std::tan(al)) * std::cos(al);
    });
  }

  /** The same from the rounding of the blade's edge. */
  double least_distance_from_edge(const Vector3 &body) const
  {
    const double sigma = settings_.sigma();
    return least([&](const double phi) {
      const Vector2 c = in_cutter(body, phi);
      return std::hypot(sigma * (c[0] - settings_.point_radius) + settings_.edge_width(),
                        c[1] - settings_.edge_radius) -
             settings_.edge_radius;
    });
  }

private:
  double least(const std::function<double(double)> &distance) const
  {
    constexpr double range = 0.05, step = 0.005;
    double           middle = near_;
    for (double phi = near_ - range; phi <= near_ + range; phi += step)
      if (distance(phi) < distance(middle))
        middle = phi;
    double low = middle - step, high = middle + step;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double a = low + (high - low) / 3., b = high - (high - low) / 3.;
        (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
      }
    return distance((low + high) / 2.);
  }

  MachineSettings settings_;
  double          near_;
};

/** How far along the circle about the axis a point lies from the envelope of the cutters [mm]. */
double distance_from_envelope(const Vector3                                &point,
                              const Vector3                                &normal,
                              const std::function<double(const Vector3 &)> &least_distance)
{
  const double  r     = std::hypot(point[0], point[1]);
  const Vector3 along = Vector3(-point[1], point[0], 0.) / r;
  // the metal lies along + or - of the circle; the cutters touch where the least distance is nought
  const double sign  = along.dot(normal) > 0. ? 1. : -1.;
  const auto   moved = [&](const double arc) {
    return least_distance(rotation_about(Vector3::UnitZ(), sign * arc / r) * point);
  };
  double low = -0.05, high = 0.05;
  if (!(moved(low) < 0. && moved(high) > 0.))
    return 1.;
  for (unsigned int i = 0; i < 45; ++i)
    (moved((low + high) / 2.) < 0. ? low : high) = (low + high) / 2.;
  return (low + high) / 2.;
}

struct Differences
{
  double flank = 0, fillet = 0;
};

/** Largest distances of flank and fillet from the envelope over the tooth. */
Differences compare(const MachineSettings &settings, const Blank &blank)
{
  const Flank flank(settings, blank.pitch_angle);
  Differences largest;
  for (const double x : {0.1, 0.5, 0.9})
    {
      const double L = blank.inner_cone_distance() + x * blank.face_width;
      for (const double y : {0.4, 0.7, 1.})
        {
          const GeneratedPoint point =
            flank.point_at(L, -blank.dedendum(L) + y * (blank.addendum(L) + blank.dedendum(L)));
          raise_to(largest.flank,
                   std::abs(
                     distance_from_envelope(point.position, point.normal, [&](const Vector3 &p) {
                       return MovingCutter(settings, point.phi).least_distance_from_blade(p);
                     })));
        }
      for (const double lambda : {0.3, 1.})
        {
          const GeneratedPoint point = flank.fillet_at(L, lambda);
          raise_to(largest.fillet,
                   std::abs(
                     distance_from_envelope(point.position, point.normal, [&](const Vector3 &p) {
                       return MovingCutter(settings, point.phi).least_distance_from_edge(p);
                     })));
        }
    }
  return largest;
}

/** Derivatives against central differences over 2e-5 rad, whose own error is about 1e-8 of the
 * derivatives' size. */
void check_derivatives(const std::string &name, const MachineSettings &settings, const Blank &blank)
{
  constexpr double         step = 1e-5;
  const Flank              flank(settings, blank.pitch_angle);
  const GeneratedPoint     point = flank.point_at(blank.mean_cone_distance, 0.4);
  const SurfaceDerivatives exact = flank.derivatives(point.t, point.phi);
  const GeneratedPoint     up_t  = flank.evaluate(point.t + step, point.phi),
                       down_t    = flank.evaluate(point.t - step, point.phi),
                       up_phi    = flank.evaluate(point.t, point.phi + step),
                       down_phi  = flank.evaluate(point.t, point.phi - step);
  const double difference        = largest_of(
    {((up_t.position - down_t.position) / (2. * step) - exact.position_t).norm(),
            ((up_phi.position - down_phi.position) / (2. * step) - exact.position_phi).norm(),
            100. * ((up_t.normal - down_t.normal) / (2. * step) - exact.normal_t).norm(),
            100. * ((up_phi.normal - down_phi.normal) / (2. * step) - exact.normal_phi).norm()});
  check_below(name + ": derivatives", difference, 1e-5);
}

int main()
{
  const GearPairOptions paper = GearPair(paper::options()).options();
  const Blank          &blank = paper.pinion.blank;
  for (const MachineSettings &plain : {paper.pinion.concave, paper.pinion.convex})
    {
      const std::string side   = plain.blade == Blade::outside ? "pinion concave" : "pinion convex";
      MachineSettings   rolled = plain;
      rolled.second_order_roll = 0.03;
      rolled.third_order_roll  = 0.3;
      MachineSettings tilted   = plain;
      tilted.cutter_tilt       = 2. * degree;
      tilted.cutter_swivel     = -25. * degree;
      MachineSettings both     = tilted;
      both.second_order_roll   = rolled.second_order_roll;
      both.third_order_roll    = rolled.third_order_roll;
      both.machine_root_angle += 1. * degree;
      const std::pair<const char *, MachineSettings> cases[] = {{"plain", plain},
                                                                {"modified roll", rolled},
                                                                {"tilt", tilted},
                                                                {"tilt, roll, root angle", both}};
      for (const auto &one : cases)
        {
          const std::string name       = side + ", " + one.first;
          const Differences difference = compare(one.second, blank);
          // the least distance is found to round-off of a distance that is stationary
          check_below(name + ": flank on the envelope [mm]", difference.flank, 1e-7);
          check_below(name + ": fillet on the envelope [mm]", difference.fillet, 1e-7);
          check_derivatives(name, one.second, blank);
        }
      // nothing else than the modification may move the flank, and the modification must
      const double    L    = blank.mean_cone_distance + 12.;
      const Vector3   base = Flank(plain, blank.pitch_angle).point_at(L, 1.).position;
      MachineSettings zero = plain;
      zero.cutter_swivel   = 0.7; // without tilt there is nothing to turn
      check_below(side + ": swivel without tilt changes nothing [mm]",
                  (Flank(zero, blank.pitch_angle).point_at(L, 1.).position - base).norm(),
                  1e-12);
      check(side + ": modified roll moves the heel by more than 1 um",
            (Flank(rolled, blank.pitch_angle).point_at(L, 1.).position - base).norm() > 1e-3);
    }
  return 0;
}
