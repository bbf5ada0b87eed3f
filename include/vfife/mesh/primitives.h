// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_primitives_h
#define vfife_mesh_primitives_h

#include <vfife/mesh/body_mesh.h>

#include <memory>

namespace vfife
{
  /**
   * The block [0, size] of counts[0] x counts[1] x counts[2] equal hexahedra, x fastest.
   * Node sets and surfaces: "x-", "x+", "y-", "y+", "z-", "z+".
   * Throws InputError for a size <= 0 or a count of 0.
   */
  std::unique_ptr<BodyMesh> make_block(const Vector3                     &size,
                                       const std::array<unsigned int, 3> &counts);

  /**
   * The ring inner <= r <= outer [mm], 0 <= z <= height; counts: radial, circumferential (at least
   * 3), axial. The cells are chords of the circle: their volume is that of the ring times sin(a)/a,
   * a = 2 pi / counts[1]. Each circumferential step is a sector. Node sets and surfaces: "inner",
   * "outer", "bottom", "top". Throws InputError for radii out of order, a height <= 0 or a count
   * too small.
   */
  std::unique_ptr<BodyMesh>
  make_ring(double inner, double outer, double height, const std::array<unsigned int, 3> &counts);

  /**
   * The full cylinder r <= radius [mm], 0 <= z <= height: a core of counts[0] x counts[0] cells
   * (counts[0] even) inside counts[1] rows that end on the circle, counts[2] layers along z. Node
   * sets and surfaces: "outer", "bottom", "top"; node set "axis". Throws InputError for a size <= 0
   * or unusable counts.
   */
  std::unique_ptr<BodyMesh>
  make_cylinder(double radius, double height, const std::array<unsigned int, 3> &counts);
} // namespace vfife

#endif
