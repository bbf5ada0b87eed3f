// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_reduced_study_h
#define vfife_study_reduced_reduced_study_h

#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  /** Study kind `reduced`: the gear pair of an explicit run with its bodies reduced to modes and
   * residual flexibilities, with the results of a run but for fields. */
  std::unique_ptr<StudyKind> make_reduced_study();
} // namespace vfife

#endif
