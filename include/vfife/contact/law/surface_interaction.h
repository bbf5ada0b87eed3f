// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_surface_interaction_h
#define vfife_contact_law_surface_interaction_h

#include <vfife/base/types.h>
#include <vfife/contact/law/contact_law.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  /** How two surfaces act on each other in a time step: a contact law with its penalty, and what
   * takes energy away, gap-rate damping and regularized Coulomb friction. */
  struct SurfaceInteraction
  {
    const ContactLaw &law;
    double            penalty;             ///< [N/mm^3]
    double            damping        = 0.; ///< pressure per closing speed [N s/mm^3]
    double            friction       = 0.; ///< coefficient [-]
    double            regularization = 1.; ///< velocity [mm/s]
    double            mass_per_area_by_dt =
      0.; ///< largest stable traction per sliding speed [N s/mm^3]; 0: unbounded

    /** p = max(0, p_elastic - c g') [MPa] with the gap's rate g' [mm/s]: never adhesive. */
    double pressure(const double elastic, const double gap_rate) const
    {
      return std::max(0., elastic - damping * gap_rate);
    }

    /**
     * Friction traction on the slave [MPa] against the sliding velocity @p slip [mm/s] of the slave
     * over the master, -mu p s / sqrt(|s|^2 + v_r^2). The slope mu p/v_r acts as a dashpot on the
     * nodes: v_r is raised to mu p dt/(m/A) where the step could not carry it.
     */
    Vector3 friction_traction(const double pressure, const Vector3 &slip) const
    {
      const double strength = friction * pressure;
      double       v_r      = regularization;
      if (mass_per_area_by_dt > 0.)
        v_r = std::max(v_r, strength / mass_per_area_by_dt);
      return (-strength / std::sqrt(slip.squaredNorm() + v_r * v_r)) * slip;
    }
  };
} // namespace vfife

#endif
