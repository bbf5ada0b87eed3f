// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_errors_member_errors_h
#define vfife_gear_errors_member_errors_h

#include <vfife/gear/errors/member_error_options.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * Errors of manufacture of the teeth of one member (doc/theory/errors.md): how far the flanks lie
   * out of the metal from the generated ones. Points and shifts are those of a tooth that is turned
   * onto tooth 0, in the body frame. All deviations are small against the radii of curvature, and
   * add up along the normal.
   */
  class MemberErrors
  {
  public:
    /** None. */
    MemberErrors() = default;

    /** Of @p gear, the member without errors. Throws InputError naming the entry below @p section
     * that cannot be used. */
    MemberErrors(const MemberErrorOptions &options,
                 const GearGeometry       &gear,
                 const std::string        &section);

    /** Whether there are any. */
    bool any() const;

    /** Whether all teeth have the same. */
    bool equal_teeth() const;

    /** What the flanks of all teeth have in common: their form. */
    FlankDeviation shared(FlankSide side) const;

    /** Everything that the flank of a tooth has. */
    FlankDeviation of_tooth(FlankSide side, unsigned int tooth) const;

    /** Out of the metal at a point of the flank without errors [mm]. */
    double
    value(FlankSide side, unsigned int tooth, const SurfacePoint &point, const Vector2 &L_h) const;

  private:
    struct FlankErrors
    {
      FlankForm               shared, named; ///< named: with the grid that not all teeth have
      std::vector<bool>       is_named;      ///< of the teeth
      std::vector<FlankShift> shifts;        ///< of the teeth, in the frame of tooth 0
    };

    const FlankErrors &flank(FlankSide side) const;
    const FlankForm   &form(FlankSide side, unsigned int tooth) const;

    std::array<FlankErrors, 2> flanks_; ///< concave, convex
    bool                       any_ = false, equal_teeth_ = true;
  };
} // namespace vfife

#endif
