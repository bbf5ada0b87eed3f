// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_refined_sector_h
#define vfife_mesh_gear_refined_sector_h

#include <vfife/mesh/gear/sector/gear_sector.h>

namespace vfife
{
  /** The same sector with each cell divided into eight @p times times, all new nodes of the surface
   * on the true surfaces (gear_manifolds.h). Throws NumericalError for an inverted cell. */
  GearSector
  refine_gear_sector(const GearGeometry &gear, const GearSector &sector, unsigned int times);
} // namespace vfife

#endif
