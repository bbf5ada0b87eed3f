// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_bearing_supports_h
#define vfife_study_gear_bearing_supports_h

#include <vfife/lumped/lumped_model.h>

#include <vector>

namespace vfife
{
  struct Model;

  /**
   * The members of a gear pair as rigid bodies in their bearings, as supports of the lumped model
   * (doc/theory/lumped.md, Bearings): the five natural motions of each member on the linear(ized)
   * stiffnesses of its bearings, turns about its axis left out, scaled to a mass of 1 t. Dampers
   * give the damping ratio of each motion by itself. None for members with ideal bores. Throws
   * InputError where bearings leave a member free.
   */
  std::vector<LumpedSupport> find_bearing_supports(const Model &model);
} // namespace vfife

#endif
