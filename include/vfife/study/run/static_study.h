// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_static_study_h
#define vfife_study_run_static_study_h

#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  /**
   * Study kind `static`: equilibrium of a general model by dynamic relaxation, load step by load
   * step. Bodies with a speed are in equilibrium with their centrifugal force. A row of the
   * histories a load step; its time is the part of the loads.
   */
  std::unique_ptr<StudyKind> make_static_study();
} // namespace vfife

#endif
