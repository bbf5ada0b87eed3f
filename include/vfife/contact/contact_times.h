// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_contact_times_h
#define vfife_contact_contact_times_h

namespace vfife
{
  /** Processor time of the parts of a contact's evaluations, added up [s]. */
  struct ContactTimes
  {
    double broad_search = 0.; ///< which groups (teeth) may touch
    double motion       = 0.; ///< how far the groups have moved since their lists were made
    double wide_search  = 0.; ///< which points may touch
    double projection   = 0.; ///< where the points lie, and their gaps
    double forces       = 0.; ///< of the points that touch
  };
} // namespace vfife

#endif
