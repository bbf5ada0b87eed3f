// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_mesh_import_h
#define vfife_mesh_files_mesh_import_h

#include <vfife/mesh/body_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * A body from a file of 8-node hexahedra, lengths in mm; the format by the end of the file's
   * name:
   *   .msh  Gmsh 2.2 or 4.1: regions, surfaces and node sets by the names of physical groups;
   *   .inp  Abaqus or CalculiX: C3D8 elements; NSET, ELSET, SURFACE (such as EB1, SS1) and 4-node
   *         shells by their ELSET;
   *   .vtk  VTK's legacy format, .ucd AVS: regions "region N", surfaces "boundary N" by their ids.
   * Names are node sets; those of surfaces are surfaces as well, and boundary ids 1, 2, ... in
   * alphabetical order. Throws InputError (one line with the file's name and line) when the file
   * cannot be opened or read, has other volume elements than hexahedra, or hexahedra that are no
   * mesh: inverted, twice the same, more than two at a face.
   *
   * With @p regions, names or numbers of the file, the body consists of these alone, with the node
   * sets and surfaces that they have: several bodies may be read from one file. Throws InputError
   * of an entry "regions" for one that the file has not.
   */
  std::unique_ptr<BodyMesh> read_body(const std::string              &path,
                                      const std::vector<std::string> &regions = {});

  /** How many parts a mesh consists of that no face joins. */
  unsigned int count_parts(const BodyMesh &mesh);
} // namespace vfife

#endif
