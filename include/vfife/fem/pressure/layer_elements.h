// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_layer_elements_h
#define vfife_fem_pressure_layer_elements_h

#include <vfife/fem/statics/node_averages.h>
#include <vfife/fem/system/element_integrals.h>

#include <array>
#include <vector>

namespace vfife
{
  using PointPairs = std::vector<std::array<unsigned int, 2>>;

  /** Elements by themselves, some of their points held. */
  struct LayerElements
  {
    std::vector<Vector3>                   points;   ///< [mm]
    std::vector<char>                      held;     ///< of the points
    std::vector<std::vector<unsigned int>> elements; ///< points, lexicographic
    std::map<unsigned int, PointWeights>   hanging;  ///< by point: the points that move it

    /**
     * Continues the elements by @p length [mm] beyond @p edges of the @p surface, two points
     * each: over the sides that turn down there, and over those that go on from these smoothly.
     * The surface goes straight on, with elements as wide as the last ones, and what is below as it
     * does; what continues held points is held. Where elements would fold, all points go on by the
     * mean step of the edge.
     */
    void continue_beyond(const PointPairs                &edges,
                         const std::vector<unsigned int> &surface,
                         double                           length);

    /** Places of the points of one of the elements [mm]. */
    ElementNodes nodes_of(const std::vector<unsigned int> &element) const;

    /** Whether one of the elements from @p first on is folded. */
    bool is_folded(std::size_t first) const;

    /** Mean displacements with the weights @p means under unit forces with the same weights, three
     * rows each [mm/N]. */
    Eigen::MatrixXd find_flexibility(const std::vector<PointWeights> &means,
                                     const Material                  &material,
                                     FemElement                       element) const;
  };
} // namespace vfife

#endif
