// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_tooth_contact_study_h
#define vfife_study_gear_tooth_contact_study_h

#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  /**
   * Study kind `tooth contact analysis`: unloaded contact of both sides of a gear pair; writes
   * tca.csv, path.csv and tca.json.
   */
  std::unique_ptr<StudyKind> make_tooth_contact_study();
} // namespace vfife

#endif
