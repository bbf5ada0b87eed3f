// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/newton.h>
#include <vfife/gear/spiral_bevel/flank_contact.h>
#include <vfife/gear/spiral_bevel/local_contact.h>
#include <vfife/gear/spiral_bevel/pair_proposal.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    constexpr double least_module = 0.2; // [mm]

    /** Mean working depth over the mean normal module, by teeth of the pinion (standard depth
     * system of face-milled gears). */
    double depth_factor(const unsigned int pinion_teeth)
    {
      constexpr double few[] = {1.750, 1.835, 1.895, 1.940, 1.975, 1.995}; // 6 to 11 teeth
      return pinion_teeth > 11 ? 2. : few[std::max(pinion_teeth, 6u) - 6];
    }

    /** Sizes in the middle of the tooth that blank and cutter follow from. */
    struct MeanSection
    {
      double ratio;         ///< square root of that of the virtual numbers of teeth, z / cos d
      double A;             ///< mean cone distance [mm]
      double normal_module; ///< [mm]
      double cutter_radius; ///< mean [mm]
      double clearance;     ///< [mm]

      MeanSection(const PairProposal &p, const Blank &pinion, const Blank &gear)
        : ratio(std::sqrt(p.gear_teeth * std::cos(pinion.pitch_angle) /
                          (p.pinion_teeth * std::cos(gear.pitch_angle))))
        , A(gear.mean_cone_distance)
        , normal_module(2. * A * std::sin(gear.pitch_angle) / p.gear_teeth *
                        std::cos(p.spiral_angle))
        , cutter_radius(p.cutter_radius > 0. ? p.cutter_radius : 0.82 * A)
        , clearance(0.125 * depth_factor(p.pinion_teeth) * normal_module)
      {
      }
    };

    /** Cones of both members: standard depth, clearance and duplex taper (doc/theory/gear.md). */
    void propose_blanks(const PairProposal &p, const double shaft_angle, Blank &pinion, Blank &gear)
    {
      // pitch cones
      pinion.teeth       = p.pinion_teeth;
      gear.teeth         = p.gear_teeth;
      pinion.hand        = p.pinion_hand;
      gear.hand          = opposite(p.pinion_hand);
      pinion.pitch_angle = pitch_angle_of(p.pinion_teeth, p.gear_teeth, shaft_angle);
      gear.pitch_angle   = pitch_angle_of(p.gear_teeth, p.pinion_teeth, shaft_angle);
      const double outer = p.module * p.gear_teeth / (2. * std::sin(gear.pitch_angle));
      for (Blank *blank : {&pinion, &gear})
        {
          if (p.face_width > 0.5 * outer)
            throw InputError("Gear pair/Proposal/face width",
                             text_of("a face width of ",
                                     p.face_width,
                                     " mm is more than half of the outer cone distance, ",
                                     outer,
                                     " mm, where teeth at the toe would be less than half as large "
                                     "as at the heel; at most 0.3 of it is usual"));
          blank->outer_cone_distance = outer;
          blank->face_width          = p.face_width > 0. ? p.face_width : 0.3 * outer;
          blank->mean_cone_distance  = outer - blank->face_width / 2;
          blank->spiral_angle        = p.spiral_angle;
        }
      // heights in the middle: the working depth shared by the ratio, clearance under it
      const MeanSection mean(p, pinion, gear);
      const double      depth = depth_factor(p.pinion_teeth) * mean.normal_module;
      gear.mean_addendum      = (0.21 + 0.29 / (mean.ratio * mean.ratio)) * depth;
      pinion.mean_addendum    = depth - gear.mean_addendum;
      pinion.mean_dedendum    = gear.mean_addendum + mean.clearance;
      gear.mean_dedendum      = pinion.mean_addendum + mean.clearance;

      // root cones: duplex taper, shared between the members as their dedenda are
      const double sum =
        duplex_dedendum_angles(gear, mean.cutter_radius, p.spiral_angle, p.pressure_angle);
      const double dedenda = pinion.mean_dedendum + gear.mean_dedendum;
      for (Blank *blank : {&pinion, &gear})
        blank->root_angle = blank->pitch_angle - sum * blank->mean_dedendum / dedenda;
      // tips run parallel to the mating roots
      pinion.face_angle = shaft_angle - gear.root_angle;
      gear.face_angle   = shaft_angle - pinion.root_angle;
    }

    /** Sliding base that lets the blade tips follow the root cone. */
    double sliding_base(const Blank &blank, const double machine_center_to_back)
    {
      const double angle = blank.pitch_angle - blank.root_angle;
      return blank.mean_cone_distance * std::sin(angle) - blank.mean_dedendum * std::cos(angle) -
             machine_center_to_back * std::sin(blank.root_angle);
    }

    /** Spread-blade cutter of the gear: both flanks of a slot in one cut. */
    void propose_gear_cutter(const PairProposal &p, const Blank &pinion, GearMemberOptions &gear)
    {
      const MeanSection mean(p, pinion, gear.blank);
      const double      m = mean.normal_module, tan_al = std::tan(p.pressure_angle);
      // circular thickness factor: the pinion's teeth are made thicker as the ratio grows
      const double ratio  = mean.ratio;
      const double factor = -0.088 + 0.092 * ratio - 0.004 * ratio * ratio +
                            0.0016 * (p.pinion_teeth - 30.) * (ratio - 1.);
      const double thickness =
        pi * m / 2 - (pinion.mean_addendum - gear.blank.mean_addendum) * tan_al - factor * m;
      const double width = pi * m - thickness - 2. * gear.blank.mean_dedendum * tan_al;
      if (!(width > 0.1 * m))
        throw InputError("Gear pair/Proposal/pressure angle",
                         "the root land of the gear slot is " + figure_text(width) +
                           " mm, expected at least " + figure_text(0.1 * m) +
                           " mm. Reduce the pressure angle or the tooth depth");
      // The cutter's axis stands where its blades pass the middle of the tooth at the spiral angle:
      //   S cos q = A_m cos(d - g) - r sin b,   S sin q = r cos b
      const double sign = gear.blank.hand == Hand::left ? 1. : -1.;
      const double x    = mean.A * std::cos(gear.blank.pitch_angle - gear.blank.root_angle) -
                       mean.cutter_radius * std::sin(p.spiral_angle);
      const double y       = mean.cutter_radius * std::cos(p.spiral_angle);
      gear.cutter_diameter = 2. * mean.cutter_radius;
      for (MachineSettings *settings : {&gear.concave, &gear.convex})
        {
          settings->point_radius       = mean.cutter_radius + settings->sigma() * width / 2;
          settings->blade_angle        = p.pressure_angle;
          settings->radial_distance    = std::hypot(x, y);
          settings->cradle_angle       = sign * std::atan2(y, x);
          settings->machine_root_angle = gear.blank.root_angle;
          settings->sliding_base       = sliding_base(gear.blank, 0.);
          settings->edge_radius        = std::min(0.25 * m, 0.6 * width);
        }
    }

    /** Pinion settings that cut a given point with a given normal, from the three that are free. */
    class PinionSynthesis
    {
    public:
      PinionSynthesis(const Blank           &blank,
                      const MachineSettings &settings,
                      const RigidMotion     &frame,
                      const Vector3         &position,
                      const Vector3         &normal)
        : blank_(blank)
        , settings_(settings)
        , frame_(frame)
        , position_(frame.rotation.transpose() * position)
        , normal_(frame.rotation.transpose() * normal)
      {
      }

      /** @p x: point radius, machine centre to back, blank offset [mm]. Returns the angle t. */
      MachineSettings settings(const Vector3 &x, double &t, double &rotation) const
      {
        MachineSettings result        = settings_;
        result.point_radius           = x[0];
        result.machine_center_to_back = x[1];
        result.blank_offset           = x[2];
        result.sliding_base           = sliding_base(blank_, x[1]);
        // Unknown are t, the cutter's place (S, q) and the ratio of roll; the cradle is at rest.
        const double sigma = result.sigma(), al = result.blade_angle, g = result.machine_root_angle;
        const double cos_g = std::cos(g), sin_g = std::sin(g), cos_al = std::cos(al),
                     sin_al = std::sin(al);

        // the component of the normal along the blank's axis gives t, its azimuth the rotation
        result.cradle_angle = blank_.hand == Hand::left ? 1. : -1.; // the sign counts here
        t                   = GeneratedSurface::angle_of_normal(result, normal_[2]);
        // the blade's normal in the frame of the blank; its azimuth gives the blank's rotation
        const Vector3 e(std::cos(t), std::sin(t), 0.);
        const Vector3 n = sigma * cos_al * e - sin_al * Vector3::UnitZ();
        Matrix3       to_blank;
        to_blank << sin_g, 0., cos_g, 0., -1., 0., cos_g, 0., -sin_g;
        const Vector3 n_blank = to_blank * n;
        rotation              = polar_angle(normal_) - polar_angle(n_blank);
        const Vector3 arm =
          to_blank.transpose() * (rotation_about(Vector3::UnitZ(), -rotation) * position_);

        // The point in the machine, on the blade at the height r_z = s cos al; the cutter's axis is
        // the blade's radius r_p + sigma s sin al away from it.
        const Vector3 apex(x[1] * cos_g, x[2], -result.sliding_base - x[1] * sin_g);
        const Vector3 r        = apex + arm;
        const double  s        = r[2] / cos_al;
        const Vector3 center   = r - (x[0] + sigma * s * sin_al) * e;
        result.radial_distance = std::hypot(center[0], center[1]);
        result.cradle_angle    = polar_angle(center);
        result.ratio_of_roll   = GeneratedSurface::ratio_of_roll_at(result, t, s);
        return result;
      }

      /** Curvature tensor in the fixed frame of the flank that these settings cut. */
      Matrix3 curvature_tensor(const Vector3 &x) const
      {
        double                t, rotation;
        const MachineSettings trial = settings(x, t, rotation);
        if (!(trial.ratio_of_roll > 0.))
          return Matrix3::Constant(not_known);
        const Flank   flank(trial, blank_.pitch_angle);
        const Matrix3 R = turned_frame(frame_, rotation).rotation;
        return R * flank.curvature_tensor(flank.evaluate(t, 0.)) * R.transpose();
      }

    private:
      const Blank    &blank_;
      MachineSettings settings_;
      RigidMotion     frame_;
      Vector3         position_, normal_; ///< in the pinion's frame at rotation 0
    };

    /** Local synthesis of one pinion flank: the settings whose flank has, at the mean point of the
     * gear flank, the curvatures that lag, path and ellipse ask for. */
    MachineSettings propose_pinion_flank(const PairProposal      &p,
                                         const double             shaft_angle,
                                         const Blank             &pinion,
                                         const GearMemberOptions &gear_options,
                                         const MachineSettings   &start,
                                         const MachineSettings   &gear_settings)
    {
      // 1. The gear's mean point, turned to where it meets the pinion: there the conjugate flank
      // touches along a line.
      const Blank         &gear  = gear_options.blank;
      const double         ratio = static_cast<double>(pinion.teeth) / gear.teeth;
      const RigidMotion    one   = pinion_frame(shaft_angle);
      const Flank          gear_flank(gear_settings, gear.pitch_angle);
      const GeneratedPoint point =
        gear_flank.point_at(gear.mean_cone_distance,
                            -(pinion.mean_addendum - gear.mean_addendum) / 2);
      double rot2 = -polar_angle(point.position);
      if (!find_meshing_rotation(point, one, gear_frame(), ratio, rot2))
        throw InputError("the gear flank does not mesh at its mean point; change the spiral angle "
                         "or the cutter radius");
      const Matrix3     R2 = turned_frame(gear_frame(), rot2).rotation;
      const LineContact contact(R2 * point.position,
                                -(R2 * point.normal),
                                R2 * gear_flank.curvature_tensor(point) * R2.transpose(),
                                one.rotation.col(2),
                                Vector3::UnitZ(),
                                ratio);
      // 2. What is asked of the contact, in the fixed frame: lag'' of the parabola, direction of
      // the path, curvature of the gap along the major axis a, k a^2 / 2 = marking thickness.
      const LengthAndHeight tangents(gear, point.position, point.normal);
      const double          half_pitch = pi / pinion.teeth,
                   half_axis           = p.ellipse_length * gear.face_width / 2;
      // alike on both sides: the line of contact leans the other way on the other flank
      const double       path_angle = start.blade == Blade::outside ? p.path_angle : -p.path_angle;
      LocalContactDesign design;
      design.lag_curvature = 2. * p.lag / (half_pitch * half_pitch);
      design.path =
        R2 * (std::cos(path_angle) * tangents.lengthwise + std::sin(path_angle) * tangents.upward);
      design.small_curvature = 2. * marking_thickness / (half_axis * half_axis);
      const Matrix3 target   = pinion_curvature_tensor(contact, design);

      // 3. Three free settings, over A_m, for the three components of the curvature tensor in the
      // tangent plane (u, v); the derivatives by central differences.
      const PinionSynthesis synthesis(pinion, start, one, contact.position, contact.normal);
      const double          A = gear.mean_cone_distance;
      const Vector3         u = contact.normal.unitOrthogonal(), v = contact.normal.cross(u);
      const auto            residual_at = [&](const Vector3 &x) -> Vector3 {
        const Matrix3 difference = synthesis.curvature_tensor(A * x) - target;
        return A * Vector3(u.dot(difference * u), u.dot(difference * v), v.dot(difference * v));
      };
      const auto equations = [&](const Vector3 &x, Vector3 &residual, Matrix3 &jacobian) {
        constexpr double step = 1e-5;
        residual              = residual_at(x);
        for (unsigned int j = 0; j < 3; ++j)
          jacobian.col(j) =
            (residual_at(x + step * Vector3::Unit(j)) - residual_at(x - step * Vector3::Unit(j))) /
            (2. * step);
      };
      // 4. Newton from the gear's cutter and a machine without offset.
      Vector3 x(gear_options.cutter_diameter / (2. * A), 0., 0.);
      if (!solve_newton<3>(equations, x))
        throw InputError("no machine settings cut the required pinion flank");
      // Newton's method may run away to where the flank has the curvatures at this point alone.
      if (std::max(std::abs(x[1]), std::abs(x[2])) > 1.)
        throw InputError(text_of("the required pinion flank needs a machine center to back of ",
                                 A * x[1],
                                 " mm and a blank offset of ",
                                 A * x[2],
                                 " mm, more than the mean cone distance, ",
                                 A,
                                 " mm"));
      double t, rotation;
      return synthesis.settings(A * x, t, rotation);
    }
  } // namespace

  void propose(const PairProposal &proposal,
               const double        shaft_angle,
               GearMemberOptions  &pinion,
               GearMemberOptions  &gear)
  {
    if (proposal.gear_teeth == 0 || proposal.pinion_teeth < 6)
      throw InputError("Gear pair/Proposal/pinion teeth",
                       "expected at least 6 pinion teeth and the number of gear teeth");
    if (proposal.pinion_teeth > proposal.gear_teeth)
      throw InputError("Gear pair/Proposal/pinion teeth",
                       "the pinion has " + std::to_string(proposal.pinion_teeth) +
                         " teeth, more than the gear with " + std::to_string(proposal.gear_teeth) +
                         "; the member with fewer teeth is the pinion (the gear may drive: "
                         "Operation/driving member)");
    std::string       entry;
    const std::string fault =
      find_ratio_fault(proposal.pinion_teeth, proposal.gear_teeth, shaft_angle, entry);
    if (!fault.empty())
      throw InputError(std::string("Gear pair/") +
                         (entry == "shaft angle" ? "Mounting/" : "Proposal/") + entry,
                       fault);
    if (!(proposal.module > 0.))
      throw InputError("Gear pair/Proposal/module",
                       "expected the outer transverse module, got none");
    // The ellipse that is asked for is one of marking compound, whose film is too thick for smaller
    // teeth.
    if (proposal.module < least_module)
      throw InputError("Gear pair/Proposal/module", "must be at least 0.2 mm");
    // the gear alone, then pinion flanks that fit it
    propose_blanks(proposal, shaft_angle, pinion.blank, gear.blank);
    propose_gear_cutter(proposal, pinion.blank, gear);
    for (MachineSettings *settings : {&gear.concave, &gear.convex})
      settings->ratio_of_roll = settings->conjugate_ratio_of_roll(gear.blank.pitch_angle);

    // concave on convex and convex on concave
    const double edge = 0.2 * MeanSection(proposal, pinion.blank, gear.blank).normal_module;
    for (MachineSettings *settings : {&pinion.concave, &pinion.convex})
      {
        settings->blade_angle        = proposal.pressure_angle;
        settings->machine_root_angle = pinion.blank.root_angle;
        settings->edge_radius        = edge;
        const MachineSettings &mate  = settings == &pinion.concave ? gear.convex : gear.concave;
        try
          {
            *settings =
              propose_pinion_flank(proposal, shaft_angle, pinion.blank, gear, *settings, mate);
          }
        catch (const InputError &error)
          {
            refuse_proposal(proposal, shaft_angle, error.what());
          }
      }
  }

  void
  refuse_proposal(const PairProposal &proposal, const double shaft_angle, const std::string &reason)
  {
    std::ostringstream text;
    text << "no pair of " << proposal.pinion_teeth << "/" << proposal.gear_teeth
         << " teeth is found at a shaft angle of " << shaft_angle / degree
         << " deg and a spiral angle of " << proposal.spiral_angle / degree << " deg: " << reason
         << ". Try a path angle near 25 deg, a larger cutter radius, more teeth of the pinion or "
            "another spiral angle";
    throw InputError("Gear pair/Proposal", text.str());
  }

  void PairProposal::declare(dealii::ParameterHandler &prm)
  {
    declare_integer(prm,
                    "pinion teeth",
                    pinion_teeth,
                    "Number of teeth; 0: no proposal, blanks and machine settings are given");
    declare_integer(prm, "gear teeth", gear_teeth, "Number of teeth of the gear");
    declare_choice(prm,
                   "pinion hand",
                   pinion_hand,
                   hand_choices(),
                   "Hand of the pinion's spiral; the gear gets the opposite hand");
    declare_quantity(
      prm, "module", module, "mm", "Outer transverse module", Range::between(0., 100.));
    declare_quantity(prm,
                     "face width",
                     face_width,
                     "mm",
                     "Face width; auto: 0.3 of the outer cone distance",
                     Range::positive().or_word("auto"));
    declare_quantity(
      prm, "spiral angle", spiral_angle, "deg", "Mean spiral angle", Range::between(10., 50.));
    declare_quantity(prm,
                     "pressure angle",
                     pressure_angle,
                     "deg",
                     "Blade angle of both flanks",
                     Range::between(10., 30.));
    declare_quantity(prm,
                     "cutter radius",
                     cutter_radius,
                     "mm",
                     "Mean radius of the cutter; auto: 0.82 of the mean cone distance",
                     Range::positive().or_word("auto"));
    declare_quantity(prm,
                     "transmission error at half pitch",
                     lag,
                     "arcsec",
                     "Parabolic transmission error without load, half a pitch from the mean "
                     "contact (the gear lags)",
                     Range::positive());
    declare_quantity(prm,
                     "path direction",
                     path_angle,
                     "deg",
                     "Direction of the path of contact on the gear's convex flank, relative to the "
                     "lengthwise direction; positive: it rises to the tip at the heel; mirrored on "
                     "the concave flank",
                     Range::between(-90., 90.));
    declare_number(prm,
                   "contact ellipse ratio",
                   ellipse_length,
                   "Length of the contact ellipse (6.35 um separation) divided by the face width",
                   Range::positive());
  }
} // namespace vfife
