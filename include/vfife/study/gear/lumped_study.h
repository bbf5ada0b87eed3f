// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_lumped_study_h
#define vfife_study_gear_lumped_study_h

#include <vfife/base/text/json.h>
#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  class LumpedModel;
  class Table;
  struct LumpedResponse;

  /**
   * Study kind `lumped`: a gear pair of few degrees of freedom (doc/theory/lumped.md), by values or
   * with inertias and geometry of a section Gear pair; writes lumped.csv, resonance.csv,
   * lumped.json.
   */
  std::unique_ptr<StudyKind> make_lumped_study();

  /** lumped.json: model, modes, the response at @p speed [rad/s]; that over speed where
   * @p resonance (resonance.csv) has rows. */
  Json make_lumped_json(const LumpedModel    &model,
                        const LumpedResponse &response,
                        double                speed,
                        const Table          &resonance);
} // namespace vfife

#endif
