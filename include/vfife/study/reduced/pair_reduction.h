// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_pair_reduction_h
#define vfife_study_reduced_pair_reduction_h

#include <vfife/reduced/reduced_body.h>

#include <functional>
#include <vector>

namespace vfife
{
  class Communicator;
  class Log;
  class OutputFolder;
  struct FemOptions;
  struct Model;
  struct ReducedOptions;

  /** Readings of a body beyond those of every run. */
  using MoreReadings = std::function<std::vector<SectorReading>(unsigned int body)>;

  /**
   * The bodies of a gear pair, of elements @p fem, with modes below @p cutoff [Hz] at least, about
   * their state of spin at the model's rates times @p faster, with all readings of a run and @p
   * more (nullptr: none); of those that are kept in ReducedOptions::store the kept ones. Throws as
   * reduce_body() and ReductionStore, and InputError for pairs on shafts. Collective.
   */
  std::vector<ReducedBody> reduce_pair(const Model          &model,
                                       const ReducedOptions &options,
                                       const FemOptions     &fem,
                                       double                cutoff,
                                       double                faster,
                                       const Communicator   &communicator,
                                       Log                  &log,
                                       const MoreReadings   &more = nullptr);

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
