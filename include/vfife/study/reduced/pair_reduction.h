// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_pair_reduction_h
#define vfife_study_reduced_pair_reduction_h

#include <vfife/fem/fem_options.h>
#include <vfife/reduced/reduced_body.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  class Communicator;
  class Log;
  class OutputFolder;
  struct Model;

  /** Readings of a body beyond those of every run. */
  using MoreReadings = std::function<std::vector<SectorReading>(unsigned int body)>;

  /** What the bodies of a pair are reduced for. */
  struct PairReductionOptions
  {
    std::string  store; ///< folder that keeps reduced bodies, or nothing
    unsigned int reach = 4;
    FemOptions   fem;
    double       cutoff = 0; ///< modes below are kept [Hz]
    double       faster = 1; ///< rates of spin over those of the model
    MoreReadings more;       ///< or nullptr
  };

  /**
   * The bodies of a gear pair about their state of spin, with all readings of a run and more; those
   * that the store keeps, with modes below the cut-off at least, are read from it. Throws as
   * reduce_body() and ReductionStore, and InputError for pairs on shafts. Collective.
   */
  std::vector<ReducedBody> reduce_pair(const Model                &model,
                                       const PairReductionOptions &options,
                                       const Communicator         &communicator,
                                       Log                        &log);

  /** That of the modes that the bodies have, which may be above the one asked for where they were
   * kept [Hz]. */
  double find_kept_cutoff(const std::vector<ReducedBody> &bodies);

  /** Writes the matrices of each body and what their rows and columns are, as RealBody has them:
   * BODY_mass.mtx, ..., BODY_coordinates.csv, BODY_rows.csv. */
  void export_bodies(const std::vector<ReducedBody> &bodies,
                     const Model                    &model,
                     const OutputFolder             &folder);
} // namespace vfife

#endif
