// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_touching_point_h
#define vfife_contact_touching_point_h

#include <vfife/base/types.h>

#include <array>

namespace vfife
{
  /**
   * A point of a contact that touches, in one evaluation: how its gap depends on the nodes, and
   * what pressure has been found for it. Small motions of the corners change the gap by direction .
   * sum slave_weights_k dx_k + sum master_slopes_k . dx_k, and the pressure p puts the forces p
   * area direction slave_weights_k and p area master_slopes_k on them. Can be copied bytewise.
   */
  struct TouchingPoint
  {
    unsigned int                pair = 0; ///< of groups, among the contact's candidate pairs
    unsigned int                pass = 0, slave_facet = 0, rule_point = 0;
    std::array<unsigned int, 4> slave_nodes{}, master_nodes{}; ///< surface nodes of the pass
    double                      direction[3]{};
    double                      slave_weights[4]{};
    double                      master_slopes[4][3]{};
    double                      area      = 0; ///< times the fading's weight [mm^2]
    double                      gap       = 0; ///< [mm]
    double                      stiffness = 1; ///< penalty here over the largest of the contact [-]
    double gap_rate = 0; ///< [mm/s], from the velocities of the surfaces or of the step

    double elastic  = 0; ///< pressure of the law [MPa]
    double pressure = 0; ///< with damping [MPa]
    double energy   = 0; ///< of the law per area [mJ/mm^2]

    Eigen::Map<const Vector3> normal_slope() const
    {
      return Eigen::Map<const Vector3>(direction);
    }
    Eigen::Map<const Vector3> master_slope(const unsigned int k) const
    {
      return Eigen::Map<const Vector3>(master_slopes[k]);
    }
  };
} // namespace vfife

#endif
