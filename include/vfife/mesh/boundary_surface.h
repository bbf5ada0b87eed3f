// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_boundary_surface_h
#define vfife_mesh_boundary_surface_h

#include <vfife/mesh/body_mesh.h>

#include <deal.II/grid/tria.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * Plain facets (no offsets) on the boundary faces whose four nodes are all in the sorted list
   * @p nodes, corners counter-clockwise seen from outside, area-weighted mean normals at the nodes,
   * neighbours found. Surface nodes are numbered as first met. Throws InputError when no face is
   * taken.
   */
  FacetSurface surface_of_boundary(const dealii::Triangulation<3>  &triangulation,
                                   const std::string               &name,
                                   const std::vector<unsigned int> &nodes);

  /** The same for the boundary faces in @p faces. */
  FacetSurface surface_of_boundary(const dealii::Triangulation<3> &triangulation,
                                   const std::string              &name,
                                   const FaceSet                  &faces);

  /** The same for the active boundary faces of a boundary id. */
  FacetSurface surface_of_boundary(const dealii::Triangulation<3> &triangulation,
                                   const std::string              &name,
                                   dealii::types::boundary_id      boundary);

  /** The nodes in @p selected become the node set @p name, the boundary faces between them the
   * surface of that name. */
  void add_named_side(BodyMesh                                &mesh,
                      const std::string                       &name,
                      const std::function<bool(unsigned int)> &selected);
} // namespace vfife

#endif
