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
    /** Members of groups while they are read, by name. */
    using Members = std::map<std::string, std::vector<unsigned int>>;

    std::vector<Vector3>        nodes;
    std::vector<CellNodes>      elements;       ///< lexicographic
    std::vector<unsigned int>   element_lines;  ///< of the file, for messages
    std::vector<Group>          node_sets;      ///< of nodes
    std::vector<Group>          surfaces;       ///< of the nodes of boundary faces
    std::vector<Group>          regions;        ///< of elements
    std::map<long, std::string> region_numbers; ///< names of those that the file numbers

    /** Nodes in the order in which elements use them, without those that none uses (of shells,
     * reference points), and the groups made of these members, sorted: those without a name or
     * members go. */
    void finish(Members sets, Members of_surfaces, Members of_elements);

    /**
     * Leaves the elements of the regions @p wanted, names or numbers of the file, alone: as if the
     * file had no others. Of node sets remain the nodes of these elements, of surfaces the whole
     * faces on their boundary. Throws InputError of an entry "regions" for what is no region.
     */
    void keep_regions(const std::string &path, const std::vector<std::string> &wanted);

    /** "left" (1), "right" (2), for messages. */
    std::string list_regions() const;

  private:
    const Group &find_region(const std::string &path, const std::string &wanted) const;
  };

  /** Turns all hexahedra inside out if all have a negative volume: some programs number from the
   * other side. */
  void turn_inside_out(FileMesh &mesh);

  /**
   * Throws InputError unless the hexahedra can be a mesh: nodes are different, volumes positive and
   * finite, and faces belong to one or two elements, which see the same edges in them. Begins with
   * @p path and the line of the element.
   */
  void check_elements(const std::string &path, const FileMesh &mesh);

  /** Reads an Abaqus or CalculiX file (read_body()). */
  FileMesh read_abaqus(const std::string &path);

  /** Reads a Gmsh file of format 2.2 or 4.1 (read_body()). */
  FileMesh read_gmsh(const std::string &path);

  /** Reads an unstructured grid of VTK's legacy format in text (read_body()). */
  FileMesh read_vtk(const std::string &path);

  /** Reads AVS' unstructured cell data (read_body()). */
  FileMesh read_ucd(const std::string &path);
} // namespace vfife

#endif
