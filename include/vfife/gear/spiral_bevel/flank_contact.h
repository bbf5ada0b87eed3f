// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_flank_contact_h
#define vfife_gear_spiral_bevel_flank_contact_h

#include <vfife/base/types.h>
#include <vfife/gear/spiral_bevel/flank.h>

namespace vfife
{
  /**
   * Fixed frame of a pair: common apex, gear axis z, pinion axis in the plane y = 0 at the shaft
   * angle, so x for 90 deg. The pinion's body frame at rotation 0.
   */
  RigidMotion pinion_frame(double shaft_angle);
  /** The same for the gear. */
  RigidMotion gear_frame();

  /** @p frame turned by @p rotation [rad] about the body's own axis z. */
  RigidMotion turned_frame(const RigidMotion &frame, double rotation);

  /**
   * Finds the rotation of the gear, next to the one in @p rotation, at which a point of its flank
   * satisfies the equation of meshing with the pinion at the exact speed ratio. Returns false where
   * none does.
   */
  bool find_meshing_rotation(const GeneratedPoint &gear_point,
                             const RigidMotion    &pinion_frame,
                             const RigidMotion    &gear_frame,
                             double                speed_ratio,
                             double               &rotation);

  /** Thickness of marking compound: the separation at which contact ellipses are judged [mm]. */
  constexpr double marking_thickness = 0.00635;

  /** Curvatures of the gap between two flanks at their contact point, and the ellipse of a given
   * separation. */
  struct ContactEllipse
  {
    Vector2 relative_curvatures; ///< smaller and larger one [1/mm]
    Vector2 semi_axes;           ///< along the directions of these curvatures [mm]
    Vector3 major_direction;     ///< fixed frame, of the smaller curvature
  };

  /**
   * The equations that two mounted flanks satisfy where they touch (doc/theory/gear.md, local
   * conditions).
   */
  class FlankContact
  {
  public:
    /** t, phi and rotation of the pinion, then of the gear [rad]. */
    using Unknowns = Eigen::Matrix<double, 6, 1>;
    enum Unknown
    {
      t1,
      phi1,
      rot1,
      t2,
      phi2,
      rot2
    };
    using Jacobian = Eigen::Matrix<double, 6, 6>;

    /** @p speed_ratio: gear speed over pinion speed, z1/z2; @p length: scale of positions [mm]. */
    FlankContact(const Flank       &pinion,
                 const Flank       &gear,
                 const RigidMotion &pinion_frame,
                 const RigidMotion &gear_frame,
                 double             speed_ratio,
                 double             length);

    const Flank &pinion() const;
    const Flank &gear() const;

    const RigidMotion &pinion_frame() const;
    const RigidMotion &gear_frame() const;

    /**
     * Rows 0-2: the points coincide (over length); 3, 4: the normals are opposite; 5: the relative
     * velocity at exact speed ratio has no normal component (over length).
     */
    void evaluate(const Unknowns &x, Unknowns &residual, Jacobian &jacobian) const;

    /**
     * Finds where the flanks touch at the pinion rotation in @p x, from the start in x (five
     * equations). Returns whether it converged.
     */
    bool solve_at_rotation(Unknowns &x) const;

    /**
     * Follows the contact from the solution @p x to another rotation of the pinion [rad], in short
     * steps, continued beyond the borders of the flanks. Returns whether they touch all the way.
     */
    bool follow(double rotation, Unknowns &x) const;

    /** Ellipse on which the flanks that touch at @p x are @p separation [mm] apart. */
    ContactEllipse ellipse(const Unknowns &x, double separation) const;

  private:
    Flank       pinion_, gear_;
    RigidMotion pinion_frame_, gear_frame_;
    double      speed_ratio_, length_;
  };
} // namespace vfife

#endif
