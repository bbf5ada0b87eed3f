// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/gear/spiral_bevel/gear_pair.h>
#include <vfife/study/cases/gear/gear_case_options.h>

namespace vfife
{
  GearCaseOptions::GearCaseOptions()
    : PairOptions(spiral_bevel_section)
  {
  }

  void GearCaseOptions::declare_bodies(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    PairOptions::declare_bodies(prm, file, [this](dealii::ParameterHandler &inside) {
      pair.declare(inside);
    });
  }

  void GearCaseOptions::check_bodies() const
  {
    pair.check(section);
    // Bodies are checked against blanks with everything that is derived from other entries.
    const GearPairOptions completed = pair.completed();
    PairOptions::check_bodies({{completed.pinion.blank, completed.gear.blank}},
                              [this] { return copy_teeth(GearPair(pair)); });
  }

  GearCaseOptions GearCaseOptions::for_reference() const
  {
    GearCaseOptions reference = *this;
    reference.coarsen();
    return reference;
  }

  GearCaseOptions GearCaseOptions::for_submodels(const unsigned int cells_lengthwise) const
  {
    GearCaseOptions fine = *this;
    fine.refine_for_submodels(cells_lengthwise, copy_teeth(GearPair(pair)));
    return fine;
  }

  PairTeeth copy_teeth(const GearPair &pair)
  {
    return {{pair.pinion().clone(), pair.gear().clone()}};
  }
} // namespace vfife
