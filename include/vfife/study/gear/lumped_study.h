// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_lumped_study_h
#define vfife_study_gear_lumped_study_h

#include <vfife/base/text/json.h>

namespace vfife
{
  class LumpedModel;
  class Table;
  struct LumpedResponse;

  /** lumped.json: model, modes, the response at @p speed [rad/s]; that over speed where
   * @p resonance (resonance.csv) has rows. */
  Json make_lumped_json(const LumpedModel    &model,
                        const LumpedResponse &response,
                        double                speed,
                        const Table          &resonance);
} // namespace vfife

#endif
