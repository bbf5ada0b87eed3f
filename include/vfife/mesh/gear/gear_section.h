// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_gear_section_h
#define vfife_mesh_gear_gear_section_h

#include <vfife/gear/gear_geometry.h>

#include <vector>

namespace vfife
{
  /**
   * Section L = const of tooth 0 and the two half slots beside it. Points are (h, angle): height
   * over the pitch line [mm] and polar angle about the axis [rad], increasing from the lower to the
   * upper flank.
   */
  struct GearSection
  {
    double cone_distance = 0; ///< L [mm]
    double root_height   = 0; ///< h of the root land [mm]
    double left_angle    = 0; ///< centre of the slot below the tooth [rad]
    double pitch         = 0; ///< to the centre of the slot above [rad]

    /**
     * Profiles of the two flanks from the root up: fillet bottom, P in the fillet, flank start,
     * then flank_rows points to the end of the flank, steps of h equal or graded; with a tip
     * chamfer one more, where it meets the top land.
     */
    std::vector<Vector2> lower, upper;
  };

  /** Where in the fillet the blocks of tooth, rim and root land meet (P): fraction of its blade
   * edge angle from the bottom, 42 of 70 deg. */
  constexpr double default_fillet_corner = .6;

  /** Rows of elements between the end of the flanks and the top land: one of a chamfer, or none. */
  unsigned int tip_rows(const BlankOutline &blank);

  /** The flank of tooth 0 at (L, h), or over its end the chamfer, straight in h and polar angle
   * from there to the top land [mm]. */
  Vector3 point_of_side(const GearGeometry &gear, FlankSide side, double L, double h);

  /** @p grading: last over first step of h. Throws InputError where the fillets of a slot overlap
   * or the flank starts over the tip. */
  GearSection compute_gear_section(const GearGeometry &gear,
                                   double              cone_distance,
                                   unsigned int        flank_rows,
                                   double              grading       = 1.,
                                   double              fillet_corner = default_fillet_corner);

  /**
   * The section with its outline moved into the metal by @p depth [mm], measured normal to the true
   * surfaces: fillets and flanks along their normals projected into the section, tip and root land
   * along h. A chamfer moves, without a change of its size, as the edge that it takes away.
   */
  GearSection move_inward(const GearGeometry &gear,
                          const GearSection  &section,
                          double              fillet_corner,
                          double              depth);

  /** Throws InputError of the entry "surface layer" in @p section where layers of this @p depth
   * [mm] leave less than a fifth of the top land between the two flanks. Nothing to check for 0. */
  void check_surface_layer(const std::string  &section,
                           const GearGeometry &gear,
                           double              fillet_corner,
                           double              depth);

  /** Depth of layers [mm] that leave half of the top land between the two flanks, at toe and heel.
   */
  double find_largest_surface_layer(const GearGeometry &gear, double fillet_corner);

  /** The n + 1 sections at even steps of L from toe to heel. */
  std::vector<GearSection> compute_gear_sections(const GearGeometry &gear,
                                                 unsigned int        n,
                                                 unsigned int        flank_rows,
                                                 double              grading = 1.,
                                                 double fillet_corner = default_fillet_corner);

  /** Centre of the slot below the tooth at L: linear between such sections, continued beyond the
   * ends [rad]. */
  double left_angle_at(const std::vector<GearSection> &sections, double L);

  /** (h, angle) of a position; of all polar angles the one nearest to @p near_angle. */
  Vector2 section_coordinates(const BlankOutline &blank, const Vector3 &x, double near_angle);

  /** Position of a point (L, h) at polar angle @p angle [mm]. */
  Vector3 position_of(const BlankOutline &blank, double L, double h, double angle);
} // namespace vfife

#endif
