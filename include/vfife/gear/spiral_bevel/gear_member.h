// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_gear_member_h
#define vfife_gear_spiral_bevel_gear_member_h

#include <vfife/gear/errors/member_errors.h>
#include <vfife/gear/gear_geometry.h>
#include <vfife/gear/spiral_bevel/blank.h>
#include <vfife/gear/spiral_bevel/flank.h>

#include <string>

namespace vfife
{
  /**
   * One member of a spiral bevel pair: blank and two generated flanks with their fillets, in its
   * body frame (axis z from apex to back, apex at the origin). Tooth 0 is the tooth of the
   * reference contact. The fillet's parameter is the blade edge angle lambda [rad], its end where
   * the straight part of the blade starts: 90 deg - blade angle.
   */
  class GearMember : public GearGeometry
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

    std::unique_ptr<GearGeometry> clone() const override;

    const std::string &name() const override; ///< "pinion" or "gear"
    const Blank       &blank() const override;
    FlankSide          lower_side() const override;
    SurfacePoint       flank_point(FlankSide side, double L, double h) const override;
    SurfacePoint       fillet_point(FlankSide side, double L, double lambda) const override;
    double             fillet_end(FlankSide side) const override;
    bool               has_deviations() const override;
    bool               has_equal_teeth() const override;
    double deviation(FlankSide side, unsigned int tooth, const SurfacePoint &point) const override;

    const Flank &generated_flank(FlankSide side) const; ///< before the turn onto tooth 0
    double       turn(FlankSide side) const;

    /** Gives the teeth errors of manufacture. */
    void                set_errors(const MemberErrors &errors);
    const MemberErrors &errors() const;

    /** The generated flank with the errors of a tooth, and with those that all teeth share; it
     * stands where generated_flank() does. */
    Flank flank_of_tooth(FlankSide side, unsigned int tooth) const;
    Flank shared_flank(FlankSide side) const;

  private:
    std::string name_;
    Blank       blank_;
    Flank       concave_, convex_;
    double      concave_turn_, convex_turn_;
    FlankSide   lower_side_;

    MemberErrors errors_;
  };
} // namespace vfife

#endif
