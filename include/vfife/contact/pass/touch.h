// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_touch_h
#define vfife_contact_pass_touch_h

#include <vfife/contact/touch_geometry.h>

namespace vfife
{
  /** What the forces of a touching point need beside its TouchingPoint. */
  struct Touch
  {
    unsigned int list, point; ///< of a pair of groups; in it
    Vector3      x;           ///< on the slave's facet [mm]
    Fading       fade;
    TangentBasis basis;
  };
} // namespace vfife

#endif
