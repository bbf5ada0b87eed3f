// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_waves_study_h
#define vfife_study_waves_waves_study_h

#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  /** Study kind `waves`: speeds at which orders of the tooth mesh meet travelling waves of the
   * driven gear, what the reduced pair does at and around each, and which speeds to avoid. */
  std::unique_ptr<StudyKind> make_waves_study();
} // namespace vfife

#endif
