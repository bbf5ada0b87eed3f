// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_other_sections_h
#define vfife_study_other_sections_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/parameters/parameter_file.h>

namespace vfife
{
  class CaseRunner;

  /**
   * Sections, also below those that it reads, and entries that the kind of study which has declared
   * @p prm does not read, but others of the same case do: one file serves for all of them. Those
   * that stand in @p file are read as these would read them, so that what is misspelt there is
   * found: throws InputError. What a case itself is of (Model, Gear pair) is never passed over as a
   * whole: where the kind does not take it, an InputError names the kinds that do. Studies without
   * a case pass over nothing.
   */
  OtherSections find_other_sections(const ParameterFile            &file,
                                    const dealii::ParameterHandler &prm,
                                    const CaseRunner               &runner);
} // namespace vfife

#endif
