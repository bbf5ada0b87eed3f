// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_fillet_readings_h
#define vfife_study_reduced_fillet_readings_h

#include <vfife/output/observers/fillet_writers.h>
#include <vfife/reduced/reduced_body.h>

namespace vfife
{
  class ReducedPair;
  class RootSubmodels;
  class SectorSubmodel;

  /** Strains of the facets of both fillets, three components each, and of gauges: readings of a
   * sector of @p body. Linear in small displacements, so their weights are what unit displacements
   * of the nodes give. */
  std::vector<SectorReading>
  list_fillet_readings(const Model &model, const RootStress &stress, unsigned int body);

  /** What those readings are of a pair whose bodies have them; @p pair must outlive the function.
   */
  FilletMeasure measure_fillet_readings(const ReducedPair &pair);

  /** The same by submodels: SectorSubmodel::follow() of tooth 0. */
  std::vector<SectorReading> list_submodel_readings(const std::vector<SectorSubmodel> &submodels);

  /** Of a pair whose bodies have those. All that is given must outlive the function. */
  FilletMeasure measure_submodel_readings(const Model         &model,
                                          const RootSubmodels &submodels,
                                          const ReducedPair   &pair);
} // namespace vfife

#endif
