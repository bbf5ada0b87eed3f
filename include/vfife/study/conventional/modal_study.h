// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_modal_study_h
#define vfife_study_conventional_modal_study_h

#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  /** Study kind `modal`: natural vibrations of the bodies of a gear pair or a general model, each
   * for itself, at rest and at speed. */
  std::unique_ptr<StudyKind> make_modal_study();
} // namespace vfife

#endif
