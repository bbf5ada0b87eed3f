// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_flank_h
#define vfife_gear_spiral_bevel_flank_h

#include <vfife/gear/errors/flank_deviation.h>
#include <vfife/gear/gear_geometry.h>
#include <vfife/gear/spiral_bevel/machine_settings.h>

#include <optional>
#include <string>

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
   * Tooth flank and fillet cut by one side of a face-milling cutter (method: Litvin & Fuentes, Gear
   * Geometry and Applied Theory; derivation in doc/theory/gear.md). Body frame: z from the apex to
   * the back, apex at the origin.
   */
  class Flank
  {
  public:
    /** Throws InputError when the settings have no ratio of roll or no point radius. */
    Flank(const MachineSettings &settings, double pitch_angle);

    const MachineSettings &settings() const;
    FlankSide              side() const;

    /**
     * The same flank with errors of manufacture, given in its frame: points of the generated flank
     * are moved along their normals, all else that is asked for follows from the moved surface.
     * Fillets stay.
     */
    Flank with_deviation(const FlankDeviation &deviation) const;

    /** The flank as explicit surface of (t, phi). */
    GeneratedPoint evaluate(double t, double phi) const;
    /** The same with its first derivatives. */
    SurfaceDerivatives derivatives(double t, double phi) const;

    /**
     * The flank at cone coordinates (L, h): the point that the cutter leaves, on the sheet of the
     * generated surface that belongs to the tooth (clearing() > 0). Throws InputError where there
     * is none.
     */
    GeneratedPoint point_at(double L, double h) const;
    /**
     * The fillet at cone distance L, blade edge angle lambda in [0, 90 deg - blade angle]; throws
     * InputError when there is none.
     */
    GeneratedPoint fillet_at(double L, double lambda) const;

    /**
     * Second derivative by phi of the cutter's distance from a point of the generated surface
     * [mm/rad^2]: positive where the positions of the cutter before and after leave the point, 0 on
     * the surface's edge of regression, negative on its other sheet, which they cut away. The
     * derivatives are those without deviation.
     */
    double clearing(const SurfaceDerivatives &surface) const;

    /** Whether the cutter leaves a point of the generated surface: clearing() > 0. */
    bool is_left(const GeneratedPoint &point) const;

    /** Principal curvatures k1 <= k2 [1/mm], + bends to the metal. */
    Vector2 principal_curvatures(const GeneratedPoint &point) const;
    /** Symmetric tensor K in the body frame, K normal = 0, whose curvature along a tangent d is d.K
     * d [1/mm]. */
    Matrix3 curvature_tensor(const GeneratedPoint &point) const;
    /** Spiral angle at a point: of the flank's trace on the cone through it, to the cone's
     * generatrix [rad]. */
    double spiral_angle(const GeneratedPoint &point) const;
    /** Cone coordinates (L, h) of a position in the body frame. */
    Vector2 cone_coordinates(const Vector3 &position) const;

    /** Ratio of roll at which the blade's point (t, s) generates while the cradle is at rest, phi =
     * 0. */
    static double ratio_of_roll_at(const MachineSettings &settings, double t, double s);

    /**
     * Angle t of the blade's normal with the component @p axial along the blank's axis, with the
     * cradle at rest; of the two, the one on the side of the cutter that faces the blank. Nearest
     * where the normal cannot have such a component.
     */
    static double angle_of_normal(const MachineSettings &settings, double axial);

    /** Where the straight part of the blade starts: distance from the (sharp) tip along the blade
     * [mm]. */
    double straight_start() const;

  private:
    /** As it is generated. */
    SurfaceDerivatives generate(double t, double phi) const;
    /** With the deviation; derivatives of the normal are left out. */
    SurfaceDerivatives displace(double t, double phi) const;

    /** The cutter at a rotation of the cradle. */
    struct Cutter;
    /** A vector that moves with the cutter, with its derivatives. */
    struct Moving;
    Cutter cutter_at(double phi) const;
    Moving relative_to_apex(const Cutter &cutter, const Moving &from_center) const;
    /** The same in the body frame, the derivative including the blank's rotation. */
    Moving into_body(const Cutter &cutter, const Moving &v) const;

    /** Equation of meshing n . (relative velocity) of a position relative to the apex, and its
     * derivatives; with @p apex = 0 the part that is linear in the position. [mm] */
    struct Meshing;
    Meshing meshing(const Cutter  &cutter,
                    const Moving  &normal,
                    const Moving  &position,
                    const Vector3 &apex) const;

    /** A point of the blade's edge: position (from the apex), normal, equation of meshing. */
    struct EdgePoint;
    EdgePoint edge_point(double t, double phi, double lambda) const;

    /** Newton's start: the cutter passes the pitch generatrix at distance L with the cradle at
     * rest. */
    Vector2 start(double L) const;
    /** The passage of the blade at the angle theta of the circle (L, h), counted about the blank's
     * axis from the plane of the root generatrix. */
    struct Passage;
    Passage passage(const Vector2 &L_h, double theta) const;
    /** (t, phi) of the passage that cuts the circle (L, h) last; none where no blade does. */
    std::optional<Vector2> find_last_cut(const Vector2 &L_h) const;
    /** Throws InputError: no such surface at cone distance @p L and the other coordinate. */
    [[noreturn]] void refuse(const char        *surface,
                             double             L,
                             const char        *name,
                             double             value,
                             const std::string &reason = {}) const;
    Vector3           into_blank_frame(const Vector3 &v) const;

    MachineSettings settings_;
    double          cos_pitch_, sin_pitch_;
    double          sin_blade_, cos_blade_;
    double          sin_root_, cos_root_;
    Vector3         apex_; ///< O in the machine frame

    std::optional<FlankDeviation> deviation_;
  };
} // namespace vfife

#endif
