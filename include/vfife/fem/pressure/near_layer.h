// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_near_layer_h
#define vfife_fem_pressure_near_layer_h

#include <vfife/fem/pressure/layer_elements.h>
#include <vfife/fem/system/fem_space.h>

#include <vector>

namespace vfife
{
  /**
   * What lies near a patch of a body's surface, as the body's finite elements have it: the layers
   * of elements under the patch, held where they join what lies deeper; beyond edges of the body
   * they go on, as the layer in closed form does (doc/theory/pressure-grid.md).
   */
  struct NearLayer
  {
    std::vector<unsigned int> points; ///< of the patch
    std::vector<double>       depths; ///< from each of them to the nearest point that is held [mm]
    /** Three rows per point, axes of time zero [mm/N]; points move as their means say. */
    Eigen::MatrixXd flexibility;
    unsigned int    n_layers = 0; ///< of elements

    double mean_depth() const;
  };

  /**
   * As many layers of elements as make the mean depth @p depth [mm], or as there are without those
   * at the points @p others (the other side of a tooth); at least one. Divided elements count as
   * the one of the body that they are parts of. @p means: by which the points of the @p patch
   * move and take forces. @p edges: sides of the elements' faces on the patch that lie on edges of
   * the body, by their points.
   * Throws InputError where elements under the patch are at those, or the layers are not held.
   */
  NearLayer find_near_layer(const FemSpace                  &space,
                            std::vector<unsigned int>        patch,
                            std::vector<PointWeights>        means,
                            const std::vector<unsigned int> &others,
                            double                           depth,
                            const PointPairs                &edges = {});
} // namespace vfife

#endif
