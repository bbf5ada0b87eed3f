// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_hexahedron_corners_h
#define vfife_mesh_hexahedron_corners_h

/** Corners of a right-handed hexahedron as their places in CellNodes, deal.II's lexicographic
 * order. */
namespace vfife
{
  /** The k-th corner in the order of VTK, Gmsh and Abaqus: round the bottom, then round the top. */
  constexpr unsigned int corner_of_files[8] = {0, 1, 3, 2, 4, 5, 7, 6};

  /** Of the faces, by deal.II's numbers of faces; counter-clockwise seen from outside. */
  constexpr unsigned int outward_faces[6][4] = {
    {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
} // namespace vfife

#endif
