// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_file_mesh_h
#define vfife_mesh_files_file_mesh_h

#include <vfife/mesh/body_mesh.h>

#include <array>
#include <map>
#include <optional>
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

    /** A face of an element, by its nodes in turn. */
    struct Face
    {
      std::array<unsigned int, 4> nodes;
      unsigned int                line; ///< of the file
    };
    struct Surface
    {
      std::string       name;
      std::vector<Face> faces;
    };
    using Surfaces = std::map<std::string, std::vector<Face>>;

    std::vector<Vector3>        nodes;
    std::vector<CellNodes>      elements;      ///< lexicographic
    std::vector<unsigned int>   element_lines; ///< of the file, for messages; 0: not known
    std::vector<Group>          node_sets;     ///< of nodes
    std::vector<Surface>        surfaces;
    std::vector<Group>          regions;        ///< of elements
    std::map<long, std::string> region_numbers; ///< names of those that the file numbers

    bool                     names_without_case = false;
    std::vector<std::string> warnings, notes; ///< on what the file has, for the log

    /**
     * Nodes in the order in which elements use them, without those that none uses (reference
     * points), and the groups made of these members, sorted: those without a name or members go.
     * Throws InputError for a face of a surface that is no face of an element.
     */
    void finish(const std::string &path, Members sets, Surfaces of_surfaces, Members of_elements);

    /**
     * Leaves the elements of the regions @p wanted, names or numbers of the file, alone: as if the
     * file had no others. Of node sets remain the nodes of these elements, of surfaces the whole
     * faces on their boundary. Throws InputError of an entry "regions" for what is no region.
     */
    void keep_regions(const std::string &path, const std::vector<std::string> &wanted);

    /** "left" (1), "right" (2), for messages. */
    std::string list_regions() const;

    /** The faces that only one element has, nodes sorted. */
    FaceSet find_boundary() const;

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

  /** Ends of the names of files that read_by_dealii() reads. */
  std::vector<std::string> dealii_formats();

  /** Reads a file by dealii::GridIn (read_body()); nothing where the end of its name is of no
   * format. Throws InputError also for formats of which deal.II reads no hexahedra, and in place of
   * all that deal.II throws. */
  std::optional<FileMesh> read_by_dealii(const std::string &path);

  /** Active cells, boundary and material ids of a triangulation, as make_body() names them; begins
   * messages with @p path. */
  FileMesh collect_file_mesh(const std::string              &path,
                             const dealii::Triangulation<3> &triangulation);
} // namespace vfife

#endif
