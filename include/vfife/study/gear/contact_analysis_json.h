// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_contact_analysis_json_h
#define vfife_study_gear_contact_analysis_json_h

#include <vfife/base/text/json.h>

namespace vfife
{
  class GearPair;
  struct ContactAnalysis;
  struct ContactAnalysisOptions;

  /** Who drives, how the members turn about + their axes, and what that makes of the contact. */
  Json working_json(const GearPair &pair, const ContactAnalysisOptions &options);

  /** All that tca.json says of one side of the pair. Places on the path are in pitches, angles of
   * the gear in arcsec; @p gear_pitch [rad]. */
  Json side_json(const ContactAnalysis &a, double gear_pitch);
} // namespace vfife

#endif
