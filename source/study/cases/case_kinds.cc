// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/cases/gear_case.h>
#include <vfife/study/cases/model_case.h>

namespace vfife
{
  std::unique_ptr<Case> make_case(const ParameterFile &file)
  {
    // A file that says nothing of either is one of a gear pair, as most kinds want it.
    if (file.contains("Model") && !file.contains("Gear pair"))
      return std::make_unique<ModelCase>();
    return make_pair_case(file);
  }

  std::unique_ptr<PairCase> make_pair_case(const ParameterFile &)
  {
    return std::make_unique<GearCase>();
  }
} // namespace vfife
