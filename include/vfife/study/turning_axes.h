// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_turning_axes_h
#define vfife_study_turning_axes_h

#include <string>
#include <vector>

namespace vfife
{
  class Log;
  struct Model;

  /**
   * Studies at rest in axes that turn with the bodies: throws InputError where one of @p bodies
   * turns and a load or a spring on it stands in space otherwise than along its axis. @p remedy:
   * what to do, for a load.
   */
  void refuse_standing_loads(const Model                     &model,
                             const std::vector<unsigned int> &bodies,
                             const std::string               &remedy);

  /** The same for springs on @p body, which is looked at in spin. */
  void refuse_standing_springs(const Model &model, unsigned int body);

  /** Warns of each bearing of @p body in spin whose stiffness across the axis is not alike in all
   * directions, which axes that turn replace by its mean (doc/theory/bearing.md, In the
   * conventional solver): both stiffnesses and the mean. */
  void warn_of_averaged_bearings(const Model &model, unsigned int body, Log &log);

  /** Warns of dampers of bearings and couplings of @p body, which have no part in its natural
   * vibrations; tells whether there are any. */
  bool warn_of_dampers(const Model &model, unsigned int body, Log &log);
} // namespace vfife

#endif
