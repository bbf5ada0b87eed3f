// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_exported_mesh_h
#define vfife_mesh_files_exported_mesh_h

#include <vfife/mesh/body_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  /** A body to be exported: its mesh where it stands, and its material. */
  struct ExportedBody
  {
    std::string     name;
    const BodyMesh *mesh = nullptr;
    RigidMotion     placement; ///< body frame to the file's frame [mm]
    std::string     material;
    double          density        = 0; ///< [t/mm^3]
    double          youngs_modulus = 0; ///< [MPa]
    double          poissons_ratio = 0;
  };

  /** Bodies as one list of nodes and elements with named parts: what every format is written from.
   */
  struct ExportedMesh
  {
    /** A face of an element by deal.II's number of it. */
    struct Face
    {
      unsigned int element, face;
    };
    struct NodeSet
    {
      std::string               name; ///< "gear bore"
      std::vector<unsigned int> nodes;
    };
    struct Surface
    {
      std::string       name; ///< "gear concave"
      std::vector<Face> faces;
    };
    struct Region
    {
      std::string               name; ///< "gear teeth"
      unsigned int              body = 0;
      std::vector<unsigned int> elements;
    };

    std::vector<Vector3>      nodes;    ///< [mm]
    std::vector<CellNodes>    elements; ///< lexicographic
    std::vector<unsigned int> sector;   ///< tooth number of each element
    std::vector<unsigned int> body;     ///< place of each element's body in the list
    std::vector<NodeSet>      node_sets;
    std::vector<Surface>      surfaces;
    std::vector<Region>       regions; ///< each element is in exactly one

    /** Nodes of a face, counter-clockwise seen from outside. */
    std::array<unsigned int, 4> face_nodes(const Face &face) const;
  };

  /** Throws InputError for a locally refined mesh (hanging nodes). */
  ExportedMesh collect(const std::vector<ExportedBody> &bodies);

  /** A set's name as Abaqus wants it: "gear x-" becomes "GEAR_X_MINUS". */
  std::string abaqus_name(const std::string &name);
} // namespace vfife

#endif
