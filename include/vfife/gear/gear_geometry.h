// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_gear_geometry_h
#define vfife_gear_gear_geometry_h

#include <vfife/base/types.h>
#include <vfife/gear/blank_outline.h>

#include <memory>
#include <string>

namespace vfife
{
  /** The two flanks of a tooth. Where teeth are straight the words are but names: either flank may
   * be called concave. */
  enum class FlankSide
  {
    concave,
    convex
  };

  /** "concave", "convex". */
  inline const char *name_of(const FlankSide side)
  {
    return side == FlankSide::concave ? "concave" : "convex";
  }

  inline FlankSide opposite(const FlankSide side)
  {
    return side == FlankSide::concave ? FlankSide::convex : FlankSide::concave;
  }

  /** A point of a tooth's surface: position [mm], unit normal into the metal. */
  struct SurfacePoint
  {
    Vector3 position = Vector3::Zero();
    Vector3 normal   = Vector3::Zero();
  };

  /** Whether the point lies on a lower flank of a tooth: the metal is at larger polar angles about
   * the axis. */
  inline bool is_on_lower_flank(const SurfacePoint &point)
  {
    return point.position[0] * point.normal[1] - point.position[1] * point.normal[0] > 0.;
  }

  /**
   * What a mesh needs to know of any gear: outline of the blank, and points of the true surfaces of
   * its tooth 0. A kind of gear (spiral_bevel/gear_member.h) is a class that says this.
   *
   * Body frame: the axis is z, lengths in mm. Tooth k is tooth 0 turned by k pitches about +z. Of a
   * tooth the lower flank lies at the smaller polar angle, the upper one at the larger. A section
   * L = const has, from the root up,
   *
   * @verbatim
   *              tip  _______
   *                  /       \          h = a(L)
   *     lower flank /         \ upper flank      h = 0 is on the flanks
   *                |           |        fillet parameter at its end: the flank starts
   *       fillet   (           )
   *     __________/             \__________      fillet parameter 0: root
   *     root land    tooth 0
   * @endverbatim
   *
   * The pitch surface is a cone or cylinder; all teeth are alike but for small deviations of
   * their flanks, which surfaces in contact know and meshes do not. Flanks are continued a little
   * beyond tip, toe and heel: points are asked for there while offsets are searched for.
   */
  class GearGeometry
  {
  public:
    virtual ~GearGeometry() = default;

    /** A copy, for those that outlive this object. */
    virtual std::unique_ptr<GearGeometry> clone() const = 0;

    /** Of the body that it is meshed into: "pinion", "gear". */
    virtual const std::string &name() const = 0;

    virtual const BlankOutline &blank() const = 0;

    /** The flank at the smaller polar angle of tooth 0. */
    virtual FlankSide lower_side() const = 0;

    /** A flank of tooth 0 at (L, h) of the blank. Throws InputError where there is none. */
    virtual SurfacePoint flank_point(FlankSide side, double L, double h) const = 0;

    /**
     * The fillet beside that flank at L, along the profile by a parameter in [0, fillet_end()]: 0
     * at the root, where the fillet may run level with it, the end where the flank starts. Throws
     * InputError where there is none.
     */
    virtual SurfacePoint fillet_point(FlankSide side, double L, double parameter) const = 0;

    /** Largest parameter of the fillet, of the order of one. */
    virtual double fillet_end(FlankSide side) const = 0;

    /** Whether flanks deviate from flank_point(), and whether those of all teeth do so alike. */
    virtual bool has_deviations() const;
    virtual bool has_equal_teeth() const;

    /**
     * How far a flank of tooth @p tooth lies out of the metal, along the normal, by errors of
     * manufacture [mm]; 0 where there are none. @p point: the flank_point() there, of tooth 0.
     */
    virtual double deviation(FlankSide side, unsigned int tooth, const SurfacePoint &point) const;

    /** The other flank. */
    FlankSide upper_side() const;

    /** Angle between teeth, 2 pi / z [rad]. */
    double pitch() const;

    /** Transverse thickness of a tooth at (L, h): arc between its flanks about the axis [mm]. */
    double tooth_thickness(double L, double h) const;

  protected:
    // copied by those who implement it alone
    GearGeometry()                                = default;
    GearGeometry(const GearGeometry &)            = default;
    GearGeometry &operator=(const GearGeometry &) = default;
  };
} // namespace vfife

#endif
