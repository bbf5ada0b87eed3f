// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_mesh_quality_h
#define vfife_mesh_mesh_quality_h

#include <vfife/base/types.h>

#include <deal.II/grid/tria.h>

namespace vfife
{
  /** Figures of a mesh of 8-node hexahedra. */
  struct MeshQuality
  {
    unsigned int cells = 0;
    unsigned int nodes = 0;

    /**
     * Least over cells and corners of det(e1, e2, e3) / (|e1| |e2| |e3|), e the edges that leave
     * the corner: 1 for a box, <= 0 for an inverted corner.
     */
    double  least_scaled_jacobian = 0;
    Vector3 worst_cell_centre     = Vector3::Zero(); ///< [mm]

    /** Least determinant of dX/dxi on the unit cube, at corners and 2 x 2 x 2 Gauss points [mm^3].
     */
    double least_determinant = 0;
    /** The same at the Gauss points alone, and where that is. */
    double       least_gauss_determinant = 0;
    Vector3      worst_gauss_centre      = Vector3::Zero();
    unsigned int inverted_corners        = 0; ///< cells with a corner where it is not positive

    double least_edge   = 0; ///< [mm]
    double largest_edge = 0; ///< [mm]
    double least_height = 0; ///< volume over the largest face area: governs the stable step [mm]
    double largest_aspect_ratio = 0; ///< longest over shortest edge of a cell
    double volume               = 0; ///< of the trilinear cells, exact [mm^3]
  };

  /** Measures all active cells. */
  MeshQuality compute_mesh_quality(const dealii::Triangulation<3> &triangulation);
} // namespace vfife

#endif
