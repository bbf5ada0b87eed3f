// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_tooth_form_texts_h
#define vfife_study_gear_tooth_form_texts_h

#include <vfife/output/files/figures.h>

namespace vfife
{
  class Log;
  struct ToothForms;

  /** Figures of the teeth at some sections of both members, with units: the part "teeth" of
   * tca.json. */
  Json form_json(const ToothForms &forms);

  /** A table of the same, play, backlash and the warnings. */
  void log_forms(const ToothForms &forms, Log &log);
} // namespace vfife

#endif
