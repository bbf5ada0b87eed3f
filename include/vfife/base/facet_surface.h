// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_facet_surface_h
#define vfife_base_facet_surface_h

#include <vfife/base/types.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * A named surface of a body as plain arrays: bilinear facets on the nodes of the mesh and, where
   * the mesh approximates a known surface (a generated tooth flank), the *true* surface as offsets
   * from the facets.
   *
   * Facet: four corners X_k, counter-clockwise seen from outside the body, with bilinear weights
   * N_k(xi, eta) on [0,1]^2 in the order (0,0), (1,0), (1,1), (0,1). True unit outward normals n_k
   * at the nodes give the continuous normal field n(xi,eta) = normalized sum N_k n_k. The true
   * surface is y(xi, eta) = sum N_k X_k + delta(xi, eta) n(xi, eta), delta being tabulated at the
   * tensor Gauss-Lobatto points (offset_points per direction on [0,1], xi fastest). The offset is
   * zero at the corners when nodes lie on the true surface. All in the undeformed body frame.
   */
  struct FacetSurface
  {
    std::string name;

    /** Node of the body mesh for each surface node; everything below numbers surface nodes 0..n. */
    std::vector<unsigned int> nodes;
    std::vector<Vector3>      positions; ///< undeformed, body frame [mm]
    std::vector<Vector3>      normals;   ///< true unit outward normals

    std::vector<std::array<unsigned int, 4>> facets; ///< corners as surface nodes
    std::vector<unsigned int> group; ///< tooth number of each facet (0 for bodies without teeth)
    unsigned int              n_groups = 1;

    /** Neighbour facet across side 0: eta=0, 1: xi=1, 2: eta=1, 3: xi=0; no_facet at the border. */
    std::vector<std::array<unsigned int, 4>> neighbours;

    unsigned int offset_points = 0; ///< points per direction; 0: plain facets
    std::vector<unsigned int>
                        offset_row; ///< per facet: row of the table (rotated copies share a row)
    std::vector<double> offsets;    ///< rows of offset_points^2 values [mm]

    /** Per facet and side the number, from 1 on, of the body's edge that the border lies on there
     * (a flank's tip, toe, heel); 0: none, as inside or where a flank runs on into the fillet.
     * Without rows the whole border is one edge. */
    std::vector<std::array<unsigned char, 4>> edges;

    static constexpr unsigned int no_facet = static_cast<unsigned int>(-1);
  };

  /** The surface nodes of a group's facets, ascending. */
  std::vector<unsigned int> list_group_nodes(const FacetSurface &surface, unsigned int group);

  /** Fills FacetSurface::neighbours from the facets' shared edges. */
  void find_neighbours(FacetSurface &surface);

  /** Of a facet, 0 where the surface has no groups. */
  unsigned int group_of(const FacetSurface &surface, std::size_t facet);

  /** The number of the body's edge on which a side of a facet lies, FacetSurface::edges; where
   * edges are not numbered the whole border of a group is its edge 1. 0: none. The surface's
   * neighbours must be known. */
  unsigned int edge_number(const FacetSurface &surface, std::size_t facet, unsigned int side);
} // namespace vfife

#endif
