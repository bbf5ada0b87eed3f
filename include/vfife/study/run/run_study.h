// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_run_study_h
#define vfife_study_run_run_study_h

#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  /** Study kind `run`: explicit dynamics of a gear pair or a general model from the start to the
   * end, with all results. */
  std::unique_ptr<StudyKind> make_run_study();
} // namespace vfife

#endif
