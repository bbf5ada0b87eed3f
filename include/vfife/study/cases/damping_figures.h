// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_damping_figures_h
#define vfife_study_cases_damping_figures_h

#include <vfife/output/files/figures.h>

namespace vfife
{
  class Log;
  struct DynamicsOptions;
  struct Transmission;

  /**
   * What the damping of a run is to vibrations: its coefficient [1/s] and the damping ratio
   * zeta/(4 pi f) [%] at the frequency for which it was given and, of a gear pair (nullptr: none),
   * at the first three mesh orders at the start. Empty without damping. Says the same in @p log.
   */
  NamedFigures list_damping(const DynamicsOptions &dynamics, const Transmission *pair, Log &log);
} // namespace vfife

#endif
