// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_file_mesh_h
#define vfife_mesh_files_file_mesh_h

#include <vfife/mesh/body_mesh.h>

#include <map>
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

  /** Reads an Abaqus or CalculiX file (read_body()). */
  FileMesh read_abaqus(const std::string &path);

  /** Adds the physical points of a Gmsh file, @p names by their numbers, as node sets. */
  void add_gmsh_points(const std::string                         &path,
                       const std::map<unsigned int, std::string> &names,
                       FileMesh                                  &mesh);
} // namespace vfife

#endif
