// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_case_kinds_h
#define vfife_study_cases_case_kinds_h

#include <memory>

namespace vfife
{
  class Case;
  class PairCase;
  class ParameterFile;

  /** Whether a file has the section of a gear pair (base/case_sections.h). */
  bool describes_pair(const ParameterFile &file);

  /** The kind of case that the sections of a file stand for: with a section Model and none of a
   * gear pair a general model, otherwise a gear pair. */
  std::unique_ptr<Case> make_case(const ParameterFile &file);

  /** The gear pair of a file, by the kind of its gears. */
  std::unique_ptr<PairCase> make_pair_case(const ParameterFile &file);
} // namespace vfife

#endif
