// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_primitives_primitives_h
#define vfife_mesh_primitives_primitives_h

#include <vfife/mesh/body_mesh.h>

#include <functional>
#include <memory>
#include <string>

namespace vfife
{
  /**
   * The block [origin, origin + size] [mm] of counts[0] x counts[1] x counts[2] equal hexahedra, x
   * fastest.
   * Node sets and surfaces: "x-", "x+", "y-", "y+", "z-", "z+".
   * Throws InputError for a size <= 0 or a count of 0.
   */
  std::unique_ptr<BodyMesh> make_block(const Vector3                     &size,
                                       const std::array<unsigned int, 3> &counts,
                                       const Vector3                     &origin = Vector3::Zero());

  /** A block along x, 0 <= x <= size[0], its section centred on the x axis; sides as of a block. */
  std::unique_ptr<BodyMesh> make_beam(const Vector3                     &size,
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
   * The full cylinder r <= radius [mm], bottom <= z <= bottom + height: a core of counts[0] x
   * counts[0] cells (counts[0] even) inside counts[1] rows that end on the circle, counts[2] layers
   * along z. Node sets and surfaces: "outer", "bottom", "top"; node set "axis". Throws InputError
   * for a size <= 0 or unusable counts.
   */
  std::unique_ptr<BodyMesh> make_cylinder(double                             radius,
                                          double                             height,
                                          const std::array<unsigned int, 3> &counts,
                                          double                             bottom = 0.);

  /** A cylinder centred on z = 0, its height being the thickness [mm]; sides as of a cylinder. */
  std::unique_ptr<BodyMesh>
  make_disc(double radius, double thickness, const std::array<unsigned int, 3> &counts);

  /**
   * The full sphere about the origin, radius in mm: a core of counts[0]^3 cells (counts[0] even)
   * inside counts[1] shells that end on the sphere. Node set and surface "outer"; node set
   * "centre". Throws InputError for a radius <= 0 or unusable counts.
   */
  std::unique_ptr<BodyMesh> make_sphere(double radius, const std::array<unsigned int, 2> &counts);

  /**
   * The hexahedra of @p mesh between other nodes: @p place is given the old place of each [mm], in
   * their order. One sector, no named sets and surfaces. Throws InputError where an element is
   * turned inside out.
   */
  std::unique_ptr<BodyMesh> make_moved(const BodyMesh                                &mesh,
                                       const std::string                             &name,
                                       const std::function<Vector3(const Vector3 &)> &place);
} // namespace vfife

#endif
