// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_chosen_bodies_h
#define vfife_study_conventional_chosen_bodies_h

#include <vector>

namespace vfife
{
  class Log;
  struct FemOptions;
  struct Model;

  /** The bodies of a model that Fem/bodies names, all where it is empty. Throws InputError with the
   * nearest known name. */
  std::vector<unsigned int> find_chosen_bodies(const FemOptions &options, const Model &model);

  /** Tells what a housing does in a study of @p bodies alone: seats of bodies that are not among
   * them are held. */
  void log_housing(const Model &model, const std::vector<unsigned int> &bodies, Log &log);
} // namespace vfife

#endif
