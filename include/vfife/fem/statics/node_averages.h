// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_node_averages_h
#define vfife_fem_statics_node_averages_h

#include <vfife/fem/system/fem_space.h>

#include <array>
#include <map>

namespace vfife
{
  /** (xi, eta) in [0, 1] of the place of a facet with these corners, in cyclic order, that is
   * below or above @p x. */
  Vector2 place_on_facet(const std::array<Vector3, 4> &corners, const Vector3 &x);

  /**
   * The motion of a node of a surface in contact where elements have points between the nodes. A
   * force on one point would dent them. A contact force on a node is therefore a traction on the
   * facets around it, and the node's displacement is the mean of the surface's with the same
   * weights. The weights are the dual functions psi of the bilinear ones, phi: the integral of
   * psi_i phi_j is zero for i != j (Wohlmuth 2000, SIAM J. Numer. Anal. 38). So nodes have the
   * displacements of the surface where these are bilinear, and the traction has force and moment of
   * the nodal forces (doc/theory/fem.md, Static with contact). Elsewhere each point is its own
   * mean.
   */
  class NodeAverages
  {
  public:
    /** Of the surfaces of all contacts between bodies of the space. */
    explicit NodeAverages(const FemSpace &space);

    /** Of the node at @p point of the space: weights that sum to one. */
    PointWeights of(unsigned int point) const;

    /** Of all nodes that are not their own mean, by point. */
    const std::map<unsigned int, PointWeights> &all() const
    {
      return means_;
    }

  private:
    std::map<unsigned int, PointWeights> means_; ///< by point
  };
} // namespace vfife

#endif
