// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_half_space_cell_flexibility_h
#define vfife_contact_half_space_cell_flexibility_h

#include <vfife/contact/half_space/bonded_layer.h>

#include <array>
#include <vector>

namespace vfife
{
  /** What lies under one of two surfaces in contact: a half-space or a layer whose other side is
   * held. */
  struct ElasticLayer
  {
    double              youngs_modulus = 0.; ///< [MPa]
    double              poissons_ratio = 0.; ///< [-]
    std::vector<double> depths;              ///< of the layer, by cell [mm]; empty: a half-space
    /** That of a layer with this Poisson's ratio, for who asks more than once: its table takes as
     * long as thousands of cells; nullptr: it is made. */
    const BondedLayer *held = nullptr;
  };

  /**
   * How much nearer both surfaces' material comes to each other in the middles of cells (rows) by
   * unit forces spread evenly over cells (columns) [mm/N], without friction. The cells are equal
   * rectangles of the @p sides [mm] at whole numbers @p places of them in a plane. Under two cells
   * the layer has the mean of their depths. Symmetric. Throws InputError where depths do not fit.
   */
  Eigen::MatrixXd compute_cell_flexibility(const std::vector<std::array<int, 2>> &places,
                                           const Vector2                         &sides,
                                           const std::array<ElasticLayer, 2>     &bodies);
} // namespace vfife

#endif
