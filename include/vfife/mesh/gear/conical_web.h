// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_conical_web_h
#define vfife_mesh_gear_conical_web_h

#include <vfife/gear/gear_geometry.h>

#include <array>

namespace vfife
{
  enum class WebDirection
  {
    apex,   ///< from the rim inward and towards the apex
    back,   ///< from the rim inward and towards the back
    fitting ///< open: back where such a web leaves its wall steeply enough, otherwise apex
  };

  /** Where the web leaves the rim. */
  enum class WebAttachment
  {
    toe,    ///< the toe's end under the root
    middle, ///< the middle of the underside
    heel    ///< the heel's end of the underside
  };

  /** An arc in the meridian plane, about whose centre (r, z) a fillet of a web turns. */
  struct MeridianArc
  {
    Vector2 centre = Vector2::Zero(); ///< [mm]
    double  radius = 0;               ///< [mm]

    /** Whether a point of a body with the axis z is on the circle in its meridian, up to round-off.
     */
    bool contains(const Vector3 &x) const;
  };

  /** A conical web between rim and hub: sizes in the meridian plane. */
  struct WebShape
  {
    double web_thickness = 5.;          ///< normal to the web [mm]
    double web_angle = 70. * pi / 180.; ///< of the mid-surface generatrix to the gear axis [rad]
    WebDirection  web_direction     = WebDirection::back;
    WebAttachment web_attachment    = WebAttachment::toe;
    double        rim_thickness     = 8.5; ///< under the root [mm]
    double        rim_fillet_radius = 0.;  ///< of the web's faces at the rim; 0: none [mm]
    double        hub_fillet_radius = 0.;  ///< of the web's faces at the hub; 0: none [mm]
    double        hub_radius        = 60.; ///< [mm]
  };

  /**
   * Meridian (r, z) of a straight conical web between the rim's wall and the hub. A point has the
   * fraction x through the web (0 front face, towards the apex; 1 back face) and the fraction u of
   * the way from rim to hub. Fillets are arcs at both ends of both faces.
   *
   * At the toe the wall is a mitre: a straight line from the root of the toe that halves the angle
   * between the lengthwise direction of the rim and the web, so that neither is cut at a sharp
   * angle and the web covers exactly its thickness (and its fillets) of the depth under the root.
   * At the middle and the heel the wall is the underside of the rim.
   */
  class ConicalWeb
  {
  public:
    /** @p toe_root_height, @p heel_root_height: h of the root land at both ends [mm]. */
    ConicalWeb(const BlankOutline &blank,
               const WebShape     &shape,
               double              toe_root_height,
               double              heel_root_height);
    /** Between root lands at the dedendum of the blank. */
    ConicalWeb(const BlankOutline &blank, const WebShape &shape);

    /** dL/d(depth) of the mitre, the depth counted along -h under the root; 0 for the underside. */
    double mitre_slope() const;

    /** Where on the wall the web's point at fraction @p x stands: depth under the root (toe) or
     * cone distance L (underside) [mm]. */
    double wall_place(double x) const;
    /** (r, z) of such a place. */
    Vector2 wall_point(double place) const;

    /** (r, z) at fractions u and x; u = 0 is the wall, u = 1 the hub cylinder. */
    Vector2 point(double u, double x) const;

    /** Fractions u between which both faces are straight. */
    double straight_start() const;
    double straight_end() const;

    /** Length of the mid-surface's generatrix from wall to hub [mm]. */
    double length() const;

    /** Fillets of the front (0) and the back face (1) at the rim and at the hub; none: radius 0. */
    MeridianArc rim_fillet(unsigned int face) const
    {
      return rim_fillets_[face].arc();
    }
    MeridianArc hub_fillet(unsigned int face) const
    {
      return hub_fillets_[face].arc();
    }

    /** Length along the axis that it takes on the hub with its fillets [mm]. */
    double foot_on_hub() const;

    /** Signed angle from the normal of the rim's end or underside to the web [rad]. */
    static double turn_from_wall(const BlankOutline &blank, const WebShape &shape);

    /** Whether the web leaves its wall at 15 deg to it or more: a web steeper to the rim than this
     * would leave no room for cells between it and the rim. */
    static bool leaves_wall(const BlankOutline &blank, const WebShape &shape);

  private:
    /** Arc between the wall and a face of the web, both straight, that meet at @p corner. */
    struct Fillet
    {
      Vector2 corner = Vector2::Zero(), along_wall = Vector2::Zero(), along_web = Vector2::Zero();
      double  radius = 0;

      /** Distance of the arc's ends from the corner [mm]. */
      double tangent() const;
      /** Half the angle between wall and web [rad]. */
      double      half_angle() const;
      MeridianArc arc() const;
      /** Point of the arc: 0 on the wall, 1 on the web. */
      Vector2 point(double part) const;
    };

    Vector2 face_point(const Fillet &at_rim, const Fillet &at_hub, double u) const;
    double  end(double n) const;

    Vector2 direction_; ///< along the web, inward
    Vector2 normal_;    ///< of the web, to the back face
    Vector2 origin_;    ///< of the wall, place 0
    Vector2 wall_;      ///< along the wall for a unit of its place
    Vector2 centre_;    ///< mid-surface on the wall
    double  slope_ = 0, hub_radius_;

    std::array<Fillet, 2> rim_fillets_, hub_fillets_; ///< of the front and the back face
    std::array<double, 2> wall_places_{};
  };
} // namespace vfife

#endif
