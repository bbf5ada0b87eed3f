// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_body_reduction_h
#define vfife_reduced_body_reduction_h

#include <vfife/fem/fem_options.h>
#include <vfife/model/model.h>
#include <vfife/reduced/reduced_body.h>

#include <vector>

namespace vfife
{
  class Communicator;

  /** What a body is reduced for. */
  struct ReductionOptions
  {
    std::vector<unsigned int>  touch_nodes; ///< of sector 0, that forces act on
    std::vector<SectorReading> readings;
    FemOptions                 fem;
    double                     rate   = 0; ///< of the steady spin [rad/s]
    double                     cutoff = 0; ///< modes below are kept [rad/s]
    unsigned int reach = 4; ///< sectors on each side of a loaded one whose residual is kept
  };

  /**
   * Modes and residual flexibility of a cyclic body of @p model about its state of steady spin,
   * from one sector (doc/theory/reduced.md). Ranks share the harmonics. Throws InputError for
   * bodies that CyclicBody refuses, for nodes that there are not, and where the mesh has too few
   * unknowns for the cut-off; NumericalError where the body is not stable. Collective, equal on all
   * ranks.
   */
  ReducedBody reduce_body(const Model            &model,
                          unsigned int            body,
                          const ReductionOptions &options,
                          const Communicator     &communicator);
} // namespace vfife

#endif
