// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_mesh_import_h
#define vfife_mesh_files_mesh_import_h

#include <vfife/mesh/body_mesh.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  /** Hexahedra and named parts as they stand in a file; indices from 0. */
  struct FileMesh
  {
    struct Group
    {
      std::string               name;
      std::vector<unsigned int> members; ///< sorted nodes or elements
    };

    std::vector<Vector3>   nodes;
    std::vector<CellNodes> elements;  ///< lexicographic
    std::vector<Group>     node_sets; ///< of nodes
    std::vector<Group>     surfaces;  ///< of the nodes of boundary faces
    std::vector<Group>     regions;   ///< of elements
  };

  /**
   * A body from a file of 8-node hexahedra, lengths in mm; the format by the end of the file's
   * name:
   *   .msh  Gmsh 2.2 or 4.1: regions, surfaces and node sets by the names of physical groups;
   *   .inp  Abaqus or CalculiX: C3D8 elements; NSET, ELSET, SURFACE (such as EB1, SS1) and 4-node
   *         shells by their ELSET;
   *   .vtk  VTK's legacy format, .ucd AVS: regions "region N", surfaces "boundary N" by their ids.
   * Names are node sets; those of surfaces are surfaces as well, and boundary ids 1, 2, ... in
   * alphabetical order. Throws InputError (one line with the file's name) when the file cannot be
   * opened or read, has other volume elements than hexahedra, or an inverted one.
   */
  std::unique_ptr<BodyMesh> read_body(const std::string &path);

  /** The part of read_body() that reads Abaqus files. */
  FileMesh read_abaqus(const std::string &path);

  /** The part that reads physical points of Gmsh files, @p names by their numbers, as node sets. */
  void add_gmsh_points(const std::string                         &path,
                       const std::map<unsigned int, std::string> &names,
                       FileMesh                                  &mesh);
} // namespace vfife

#endif
