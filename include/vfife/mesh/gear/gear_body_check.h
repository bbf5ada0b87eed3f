// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_gear_body_check_h
#define vfife_mesh_gear_gear_body_check_h

#include <vfife/mesh/gear/gear_body_options.h>

#include <string>

namespace vfife
{
  /** Throws InputError (entries under @p section, e.g. "Gear pair/Gear") when sizes contradict each
   * other or @p blank. Whether the shaft goes with the true body check_gear_shaft() knows. */
  void check_gear_body(const std::string     &section,
                       const GearBodyOptions &options,
                       const BlankOutline    &blank);
} // namespace vfife

#endif
