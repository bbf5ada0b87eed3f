// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_contact_spring_h
#define vfife_contact_law_contact_spring_h

#include <vfife/base/types.h>

#include <array>

namespace vfife
{
  /**
   * A contact point under pressure as a spring of the penalty energy k h^2/2, h = g sqrt(weight of
   * the edge), g the gap. Small motions of the corners change h by
   *   dh = direction . (sum N_k dx_k of the slave's facet - sum N_k dx_k of the master's facet),
   * so that the tangent of the contact forces is k direction direction^T on the weighted corners.
   * Left out is what turns the normal under pressure (the gap over the radius of curvature).
   */
  struct ContactSpring
  {
    bool                        swapped = false; ///< second pass: the pair's master is the slave
    std::array<unsigned int, 4> slave_nodes, master_nodes; ///< surface nodes
    std::array<double, 4>       slave_weights, master_weights;
    Vector3                     direction;     ///< on the slave, fixed frame [-]
    double                      stiffness = 0; ///< penalty times area [N/mm]
  };
} // namespace vfife

#endif
