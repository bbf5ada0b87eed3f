// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_chosen_bodies_h
#define vfife_study_conventional_chosen_bodies_h

#include <vector>

namespace vfife
{
  struct FemOptions;
  struct Model;

  /** The bodies of a model that Fem/bodies names, all where it is empty. Throws InputError with the
   * nearest known name. */
  std::vector<unsigned int> find_chosen_bodies(const FemOptions &options, const Model &model);
} // namespace vfife

#endif
