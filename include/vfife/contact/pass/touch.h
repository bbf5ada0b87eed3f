// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pass_touch_h
#define vfife_contact_pass_touch_h

#include <vfife/contact/touch_geometry.h>

namespace vfife
{
  /** Geometry of a touching point that its forces need beside the TouchingPoint. */
  struct Touch
  {
    unsigned int list, point; ///< numbers of the list and of its point
    Vector3      x;           ///< position on the slave's facet [mm]
    Fading       fade;
    TangentBasis basis;
  };
} // namespace vfife

#endif
