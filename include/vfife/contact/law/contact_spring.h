// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_contact_spring_h
#define vfife_contact_law_contact_spring_h

#include <vfife/base/types.h>

#include <array>

namespace vfife
{
  /**
   * A contact point under pressure as a spring. With g the gap and w the weight of the edge, small
   * motions of the corners change g sqrt(w) by
   *   direction . (sum N_k dx_k of the slave's facet - sum N_k dx_k of the master's facet),
   * and the tangent of the contact forces is k direction direction^T on the weighted corners, k the
   * tangent of the contact law times the area. Left out is what turns the normal under pressure
   * (the gap over the radius of curvature) and, in the strip where w < 1, what a law that is not
   * linear adds: Newton's method with a line search gets along with it.
   */
  struct ContactSpring
  {
    bool                        swapped = false; ///< second pass: the pair's master is the slave
    std::array<unsigned int, 4> slave_nodes, master_nodes; ///< surface nodes
    std::array<double, 4>       slave_weights, master_weights;
    Vector3                     direction;     ///< on the slave, fixed frame [-]
    double                      stiffness = 0; ///< tangent of the law times area [N/mm]
  };
} // namespace vfife

#endif
