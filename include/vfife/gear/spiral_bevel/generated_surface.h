// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_generated_surface_h
#define vfife_gear_spiral_bevel_generated_surface_h

#include <vfife/gear/gear_geometry.h>
#include <vfife/gear/spiral_bevel/machine_settings.h>

namespace vfife
{
  /** A point of a generated surface with the surface's own parameters. */
  struct GeneratedPoint : SurfacePoint
  {
    double t   = 0; ///< angle about the cutter axis [rad]
    double phi = 0; ///< cradle rotation [rad]
    double s =
      0; ///< distance from the blade tip along the blade (flank) [mm] or lambda (fillet) [rad]
  };

  /** A point of a flank with the derivatives of position [mm/rad] and normal [1/rad] by t and phi.
   */
  struct SurfaceDerivatives
  {
    GeneratedPoint point;
    Vector3        position_t, position_phi;
    Vector3        normal_t, normal_phi;
  };

  /**
   * The surface that one blade of a face-milling cutter generates on a blank, by the angle t about
   * the cutter's axis and the rotation phi of the cradle (method: Litvin & Fuentes, Gear Geometry
   * and Applied Theory; derivation in doc/theory/gear.md). Body frame: z from the apex to the back,
   * apex at the origin.
   */
  class GeneratedSurface
  {
  public:
    /** Throws InputError when the settings have no ratio of roll or no point radius. */
    explicit GeneratedSurface(const MachineSettings &settings);

    const MachineSettings &settings() const;

    /** The point that the straight blade generates, with its derivatives. */
    SurfaceDerivatives generate(double t, double phi) const;

    /** A vector that moves with the cutter, with its derivatives by t and phi. */
    struct Moving
    {
      Vector3 value, t, phi;

      Moving operator+(const Moving &other) const
      {
        return {value + other.value, t + other.t, phi + other.phi};
      }
    };
    /** Equation of meshing n . (relative velocity), and its derivatives by t and phi [mm]. */
    struct Meshing
    {
      double value, t, phi;
    };
    /** A point of the blade's rounded edge: position and normal in the body frame, and its equation
     * of meshing, whose value is 0 where it generates. */
    struct EdgePoint
    {
      Moving  position, normal;
      Meshing meshing;
    };
    /** @p lambda: angle of the blade's edge, from 0 at the tip plane to 90 deg - blade angle. */
    EdgePoint edge_point(double t, double phi, double lambda) const;

    /**
     * Second derivative by phi of the cutter's distance from a point of the surface [mm/rad^2]:
     * positive where the positions of the cutter before and after leave the point, 0 on the
     * surface's edge of regression, negative on its other sheet, which they cut away.
     */
    double clearing(const SurfaceDerivatives &surface) const;

    /** Ratio of roll at which the blade's point (t, s) generates while the cradle is at rest, phi =
     * 0. */
    static double ratio_of_roll_at(const MachineSettings &settings, double t, double s);

    /**
     * Angle t of the blade's normal with the component @p axial along the blank's axis, with the
     * cradle at rest; of the two, the one on the side of the cutter that faces the blank. Nearest
     * where the normal cannot have such a component.
     */
    static double angle_of_normal(const MachineSettings &settings, double axial);

  private:
    /** The cutter at a rotation of the cradle. */
    struct Cutter;
    Cutter cutter_at(double phi) const;
    Moving relative_to_apex(const Cutter &cutter, const Moving &from_center) const;
    /** The same in the body frame, the derivative including the blank's rotation. */
    Moving into_body(const Cutter &cutter, const Moving &v) const;

    /** Of a position relative to the apex; with @p apex = 0 the part that is linear in the
     * position. */
    Meshing meshing(const Cutter  &cutter,
                    const Moving  &normal,
                    const Moving  &position,
                    const Vector3 &apex) const;
    Vector3 into_blank_frame(const Vector3 &v) const;

    MachineSettings settings_;
    double          sin_blade_, cos_blade_;
    double          sin_root_, cos_root_;
    Vector3         apex_; ///< O in the machine frame
  };
} // namespace vfife

#endif
