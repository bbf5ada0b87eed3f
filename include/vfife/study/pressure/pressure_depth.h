// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_pressure_pressure_depth_h
#define vfife_study_pressure_pressure_depth_h

namespace vfife
{
  class HertzContact;
  struct Model;

  /** Least depth of the layers under the flanks of a pair: @p given, or, where that is 0, one and a
   * half widths of Hertz's contact under the whole load at time zero [mm]. */
  double choose_pressure_depth(double given, const Model &model, const HertzContact &hertz);
} // namespace vfife

#endif
