// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_mesh_writers_h
#define vfife_mesh_mesh_writers_h

#include <vfife/mesh/files/exported_mesh.h>

#include <iosfwd>

namespace vfife
{
  /** VTK's unstructured grid in text: hexahedra, then faces of the named surfaces; node sets and
   * surfaces as arrays of 0 and 1. */
  void
  write_vtu(std::ostream &out, const ExportedMesh &mesh, const std::vector<ExportedBody> &bodies);

  /** Gmsh's format 2.2 in text: physical groups for regions, surfaces and node sets (points). */
  void
  write_gmsh(std::ostream &out, const ExportedMesh &mesh, const std::vector<ExportedBody> &bodies);

  /** Abaqus or CalculiX: C3D8, NSET, ELSET, SURFACE, materials and sections; no step. */
  void write_abaqus(std::ostream                    &out,
                    const ExportedMesh              &mesh,
                    const std::vector<ExportedBody> &bodies);
} // namespace vfife

#endif
