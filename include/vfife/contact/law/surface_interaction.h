// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_surface_interaction_h
#define vfife_contact_law_surface_interaction_h

#include <vfife/contact/law/contact_law.h>
#include <vfife/contact/law/friction_law.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  /** How two surfaces act on each other in a time step: a contact law with its penalty, and what
   * takes energy away, gap-rate damping and friction with elastic stick. */
  struct SurfaceInteraction
  {
    const ContactLaw  &law;
    double             penalty;                      ///< [N/mm^3]
    double             damping            = 0.;      ///< pressure per closing speed [N s/mm^3]
    const FrictionLaw *friction           = nullptr; ///< none: no friction
    double             tangential_penalty = 0.;      ///< of points that stick [N/mm^3]
    double             tangential_limit =
      std::numeric_limits<double>::infinity(); ///< that the step bears [N/mm^3]

    /** p = max(0, p_elastic - c g') [MPa] with the gap's rate g' [mm/s]: never adhesive. Where the
     * penalty is only a part @p stiffness of the largest one, the damping goes with its root. */
    double pressure(const double elastic, const double gap_rate, const double stiffness = 1.) const
    {
      return std::max(0., elastic - damping * std::sqrt(stiffness) * gap_rate);
    }
  };
} // namespace vfife

#endif
