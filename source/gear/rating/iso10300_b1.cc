// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/rating/iso10300_b1.h>
#include <vfife/gear/spiral_bevel/gear_pair.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    double square(const double x)
    {
      return x * x;
    }

    double involute(const double angle)
    {
      return std::tan(angle) - angle;
    }

    /** Virtual cylindrical gears of a pair (ISO 10300-1, A.2). Lengths in mm, angles in rad. */
    struct VirtualGears
    {
      explicit VirtualGears(const RatedPair &pair)
        : transverse_pressure_angle(
            std::atan(std::tan(pair.pressure_angle) / std::cos(pair.spiral_angle)))
        , base_spiral_angle(std::asin(std::sin(pair.spiral_angle) * std::cos(pair.pressure_angle)))
        , base_pitch(pi * pair.normal_module * std::cos(transverse_pressure_angle) /
                     std::cos(pair.spiral_angle))
        , effective_width(pair.contact_share * pair.face_width)
      {
        for (unsigned int i = 0; i < 2; ++i)
          {
            const RatedMember &member = pair.members[i];
            teeth[i]                  = member.teeth / std::cos(member.pitch_angle);
            diameter[i]               = teeth[i] * pair.normal_module / std::cos(pair.spiral_angle);
            base[i]                   = diameter[i] * std::cos(transverse_pressure_angle);
            tip[i]                    = diameter[i] + 2 * member.addendum;
            contact_path += (std::sqrt(square(tip[i]) - square(base[i])) -
                             diameter[i] * std::sin(transverse_pressure_angle)) /
                            2;
          }
      }

      double transverse_pressure_angle; ///< alpha_vet
      double base_spiral_angle;         ///< beta_vb
      double base_pitch;                ///< p_vet
      double effective_width;           ///< b_v,eff
      double contact_path = 0;          ///< g_v_alpha

      std::array<double, 2> teeth{}, diameter{}, base{}, tip{};
    };

    /** Lines of contact across the zone of action (A.2.7). */
    class ContactLines
    {
    public:
      ContactLines(const RatedPair &pair, const VirtualGears &gears)
        : farthest_(
            (gears.contact_path + gears.effective_width * std::tan(gears.base_spiral_angle)) / 2 *
            std::cos(gears.base_spiral_angle))
        , longest_(gears.contact_path / std::sin(gears.base_spiral_angle))
        , lost_(1. - std::sqrt(pair.contact_share))
      {
      }

      /** Length l_b of the line at a distance from the middle one. */
      double length(const double distance) const
      {
        const double place = square(distance / farthest_);
        return longest_ * (1. - std::sqrt(place + square(lost_) * (1. - place)));
      }

      /** Pressure p* there over that of the middle line. */
      double pressure(const double distance) const
      {
        const double exponent = 3.; // low profile crowning
        return std::max(0., 1. - std::pow(std::abs(distance) / farthest_, exponent));
      }

    private:
      double farthest_, longest_, lost_;
    };

    /** Angle of the fillet at the tangent of 30 deg: theta = (2 G / z) tan theta - H. */
    double solve_fillet_angle(const double G, const double H, const double teeth)
    {
      double theta = pi / 3;
      for (unsigned int i = 0; i < 100; ++i)
        {
          const double tangent = std::tan(theta);
          const double value   = 2 * G / teeth * tangent - H - theta;
          const double change  = value / (2 * G / teeth * (1. + square(tangent)) - 1.);
          theta -= change;
          if (std::abs(change) < 1e-12)
            break;
        }
      if (!(theta > 0. && theta < pi / 2))
        throw InputError("ISO 10300 B1: the tooth has no section at the tangents of 30 deg.");
      return theta;
    }

    /** Form and stress correction factors of a tooth loaded at its tip (ISO 10300-3, 6.4). */
    RatedTooth rate_form(const RatedPair    &pair,
                         const VirtualGears &gears,
                         const unsigned int  i,
                         const double        profile_shift)
    {
      const RatedMember &member  = pair.members[i];
      const double       m       = pair.normal_module;
      const double       alpha   = pair.pressure_angle;
      const double       tangent = std::tan(alpha);
      const double       radius  = member.edge_radius;
      // normal section of the virtual gear
      const double teeth =
        gears.teeth[i] / (square(std::cos(gears.base_spiral_angle)) * std::cos(pair.spiral_angle));
      const double tip  = teeth * m + 2 * member.addendum;
      const double base = teeth * m * std::cos(alpha);
      const double thickness_shift =
        (member.tooth_thickness / m - pi / 2) / 2 - profile_shift * tangent;

      const double tool_addendum = member.dedendum + profile_shift * m;
      const double E             = (pi / 4 - thickness_shift) * m - tool_addendum * tangent -
                       radius * (1. - std::sin(alpha)) / std::cos(alpha);
      const double G     = (radius - member.dedendum) / m;
      const double H     = 2. / teeth * (pi / 2 - E / m) - pi / 3;
      const double theta = solve_fillet_angle(G, H, teeth);

      RatedTooth tooth;
      tooth.root_thickness =
        m * teeth * std::sin(pi / 3 - theta) + std::sqrt(3.) * (m * G / std::cos(theta) - radius);
      tooth.fillet_radius =
        radius + 2 * square(G) * m / (std::cos(theta) * (teeth * square(std::cos(theta)) - 2 * G));
      const double tip_pressure_angle = std::acos(base / tip);
      const double gamma = (pi / 2 + 2 * (profile_shift * tangent + thickness_shift)) / teeth +
                           involute(alpha) - involute(tip_pressure_angle);
      tooth.load_angle = tip_pressure_angle - gamma;
      tooth.bending_arm =
        ((std::cos(gamma) - std::sin(gamma) * std::tan(tooth.load_angle)) * tip -
         m * teeth * std::cos(pi / 3 - theta) - m * G / std::cos(theta) + radius) /
        2;
      tooth.form_factor = 6 * tooth.bending_arm * m * std::cos(tooth.load_angle) /
                          (square(tooth.root_thickness) * std::cos(alpha));
      const double slenderness = tooth.root_thickness / tooth.bending_arm;
      const double notch       = tooth.root_thickness / (2 * tooth.fillet_radius);
      tooth.stress_correction =
        (1.2 + 0.13 * slenderness) * std::pow(notch, 1. / (1.21 + 2.3 / slenderness));
      return tooth;
    }

    /** Y_BS (ISO 10300-3, 6.4.4). */
    double
    find_spiral_angle_factor(const RatedPair &pair, const VirtualGears &gears, const double line)
    {
      double depths = 0;
      for (const RatedMember &member : pair.members)
        depths += member.addendum + member.dedendum;
      const double width   = pair.face_width / std::cos(pair.spiral_angle);
      const double covered = line * std::cos(gears.base_spiral_angle) / std::cos(pair.spiral_angle);
      const double x       = 2 * width / depths;
      const double a       = -0.0182 * square(x) + 0.4736 * x - 0.32;
      const double b       = -0.0032 * square(x) + 0.0526 * x + 0.712;
      const double c       = -0.0050 * square(x) + 0.0850 * x + 0.54;
      return a / c * square(covered / width - 1.05 * b) + 1.;
    }

    /** Z_M-B (ISO 10300-2, 6.4.1), face contact ratio of at least one. */
    double find_mid_zone(const VirtualGears &gears, const double contact_ratio)
    {
      double product = 1;
      for (unsigned int i = 0; i < 2; ++i)
        product *= std::sqrt(square(gears.tip[i] / gears.base[i]) - 1.) -
                   contact_ratio * pi / gears.teeth[i];
      return std::tan(gears.transverse_pressure_angle) / std::sqrt(product);
    }
  } // namespace

  BevelRating iso10300_b1(const RatedPair &pair, const double pinion_torque)
  {
    const VirtualGears gears(pair);
    BevelRating        rating;
    rating.transverse_contact_ratio = gears.contact_path / gears.base_pitch;
    rating.face_contact_ratio =
      gears.effective_width * std::sin(pair.spiral_angle) / (pi * pair.normal_module);
    if (!(rating.face_contact_ratio >= 1.))
      throw InputError(text_of("ISO 10300 B1: expected a face contact ratio of at least 1, got ",
                               rating.face_contact_ratio,
                               '.'));

    const ContactLines lines(pair, gears);
    rating.contact_line = lines.length(0.);
    const double beside = gears.base_pitch * std::cos(gears.base_spiral_angle);
    const double sharing =
      1. / (1. + 2 * lines.pressure(beside) * lines.length(beside) / rating.contact_line);
    rating.load_sharing = std::sqrt(sharing);

    const double inclination =
      std::atan(std::tan(pair.spiral_angle) * std::sin(pair.pressure_angle));
    const double curvature = square(std::cos(pair.spiral_angle)) / std::sin(pair.pressure_angle) *
                             (2. / gears.diameter[0] + 2. / gears.diameter[1]);
    rating.curvature_radius = square(std::cos(inclination)) / curvature;

    rating.mid_zone              = find_mid_zone(gears, rating.transverse_contact_ratio);
    rating.elasticity            = std::sqrt(pair.modulus / pi);
    const double pinion_diameter = gears.diameter[0] * std::cos(pair.members[0].pitch_angle);
    const double tangential      = 2 * pinion_torque / pinion_diameter;
    const double normal =
      tangential / (std::cos(pair.pressure_angle) * std::cos(pair.spiral_angle));
    rating.contact_stress = std::sqrt(normal / (rating.contact_line * rating.curvature_radius)) *
                            rating.mid_zone * rating.load_sharing * rating.elasticity;

    rating.spiral_angle_factor        = find_spiral_angle_factor(pair, gears, rating.contact_line);
    const double contact_ratio_factor = 0.625; // Y_eps for a face contact ratio of at least one
    const double shift =
      (pair.members[0].addendum - pair.members[1].addendum) / (2 * pair.normal_module);
    for (unsigned int i = 0; i < 2; ++i)
      {
        RatedTooth &tooth = rating.teeth[i];
        tooth             = rate_form(pair, gears, i, i == 0 ? shift : -shift);
        tooth.root_stress = tangential / (pair.face_width * pair.normal_module) *
                            tooth.form_factor * tooth.stress_correction * contact_ratio_factor *
                            rating.spiral_angle_factor * sharing;
      }
    return rating;
  }

  RatedPair rated_pair(const GearPair &pair, const MeshSide side, const double modulus)
  {
    const MeanContact &mean = pair.mean_contact(side);
    RatedPair          rated;
    for (unsigned int i = 0; i < 2; ++i)
      {
        const GearMember     &member = i == 0 ? pair.pinion() : pair.gear();
        const FlankSide       flank  = i == 0 ? pair.pinion_side(side) : pair.gear_side(side);
        const GeneratedPoint &point  = i == 0 ? mean.pinion : mean.gear;
        const Blank          &blank  = member.blank();
        const double          spiral = std::abs(member.generated_flank(flank).spiral_angle(point));
        // normal of the pitch cone in the meridian plane of the point
        const double  radius = std::hypot(point.position[0], point.position[1]);
        const Vector3 cone(std::cos(blank.pitch_angle) * point.position[0] / radius,
                           std::cos(blank.pitch_angle) * point.position[1] / radius,
                           -std::sin(blank.pitch_angle));
        rated.spiral_angle += spiral / 2;
        rated.pressure_angle += std::asin(std::abs(point.normal.dot(cone))) / 2;
        rated.members[i] = {double(blank.teeth),
                            blank.pitch_angle,
                            blank.mean_addendum,
                            blank.mean_dedendum,
                            member.tooth_thickness(blank.mean_cone_distance, 0.) * std::cos(spiral),
                            member.generated_flank(flank).settings().edge_radius};
      }
    const Blank &gear   = pair.gear().blank();
    rated.normal_module = gear.mean_module() * std::cos(rated.spiral_angle);
    rated.face_width    = gear.face_width;
    rated.modulus       = modulus;
    return rated;
  }
} // namespace vfife
