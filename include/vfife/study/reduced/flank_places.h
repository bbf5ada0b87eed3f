// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_flank_places_h
#define vfife_study_reduced_flank_places_h

#include <vfife/study/pressure/pressure_writer.h>

namespace vfife
{
  class ReducedPair;

  /** The flanks of the teeth in contact from where a reduced pair has them. What is given must
   * outlive it. */
  FlankReader read_flanks(const Model &model, const ReducedPair &pair);
} // namespace vfife

#endif
