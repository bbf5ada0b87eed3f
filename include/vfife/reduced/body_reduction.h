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

  struct ReductionOptions
  {
    double       cutoff = 0; ///< modes below are kept [rad/s]
    unsigned int reach  = 4; ///< sectors on each side of a loaded one whose residual is kept
  };

  /**
   * Modes and residual flexibility of a cyclic body of @p model about its state of steady spin at
   * @p rate [rad/s], from one sector (doc/theory/reduced.md). @p touch_nodes: of sector 0, that
   * forces act on. Ranks share the harmonics. Throws InputError for bodies that CyclicBody refuses,
   * for nodes that there are not, and where the mesh has too few unknowns for the cut-off;
   * NumericalError where the body is not stable. Collective, equal on all ranks.
   */
  ReducedBody reduce_body(const Model                     &model,
                          unsigned int                     body,
                          const std::vector<unsigned int> &touch_nodes,
                          std::vector<SectorReading>       readings,
                          const FemOptions                &fem,
                          const ReductionOptions          &options,
                          double                           rate,
                          const Communicator              &communicator);
} // namespace vfife

#endif
