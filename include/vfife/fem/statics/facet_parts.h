// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_facet_parts_h
#define vfife_fem_statics_facet_parts_h

#include <vfife/fem/statics/node_averages.h>

#include <array>
#include <map>
#include <vector>

namespace vfife
{
  /**
   * The quadrilaterals into which the points of quadratic, cubic and divided elements part the
   * facets of surfaces in contact. Displacements on a part are bilinear between its corners, and
   * forces on it act there: finer than between the nodes (NodeAverages). Displacement and traction
   * of a corner are means and functions as those of a node, with the dual functions on the parts.
   */
  class FacetParts
  {
  public:
    using Corners = std::array<unsigned int, 4>; ///< points of the space in cyclic order

    /** Of the surfaces of all contacts between bodies of the space. */
    explicit FacetParts(const FemSpace &space);

    /** Of the facet with these corners, in cyclic order as they come: the facet itself on bodies
     * whose elements have no points between the nodes. */
    std::vector<Corners> of(const Corners &facet) const;

    /** The mean that is the displacement of a corner: weights that sum to one. */
    PointWeights mean_of(unsigned int point) const;

    /** Corners of the parts, ascending, of facets whose own corners are among @p nodes (points of
     * the space); none of bodies whose elements have no points between the nodes. */
    std::vector<unsigned int> points_within(const std::vector<unsigned int> &nodes) const;

  private:
    std::map<Corners, std::vector<Corners>> parts_; ///< by the ascending corners of the facets
    std::map<unsigned int, PointWeights>    means_;
  };
} // namespace vfife

#endif
