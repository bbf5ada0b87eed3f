// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_solid_integrals_h
#define vfife_mesh_solid_integrals_h

#include <vfife/base/types.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace vfife
{
  /**
   * Integrals over a solid whose axis is z: times the density they are mass and inertias. Solids
   * are taken to repeat about z at least three times, so that all axes normal to z are alike.
   */
  struct SolidIntegrals
  {
    double volume         = 0; ///< [mm^3]
    double radius_squared = 0; ///< of x^2 + y^2 [mm^5]
    double height         = 0; ///< of z [mm^4]
    double height_squared = 0; ///< of z^2 [mm^5]

    SolidIntegrals &operator+=(const SolidIntegrals &other);

    /** z of the centre of mass [mm]. */
    double centre() const;
    /** About z, per unit of density [mm^5]. */
    double polar() const;
    /** About an axis through the centre of mass normal to z, per unit of density [mm^5]. */
    double transverse() const;
  };

  /** Of the trilinear cells of a mesh, exact. @p weights: by active cell, say of density; empty: 1.
   */
  SolidIntegrals compute_solid_integrals(const dealii::Triangulation<3> &triangulation,
                                         const std::vector<double>      &weights = {});

  /** Of the solid of revolution of a polygon in the meridian, corners (r, z) in either sense: exact
   * (Pappus, by Green's theorem along the border). */
  SolidIntegrals compute_solid_integrals(const std::vector<Vector2> &meridian);
} // namespace vfife

#endif
