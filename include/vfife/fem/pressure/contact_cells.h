// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_contact_cells_h
#define vfife_fem_pressure_contact_cells_h

#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/contact/surface/surface_geometry.h>

#include <array>
#include <limits>
#include <vector>

namespace vfife
{
  /** Two groups of facets that may touch, in their current state. */
  struct FacingSurfaces
  {
    SurfaceGeometry *slave = nullptr, *master = nullptr;
    unsigned int     slave_group = 0, master_group = 0;
    double           depth_limit = 0; ///< penetrations beyond it are no contact [mm]
  };

  /** The plane of a contact's own grid: cells are rectangles with the sides [mm] along both
   * axes, their middles at whole numbers of sides from the origin. */
  struct ContactPlane
  {
    Vector3 origin = Vector3::Zero(), normal = Vector3::UnitZ();
    Vector3 along = Vector3::UnitX(), across = Vector3::UnitY();
    Vector2 sides = Vector2::Ones();
    /** Cells up to these places are looked at. */
    Vector2 reach = Vector2::Constant(std::numeric_limits<double>::infinity());
  };

  /** Where a cell lies on one of the surfaces. */
  struct CellFoot
  {
    unsigned int                facet = 0;
    Vector2                     place = Vector2::Zero(); ///< (xi, eta) on the facet
    std::array<unsigned int, 4> nodes{};                 ///< surface nodes
    std::array<double, 4>       weights{};               ///< bilinear
  };

  /** A cell of the grid where both surfaces face each other. */
  struct ContactCell
  {
    std::array<int, 2>      place{};                    ///< steps along and across
    Vector3                 position = Vector3::Zero(); ///< of its middle on the slave's facet [mm]
    Vector3                 normal   = Vector3::Zero(); ///< unit, out of the master
    double                  gap      = 0; ///< of the true surfaces along the normal [mm]
    std::array<CellFoot, 2> feet;         ///< on slave and master
  };

  /** A quadrature point of the slave that faces the master; its cell's place: of the facet in its
   * group, of the point in the rule. */
  struct FacingPoint
  {
    ContactCell cell;
    double      area = 0; ///< undeformed, with the fading at the master's border [mm^2]
  };

  /** Coordinates (xi, eta) of a plane quadrilateral with these @p corners in cyclic order whose
   * point is @p target, by Newton's method; says whether it is inside. */
  bool
  find_in_quadrilateral(const std::array<Vector2, 4> &corners, const Vector2 &target, Vector2 &xi);

  /** The points of a @p rule on the slave's facets with gaps below @p reach [mm]. @p edge_fading:
   * ContactOptions::edge_fading. */
  std::vector<FacingPoint> find_facing_points(const FacingSurfaces                    &surfaces,
                                              const std::vector<FacetQuadraturePoint> &rule,
                                              double                                   edge_fading,
                                              double                                   reach);

  /** The smallest gap at samples of the slave that have a point of the master under them; infinite
   * where there are none [mm]. */
  double find_least_gap(const FacingSurfaces &surfaces);

  /** Origin and axes of a plane through the place where the surfaces are nearest to each other, the
   * first axis along the longer extent of what is near, with about @p n cells over that. Throws
   * NumericalError where the surfaces do not face each other. */
  ContactPlane place_contact_plane(const FacingSurfaces &surfaces, unsigned int n);

  /** All cells whose middles lie on both surfaces, with the gaps of the true surfaces, sorted by
   * their places. */
  std::vector<ContactCell> find_contact_cells(const FacingSurfaces &surfaces,
                                              const ContactPlane   &plane);
} // namespace vfife

#endif
