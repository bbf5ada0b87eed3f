// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_waves_study_h
#define vfife_study_waves_waves_study_h

#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  class CaseRunner;

  /** Study kind `waves`: speeds at which orders of the gear mesh meet travelling waves of the
   * driven gear, what the pair, reduced or as explicit runs, does at and around each, and which
   * speeds to avoid. Runs have folders of their own, line_1_speed_1 and so on; with --restart
   * finished ones with the same entries are kept, and others go on from their checkpoints. */
  std::unique_ptr<StudyKind> make_waves_study(const CaseRunner &runner);
} // namespace vfife

#endif
