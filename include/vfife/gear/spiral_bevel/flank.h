// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_flank_h
#define vfife_gear_spiral_bevel_flank_h

#include <vfife/gear/errors/flank_deviation.h>
#include <vfife/gear/spiral_bevel/generated_surface.h>

#include <optional>
#include <string>

namespace vfife
{
  /**
   * Tooth flank and fillet cut by one side of a face-milling cutter: a generated surface with its
   * places on the cone of a blank and errors of manufacture (doc/theory/gear.md). Body frame: that
   * of GeneratedSurface.
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
     * generated surface that belongs to the tooth (GeneratedSurface::clearing() > 0). Throws
     * InputError where there is none.
     */
    GeneratedPoint point_at(double L, double h) const;
    /**
     * The fillet at cone distance L, blade edge angle lambda in [0, 90 deg - blade angle]; throws
     * InputError when there is none.
     */
    GeneratedPoint fillet_at(double L, double lambda) const;

    /** Whether the cutter leaves a point of the generated surface. */
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

    /** Where the straight part of the blade starts: distance from the (sharp) tip along the blade
     * [mm]. */
    double straight_start() const;

  private:
    /** With the deviation; derivatives of the normal are left out. */
    SurfaceDerivatives displace(double t, double phi) const;

    /** Newton's start: the cutter passes the pitch generatrix at distance L with the cradle at
     * rest. */
    Vector2 start(double L) const;
    /** Throws InputError: no such surface at cone distance @p L and the other coordinate. */
    [[noreturn]] void refuse(const char        *surface,
                             double             L,
                             const char        *name,
                             double             value,
                             const std::string &reason = {}) const;

    GeneratedSurface              surface_; ///< without deviation
    double                        cos_pitch_, sin_pitch_;
    std::optional<FlankDeviation> deviation_;
  };
} // namespace vfife

#endif
