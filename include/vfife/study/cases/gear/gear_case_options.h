// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_gear_gear_case_options_h
#define vfife_study_cases_gear_gear_case_options_h

#include <vfife/gear/spiral_bevel/gear_pair_options.h>
#include <vfife/study/cases/pair/pair_options.h>

namespace vfife
{
  class GearPair;

  /** The sections Gear pair, Material ... and Contact of a spiral bevel pair. */
  struct GearCaseOptions : PairOptions
  {
    GearPairOptions pair;

    GearCaseOptions();

    /** The sections Gear pair and Material ... Bound by address. */
    void declare_bodies(dealii::ParameterHandler &prm, const ParameterFile &file);

    /** Throws InputError where pair, bodies, shafts and materials contradict themselves or each
     * other. */
    void check_bodies() const;

    /** The same pair on the coarse mesh of PairCase::make_reference_model(). */
    GearCaseOptions for_reference() const;
    /** The same pair on the mesh of PairCase::make_submodel_mesh(). */
    GearCaseOptions for_submodels(unsigned int cells_lengthwise) const;
  };

  /** Both members of a pair. */
  PairTeeth copy_teeth(const GearPair &pair);
} // namespace vfife

#endif
