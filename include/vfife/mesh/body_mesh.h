// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_body_mesh_h
#define vfife_mesh_body_mesh_h

#include <vfife/base/facet_surface.h>
#include <vfife/mesh/body_structure.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * The hexahedral mesh of one body in its body frame [mm]: a deal.II triangulation (node = vertex
   * index, all vertices used, element = active cell index, local node order deal.II's lexicographic
   * one) with named node sets and named surfaces. For a gear: axis z, apex at the origin; cells are
   * ordered sector by sector (tooth by tooth).
   */
  struct BodyMesh
  {
    std::string              name;
    dealii::Triangulation<3> triangulation;
    BodyStructure            structure;

    std::map<unsigned int, std::string> regions;    ///< names of the cells' material ids
    std::map<unsigned int, std::string> boundaries; ///< names of the faces' boundary ids

    /** Sorted node lists, e.g. "bore", "web front" (towards the apex), "web back", "node A front".
     */
    std::map<std::string, std::vector<unsigned int>> node_sets;
    /** e.g. "concave", "convex" (flanks with true normals and offsets, one group a tooth). */
    std::map<std::string, FacetSurface> surfaces;

    // Of a body that was read from a file:
    /** Names that the file gives to surfaces on which nothing can act, and why. */
    std::map<std::string, std::string> unusable_surfaces;
    bool                               names_without_case = false; ///< "Top" and "TOP" are one name
    std::vector<std::string>           warnings, notes;            ///< on the file, for the log

    /** The node set or surface that @p name means, as it is spelt here; @p name where there is
     * none. */
    std::string find_spelling(const std::string &name) const;
  };

  /** Faces of a mesh, each by its four nodes in ascending order. */
  using FaceSet = std::set<std::array<unsigned int, 4>>;

  /** The facets of a surface by nodes of the mesh. */
  FaceSet faces_of(const FacetSurface &surface);

  /** Eight nodes of a hexahedron in deal.II's lexicographic order. */
  using CellNodes = std::array<unsigned int, 8>;

  /**
   * Creates the triangulation of @p mesh from nodes [mm] and right-handed hexahedra, keeping the
   * numbers of both: node i is vertex i, hexahedron e the active cell e; @p regions are the cells'
   * material ids, all 0 where empty; @p n_sectors: BodyStructure. Throws NumericalError where
   * deal.II had to renumber, InputError for a node that no hexahedron uses.
   */
  void create_triangulation(BodyMesh                        &mesh,
                            const std::vector<Vector3>      &nodes,
                            const std::vector<CellNodes>    &hexahedra,
                            const std::vector<unsigned int> &regions   = {},
                            unsigned int                     n_sectors = 1);

  constexpr unsigned int most_boundaries = 32;

  /** Gives the faces of @p mesh.surfaces the boundary ids 1, 2, ... in the order of @p names; a
   * face of several surfaces has the first one's. */
  void name_surface_faces(BodyMesh &mesh, const std::vector<std::string> &names);

  /**
   * Gives boundary faces the boundary ids 1, 2, ... in the order of @p names: a face belongs to the
   * first of these node sets that contains its four nodes, and has id 0 where there is none. Names
   * without a node set take a number all the same, so that an id means the same in all bodies of a
   * kind. At most most_boundaries names.
   */
  void name_boundaries(BodyMesh &mesh, const std::vector<std::string> &names);
} // namespace vfife

#endif
