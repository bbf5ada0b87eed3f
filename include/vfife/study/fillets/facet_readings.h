// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_fillets_facet_readings_h
#define vfife_study_fillets_facet_readings_h

#include <vfife/fem/submodel/sector_submodel.h>

#include <array>
#include <vector>

namespace vfife
{
  /** SurfaceTensor of strain, three readings each, at the Gauss points of the faces that make up a
   * fillet's facet of tooth 0. */
  std::vector<PointReading> read_facet(const FemSpace                    &sector,
                                       const std::array<unsigned int, 4> &facet);

  /** The traction along the outward normal that finite elements leave on a fillet's facet of tooth
   * 0, mean of the points of read_facet() [MPa]. The surface is free of it. The sector has
   * quadratic elements that are not divided. */
  PointReading read_traction(const FemSpace &sector, const std::array<unsigned int, 4> &facet);
} // namespace vfife

#endif
