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
   *         shells by their ELSET; names have any case of letters. One that begins with numbers is
   *         UCD;
   *   .vtk  VTK's legacy format, .ucd AVS: regions "region N", surfaces "boundary N" by their ids;
   *   .unv  I-DEAS or Salome, .vtu of dealii::GridOut, .xda (without ids), .e Exodus: as
   * make_body() by dealii::GridIn. Names are node sets: of the node set, else of the surface, else
   * of the region that has the name. Surfaces are the faces that the file lists, with boundary ids
   * 1, 2, ... in alphabetical order. doc/reference/mesh-formats.md states what each format may
   * have, what is left out and what is refused. Throws InputError (one line with the file's name
   * and line) when the file cannot be opened or read, has other volume elements than hexahedra, or
   * hexahedra that are no mesh: inverted, twice the same, more than two at a face.
   *
   * With @p regions, names or numbers of the file, the body consists of these alone, with the node
   * sets and surfaces that they have: several bodies may be read from one file. Throws InputError
   * of an entry "regions" for one that the file has not.
   */
  std::unique_ptr<BodyMesh> read_body(const std::string              &path,
                                      const std::vector<std::string> &regions = {});

  /**
   * A body of a triangulation's active cells: material 3 is region "region 3", boundary id 2 is
   * surface "boundary 2" (id 0: none). Throws InputError, which begins with @p name, for a mesh
   * that is empty, has other cells than hexahedra, hanging nodes or inverted cells.
   */
  std::unique_ptr<BodyMesh> make_body(const std::string              &name,
                                      const dealii::Triangulation<3> &triangulation);

  /** Nodes at the places of other nodes: where blocks of a mesh meet and have not been merged. */
  struct CoincidentNodes
  {
    unsigned int n         = 0;               ///< that have another one before them
    double       tolerance = 0;               ///< a thousandth of the least edge [mm]
    Vector3      place     = Vector3::Zero(); ///< of the first [mm]

    std::string describe() const;
  };
  CoincidentNodes find_coincident_nodes(const BodyMesh &mesh);

  /** How many parts a mesh consists of that no face joins. */
  unsigned int count_parts(const BodyMesh &mesh);
} // namespace vfife

#endif
