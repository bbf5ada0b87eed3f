// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_contact_results_h
#define vfife_contact_contact_results_h

#include <vfife/base/facet_surface.h>
#include <vfife/base/types.h>

#include <limits>

namespace vfife
{
  /** What one pair of groups (teeth) does to each other in one evaluation. */
  struct GroupPairResult
  {
    unsigned int slave_group = 0, master_group = 0;

    Vector3 force  = Vector3::Zero(); ///< on the slave, fixed frame [N]
    Vector3 moment = Vector3::Zero(); ///< on the slave, about the fixed frame's origin [N mm]

    double largest_pressure    = 0.; ///< of a point [MPa]
    double area                = 0.; ///< carrying, weighted by edge fading [mm^2]
    double normal_force        = 0.; ///< integral of p dA [N]
    double largest_penetration = 0.; ///< [mm], positive
    double energy              = 0.; ///< of the penalty, and of points that stick [mJ]
    double damping_power       = 0.; ///< dissipated by the gap-rate damping [mJ/s]
    double friction_loss       = 0.; ///< dissipated by friction since the evaluation before [mJ]
  };

  /** One contact point, for output. */
  struct ContactPoint
  {
    bool         swapped      = false; ///< of the second pass: slave and master change their roles
    Vector3      position     = Vector3::Zero(); ///< on the slave's facet, fixed frame [mm]
    unsigned int slave_facet  = FacetSurface::no_facet;
    unsigned int master_facet = FacetSurface::no_facet;
    double       xi = 0., eta = 0.;                                  ///< in the master's facet
    double       gap      = std::numeric_limits<double>::infinity(); ///< [mm]
    double       pressure = 0.;                                      ///< [MPa]
  };
} // namespace vfife

#endif
