// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_distributed_distributed_checks_h
#define vfife_fem_distributed_distributed_checks_h

#include <vfife/fem/fem_options.h>

#include <vector>

namespace vfife
{
  /** Throws InputError, naming the entry, where options ask for what a distributed mesh does not
   * have; nothing without Fem/distributed. */
  void check_distributed(const FemOptions &options);

  /** The same for a model and the @p bodies of the study. @p spins: whether centrifugal force acts
   * on bodies that turn. */
  void check_distributed(const FemOptions                &options,
                         const Model                     &model,
                         const std::vector<unsigned int> &bodies,
                         bool                             spins);
} // namespace vfife

#endif
