// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_fem_distributed_boundary_set_h
#define vfife_source_fem_distributed_boundary_set_h

#include <vfife/model/load_shares.h>

#include <array>
#include <set>
#include <vector>

namespace vfife
{
  /** All faces on the boundary of a body. */
  std::vector<BoundaryFace> find_whole_boundary(const Body &body);

  /** A set of nodes of a body with the edges and faces of the boundary that lie between them. */
  class BoundarySet
  {
  public:
    /** Edges with both ends in the set belong to it; with @p edges_of_faces only edges of faces
     * that belong to it. */
    BoundarySet(const Body                      &body,
                const std::vector<unsigned int> &nodes,
                const std::vector<BoundaryFace> &boundary,
                bool                             edges_of_faces = false);

    /** Whether a point between @p nodes (ascending: a node, two of an edge, four of a face) belongs
     * to the set. */
    bool contains(const std::vector<unsigned int> &nodes) const;

  private:
    std::vector<bool>                     nodes_;
    std::set<std::array<unsigned int, 2>> edges_;
    std::set<std::array<unsigned int, 4>> faces_;
  };
} // namespace vfife

#endif
