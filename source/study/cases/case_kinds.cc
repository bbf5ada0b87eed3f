// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/cases/gear/gear_case.h>
#include <vfife/study/cases/model_case.h>

namespace vfife
{
  bool describes_pair(const ParameterFile &file)
  {
    return has_pair_section([&file](const std::string &section) { return file.contains(section); });
  }

  std::unique_ptr<Case> make_case(const ParameterFile &file)
  {
    if (describes_model([&file](const std::string &section) { return file.contains(section); }))
      return std::make_unique<ModelCase>();
    return make_pair_case(file);
  }

  std::unique_ptr<PairCase> make_pair_case(const ParameterFile &)
  {
    return std::make_unique<GearCase>();
  }
} // namespace vfife
