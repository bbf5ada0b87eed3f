// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_gear_member_h
#define vfife_gear_gear_member_h

#include <vfife/gear/blank.h>
#include <vfife/gear/flank.h>

#include <string>

namespace vfife
{
  /**
   * One member of a pair: blank and two generated flanks with their fillets, in its body frame
   * (axis z from apex to back, apex at the origin). "Tooth 0" is the tooth of the reference
   * contact; tooth k is tooth 0 turned by k 2 pi / z about +z. Of a tooth, the lower flank lies at
   * the smaller polar angle.
   */
  class GearMember
  {
  public:
    /** @p concave_turn, @p convex_turn: rotation about z that brings each generated flank onto
     * tooth 0 [rad]. */
    GearMember(std::string  name,
               const Blank &blank,
               const Flank &concave,
               const Flank &convex,
               double       concave_turn,
               double       convex_turn);

    const std::string &name() const; ///< "pinion" or "gear"
    const Blank       &blank() const;
    const Flank       &generated_flank(FlankSide side) const; ///< before the turn onto tooth 0
    double             turn(FlankSide side) const;

    /** The flank at the smaller polar angle of tooth 0, and the other one. */
    FlankSide lower_side() const;
    FlankSide upper_side() const;

    /** Angle between teeth, 2 pi / z [rad]. */
    double pitch() const;

    /** Point and unit normal (into the metal) of a flank of tooth 0 at cone coordinates (L, h). */
    SurfacePoint flank_point(FlankSide side, double L, double h) const;

    /**
     * Point and normal (into the metal) of the fillet beside that flank at cone distance L; lambda
     * in [0, 90 deg - blade angle]: 0 on the root cone, the upper end where the flank starts.
     */
    SurfacePoint fillet_point(FlankSide side, double L, double lambda) const;

    /** Largest lambda of the fillet: 90 deg - blade angle [rad]. */
    double fillet_end(FlankSide side) const;

    /** Transverse thickness of a tooth at cone coordinates (L, h): arc between its flanks about the
     * axis [mm]. */
    double tooth_thickness(double L, double h) const;

  private:
    std::string name_;
    Blank       blank_;
    Flank       concave_, convex_;
    double      concave_turn_, convex_turn_;
    FlankSide   lower_side_;
  };
} // namespace vfife

#endif
