// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/gear/errors/member_errors.h>

#include <cmath>
#include <utility>

namespace vfife
{
  namespace
  {
    Vector3 radial(const double angle)
    {
      return {std::cos(angle), std::sin(angle), 0.};
    }

    /** Displacement of the toothing against the axis of rotation. */
    FlankShift runout_shift(const MemberErrorOptions &options, const GearGeometry &gear)
    {
      // Directions are counted from the middle of tooth 0 on the mean pitch circle.
      const BlankOutline &blank  = gear.blank();
      const double        L      = blank.mean_cone_distance;
      const Vector3       lower  = gear.flank_point(gear.lower_side(), L, 0.).position;
      const double        r      = std::hypot(lower[0], lower[1]);
      const double        middle = polar_angle(lower) + gear.tooth_thickness(L, 0.) / (2. * r);

      // Eccentricity: translation. Wobble a cos(theta - direction) along the axis on the circle of
      // radius r about the point P of the axis: rotation w x (X - P) with |w| = a/r, about the
      // direction a quarter turn behind.
      const Vector3 w = options.wobble / r * radial(middle + options.wobble_direction - pi / 2);
      const Vector3 P = lower[2] * Vector3::UnitZ();
      FlankShift    shift;
      shift.translation =
        options.eccentricity * radial(middle + options.eccentricity_direction) - w.cross(P);
      shift.rotation = w;
      return shift;
    }

    /** Normal offsets describe small deviations: mesh and tooth thickness remain those of the
     * generated flank. Throws InputError beyond a tenth of the mean transverse module. */
    void require_small(const double deviation, const double module, const std::string &entry)
    {
      constexpr double largest = 0.1; // of the module
      if (!(std::abs(deviation) <= largest * module))
        throw InputError(entry,
                         "expected deviations of at most " +
                           std::to_string(std::lround(largest * module / micrometre)) +
                           " um (a tenth of the mean module), got " +
                           number_text(deviation / micrometre) + " um");
    }

    /** With the names of their entries. */
    std::array<std::pair<double, const char *>, 5> list_terms(const EaseOffTerms &terms)
    {
      return {{{terms.pressure_angle, "profile slope"},
               {terms.spiral_angle, "lengthwise slope"},
               {terms.profile_crowning, "profile crowning"},
               {terms.lengthwise_crowning, "lengthwise crowning"},
               {terms.bias, "bias"}}};
    }
  } // namespace

  MemberErrors::MemberErrors(const MemberErrorOptions &options,
                             const GearGeometry       &gear,
                             const std::string        &section)
  {
    const unsigned int teeth      = gear.blank().teeth;
    const bool         has_runout = options.eccentricity != 0. || options.wobble != 0.;
    const FlankShift   runout     = has_runout ? runout_shift(options, gear) : FlankShift();
    const double       r = gear.blank().meridian_point({gear.blank().mean_cone_distance, 0.})[0];
    const double       module = 2. * r / teeth;
    require_small(options.eccentricity, module, section + "/radial runout amplitude");
    require_small(options.wobble, module, section + "/axial runout amplitude");
    any_         = has_runout;
    equal_teeth_ = !has_runout;
    for (const FlankSide side : {FlankSide::concave, FlankSide::convex})
      {
        const FlankErrorOptions &own    = options.flank(side);
        FlankErrors             &errors = flanks_[static_cast<unsigned int>(side)];
        const std::string        below =
          section + (side == FlankSide::concave ? "/Concave flank" : "/Convex flank");
        // 1. The form: terms, and a grid of all teeth or of some.
        const EaseOffTerms &terms     = own.terms;
        bool                has_terms = false;
        for (const auto &[deviation, entry] : list_terms(terms))
          {
            require_small(deviation, module, below + "/" + entry);
            has_terms = has_terms || deviation != 0.;
          }
        errors.shared              = {has_terms ? FlankArea(gear, side) : FlankArea(), terms, {}};
        any_                       = any_ || has_terms;
        errors.is_named            = own.read_teeth(below, teeth);
        errors.named               = errors.shared;
        const Eigen::MatrixXd grid = own.read_topography(below);
        if (grid.size() > 0)
          {
            require_small(grid.cwiseAbs().maxCoeff(), module, below + "/topography");
            errors.named.topography =
              Topography{FlankArea(gear, side, own.margins), BicubicGrid(grid)};
            if (own.topography_teeth.empty())
              errors.shared = errors.named;
            else
              equal_teeth_ = false;
            any_ = true;
          }
        // 2. The place of each tooth: metal on a lower flank is a turn in the - sense of the axis.
        const std::vector<double> pitch       = own.read_pitch(below, teeth);
        const char               *pitch_entry = own.pitch_amplitude != 0. ? "pitch amplitude"
                                                : own.pitch_table.empty() ? "single pitch deviations"
                                                                          : "pitch table";
        const double              sense       = side == gear.lower_side() ? -1. : 1.;
        for (unsigned int k = 0; k < teeth; ++k)
          {
            errors.shifts.push_back(runout.seen_turned(k * gear.pitch()));
            if (pitch.empty())
              continue;
            require_small(pitch[k], module, below + "/" + pitch_entry);
            errors.shifts.back().rotation[2] += sense * pitch[k] / r;
          }
        if (!pitch.empty())
          {
            any_         = true;
            equal_teeth_ = false;
          }
      }
  }

  bool MemberErrors::any() const
  {
    return any_;
  }

  bool MemberErrors::equal_teeth() const
  {
    return equal_teeth_;
  }

  const MemberErrors::FlankErrors &MemberErrors::flank(const FlankSide side) const
  {
    return flanks_[static_cast<unsigned int>(side)];
  }

  const FlankForm &MemberErrors::form(const FlankSide side, const unsigned int tooth) const
  {
    const FlankErrors &errors = flank(side);
    return errors.is_named[tooth] ? errors.named : errors.shared;
  }

  FlankDeviation MemberErrors::shared(const FlankSide side) const
  {
    return {flank(side).shared, FlankShift()};
  }

  FlankDeviation MemberErrors::of_tooth(const FlankSide side, const unsigned int tooth) const
  {
    return {form(side, tooth), flank(side).shifts[tooth]};
  }

  double MemberErrors::value(const FlankSide     side,
                             const unsigned int  tooth,
                             const SurfacePoint &point,
                             const Vector2      &L_h) const
  {
    return form(side, tooth).value(L_h) -
           point.normal.dot(flank(side).shifts[tooth].at(point.position));
  }
} // namespace vfife
