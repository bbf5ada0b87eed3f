// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_cutter_passages_h
#define vfife_gear_spiral_bevel_cutter_passages_h

#include <vfife/base/types.h>
#include <vfife/gear/spiral_bevel/machine_settings.h>

#include <optional>

namespace vfife
{
  /**
   * Positions of a cutter whose blade passes a circle about the blank's axis; the tilt of the
   * cutter is left out.
   */
  class CutterPassages
  {
  public:
    /** @p r_z: radius of the circle and its place along the axis from the apex [mm]. */
    CutterPassages(const MachineSettings &settings, const Vector2 &r_z);

    /** Whether the blade passes the circle in the plane of the root generatrix. */
    bool reach_root_plane() const;

    /** (t, phi) of the passage that cuts the circle last; none where no blade does. */
    std::optional<Vector2> find_last() const;

  private:
    struct Passage
    {
      bool   exists = false;
      double t = 0, phi = 0;
      double approach = 0; ///< speed of the blade along its normal, relative to the blank [mm/rad]
    };
    /** At the angle @p theta of the circle, counted about the blank's axis from the plane of the
     * root generatrix. */
    Passage at(double theta) const;

    MachineSettings settings_;
    Vector2         r_z_;
    double          sin_blade_, cos_blade_;
    double          sin_root_, cos_root_;
  };
} // namespace vfife

#endif
