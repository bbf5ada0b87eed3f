// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of another kind of gear: a class that states its flanks (GearGeometry) is all they need.

#include "../tests.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_body_check.h>
#include <vfife/mesh/gear/gear_meridian.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>

#include <array>

using namespace vfife;

namespace
{
  double involute(const double angle)
  {
    return std::tan(angle) - angle;
  }

  /**
   * An involute gear, spur or helical. On the radius r = r_b / cos(al) a flank stands
   *     pi / (2 z) + inv(al_0) - inv(al)
   * beside the middle of its tooth, al_0 the pressure angle on the pitch circle; from root circle
   * to flank the fillet is an arc of radius rho in (r, r theta). Sections are turned by the helix.
   */
  class CylindricalGear : public GearGeometry
  {
  public:
    CylindricalGear(const unsigned int teeth,
                    const double       module,
                    const double       helix_angle,
                    const double       tip_chamfer = 0.)
      : pitch_radius(.5 * module * teeth)
      , base_radius(pitch_radius * std::cos(pressure_angle))
      , fillet_radius(.3 * module)
      , twist_(std::tan(helix_angle) / pitch_radius)
    {
      blank_.teeth               = teeth;
      blank_.origin              = {pitch_radius, 0.};
      blank_.face_width          = 8. * module;
      blank_.outer_cone_distance = 4. * module;
      blank_.mean_addendum       = module;
      blank_.mean_dedendum       = 1.25 * module;
      blank_.tip_chamfer         = tip_chamfer;
    }

    std::unique_ptr<GearGeometry> clone() const override
    {
      return std::make_unique<CylindricalGear>(*this);
    }

    const std::string &name() const override
    {
      return name_;
    }

    const BlankOutline &blank() const override
    {
      return blank_;
    }

    FlankSide lower_side() const override
    {
      return FlankSide::concave;
    }

    SurfacePoint flank_point(const FlankSide side, const double L, const double h) const override
    {
      const double r = pitch_radius + h;
      return point(side, L, r, half_tooth(r), 1., -std::tan(pressure_angle_at(r)) / r);
    }

    SurfacePoint
    fillet_point(const FlankSide side, const double L, const double parameter) const override
    {
      const double s = std::sin(parameter), c = std::cos(parameter);
      const double r = root_radius() + fillet_radius * (1. - c), dr = fillet_radius * s;
      const double arc = fillet_radius * (1. - s) / r;
      return point(side,
                   L,
                   r,
                   half_tooth(root_radius() + fillet_radius) + arc,
                   dr,
                   -fillet_radius * c / r - arc * dr / r);
    }

    double fillet_end(const FlankSide) const override
    {
      return pi / 2;
    }

    double root_radius() const
    {
      return pitch_radius - blank_.mean_dedendum;
    }

    double pressure_angle_at(const double r) const
    {
      return std::acos(base_radius / r);
    }

    /** Angle between the middle of a tooth and its flank. */
    double half_tooth(const double r) const
    {
      return pi / (2. * blank_.teeth) + involute(pressure_angle) - involute(pressure_angle_at(r));
    }

    /** Polar angle of the middle of tooth 0 in the section z = L. */
    double middle_of_tooth(const double L) const
    {
      return twist_ * L;
    }

    /** Area of the transverse section: half the integral of r^2 d(angle) along the outline. On an
     * involute it is r_b^2/6 times the change of tan^3(al). */
    double area() const
    {
      const double start = root_radius() + fillet_radius, tip = pitch_radius + blank_.mean_addendum;
      const double end = tip - blank_.tip_chamfer, corner = half_tooth(tip) - (tip - end) / tip;
      const auto cube = [&](const double r) { return std::pow(std::tan(pressure_angle_at(r)), 3); };
      // tip land, chamfer whose radius is linear in the angle, involute
      double half = .5 * corner * tip * tip +
                    (half_tooth(end) - corner) * (tip * tip + tip * end + end * end) / 6. +
                    base_radius * base_radius / 6. * (cube(end) - cube(start));
      constexpr unsigned int n    = 2000;
      double                 edge = half_tooth(start);
      for (unsigned int i = n; i > 0; --i) // fillet, from the flank down to the root
        {
          const auto radius = [&](const double step) {
            return root_radius() + fillet_radius * (1. - std::cos(pi / 2 * step / n));
          };
          const double next = half_tooth(start) + fillet_radius *
                                                    (1. - std::sin(pi / 2 * (i - 1.) / n)) /
                                                    radius(i - 1.);
          half += .5 * radius(i - .5) * radius(i - .5) * (next - edge);
          edge = next;
        }
      half += .5 * root_radius() * root_radius() * (.5 * pitch() - edge); // half the root land
      return 2. * blank_.teeth * half;
    }

    static constexpr double pressure_angle = 20. * pi / 180.;

    const double pitch_radius, base_radius, fillet_radius;

  private:
    /** Of a profile (r, angle beside the middle of the tooth) with these derivatives. */
    SurfacePoint point(const FlankSide side,
                       const double    L,
                       const double    r,
                       const double    beside,
                       const double    dr,
                       const double    d_beside) const
    {
      const double sign  = side == lower_side() ? -1. : 1.,
                   angle = middle_of_tooth(L) + sign * beside;
      const Vector3 radial(std::cos(angle), std::sin(angle), 0.),
        tangential(-std::sin(angle), std::cos(angle), 0.);
      SurfacePoint result;
      result.position       = r * radial + L * Vector3::UnitZ();
      const Vector3 profile = dr * radial + r * sign * d_beside * tangential;
      const Vector3 length  = r * twist_ * tangential + Vector3::UnitZ();
      result.normal         = sign * profile.cross(length).normalized();
      return result;
    }

    std::string  name_ = "cylindrical gear";
    BlankOutline blank_;
    double       twist_; ///< of sections, for a unit of length [rad/mm]
  };

  double volume_of_ring(const double outer, const double inner, const double length)
  {
    return pi * (outer * outer - inner * inner) * length;
  }

  /** Errors of the volume on a mesh and on one of half the size [mm^3]. */
  using VolumeErrors = std::array<double, 2>;

  void check_order(const std::string &name, const VolumeErrors &errors)
  {
    check_close(name + ": volume converges with second order", errors[1] / errors[0], .25, .03);
  }

  /** Valid cells, and the errors of their volume against that of the true body. */
  VolumeErrors check_body(const std::string     &name,
                          const CylindricalGear &gear,
                          GearBodyOptions        options,
                          const double           exact)
  {
    check_gear_body("Gear", options, gear.blank());
    const MeshQuality coarse_mesh =
      compute_mesh_quality(make_gear_body(gear, options)->triangulation);
    check(name + ": cells are right-handed", coarse_mesh.least_determinant > 0.);
    check(name + ": scaled Jacobian", coarse_mesh.least_scaled_jacobian > .4);
    const double first = coarse_mesh.volume / exact - 1.;
    check_below(name + ": volume", first, 3e-3);
    check_below(name + ": integral over the true body",
                compute_true_integrals(gear, options).volume / exact - 1.,
                1e-5);

    options.refinements      = 1;
    const auto        mesh   = make_gear_body(gear, options);
    const MeshQuality finer  = compute_mesh_quality(mesh->triangulation);
    const double      second = finer.volume / exact - 1.;
    check(name + ": refined cells are right-handed", finer.least_determinant > 0.);

    // nodes of all teeth stand on involutes
    double farthest = 0.;
    for (const char *side : {surface_name::concave, surface_name::convex})
      for (const Vector3 &x : mesh->surfaces.at(side).positions)
        {
          const double r    = std::hypot(x[0], x[1]);
          const double sign = side == surface_name::concave ? -1. : 1.;
          const double tooth =
            std::atan2(x[1], x[0]) - gear.middle_of_tooth(x[2]) - sign * gear.half_tooth(r);
          farthest = largest_of(farthest, r * std::abs(std::remainder(tooth, gear.pitch())));
        }
    check_below(name + ": nodes of the flanks stand on involutes", farthest, 1e-10);
    return {{first * exact, second * exact}};
  }
} // namespace

int main()
{
  const CylindricalGear spur(48, 2.5, 0.), helical(48, 2.5, 20. * pi / 180.);
  const double          width = spur.blank().face_width, bore = 20.;

  GearBodyOptions solid    = coarse(pinion_body_defaults());
  solid.cells_lengthwise   = 4;
  const double       full  = (spur.area() - pi * bore * bore) * width;
  const VolumeErrors sharp = check_body("spur", spur, solid, full);
  check_order("spur", sharp);
  const CylindricalGear chamfered(48, 2.5, 0., .4);
  const VolumeErrors    cut = check_body("spur with tip chamfers",
                                      chamfered,
                                      solid,
                                      (chamfered.area() - pi * bore * bore) * width);
  // Errors of flanks and bore nearly cancel in the body; those of the chamfers are the difference.
  check_order("volume that the chamfers take", {{sharp[0] - cut[0], sharp[1] - cut[1]}});
  solid.cells_lengthwise = 8;
  check_order("helical", check_body("helical", helical, solid, full));

  // a plane web in the middle of the rim
  GearBodyOptions disc  = coarse(GearBodyOptions());
  disc.web_angle        = pi / 2;
  disc.web_attachment   = WebAttachment::middle;
  disc.cells_lengthwise = 6;
  disc.hub_radius       = 30.;
  disc.bore_radius      = 20.;
  const double rim      = spur.root_radius() - disc.rim_thickness;
  check_order("spur with a web",
              check_body("spur with a web",
                         spur,
                         disc,
                         (spur.area() - pi * rim * rim) * width +
                           volume_of_ring(rim, disc.hub_radius, disc.web_thickness) +
                           volume_of_ring(disc.hub_radius, disc.bore_radius, disc.hub_length)));
  return 0;
}
