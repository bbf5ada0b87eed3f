// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_gear_shaft_check_h
#define vfife_mesh_gear_gear_shaft_check_h

#include <vfife/gear/gear_geometry.h>
#include <vfife/mesh/gear/gear_body_options.h>

#include <string>

namespace vfife
{
  /**
   * Whether the shaft goes with the body: one section through the hub, as thick as the bore, and
   * all others apart from hub, web, rim and teeth. Throws InputError of the entry "sections" under
   * @p section (e.g. "Gear pair/Pinion/Shaft"). Nothing to check without a shaft.
   */
  void check_gear_shaft(const std::string     &section,
                        const GearGeometry    &gear,
                        const GearBodyOptions &options);
} // namespace vfife

#endif
