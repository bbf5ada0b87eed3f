// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_conical_web_h
#define vfife_mesh_conical_web_h

#include <vfife/mesh/gear_body.h>

namespace vfife
{
  /**
   * Meridian (r, z) of a straight conical web between the rim's toe and the hub. A point has the
   * offset n from the mid-surface (front face -t/2, back face +t/2) and the fraction u of the way
   * from rim to hub.
   *
   * Rim and web meet on a mitre: a straight line from the root of the toe that halves the angle
   * between the lengthwise direction of the rim and the web, so that neither is cut at a sharp
   * angle and the web covers exactly its thickness of the depth under the root.
   */
  class ConicalWeb
  {
  public:
    /** @p root_height: h of the root land at the toe [mm]. */
    ConicalWeb(const Blank &blank, const GearBodyOptions &options, double root_height);

    /** dL/d(depth) of the mitre, the depth counted along -h under the root. */
    double mitre_slope() const;

    /** Depth under the root of the mitre point at offset @p n. */
    double depth(double n) const;

    /** (r, z) at fraction u in [0, 1] and offset n; u = 0 is the mitre, u = 1 the hub cylinder. */
    Vector2 point(double u, double n) const;

    /** Length of the mid-surface's generatrix from mitre to hub [mm]. */
    double length() const;

    /** Signed angle from the toe face's normal to the web, + towards the underside [rad]. */
    static double turn_from_toe(const Blank &blank, const GearBodyOptions &options);

  private:
    double start(double n) const;
    double end(double n) const;

    Vector2 centre_;    ///< mid-surface on the mitre
    Vector2 direction_; ///< along the web, inward
    Vector2 normal_;    ///< of the web, to the back face
    Vector2 mitre_;     ///< along the mitre, downward, one unit of depth long
    double  slope_;
    double  middle_depth_;
    double  hub_radius_;
  };
} // namespace vfife

#endif
