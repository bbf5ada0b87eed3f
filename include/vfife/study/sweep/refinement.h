// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_sweep_refinement_h
#define vfife_study_sweep_refinement_h

#include <string>
#include <vector>

namespace vfife
{
  /** log(a/b) of two values of one entry; NaN unless they are positive numbers, both with a unit of
   * one dimension or both without one. */
  double compute_log_ratio(const std::string &a, const std::string &b);

  /**
   * |log(value/value before)| of those values of several entries that differ; NaN unless there are
   * any and they do so in one common ratio, up or down: a cell's number grows where its size falls.
   */
  double compute_common_ratio(const std::vector<std::string> &values_before,
                              const std::vector<std::string> &values);

  /**
   * Relative sizes h of the values of a numerical parameter, that of the last one 1, by the numbers
   * that the values are, each finer than the one before.
   *
   * @param values a list for each value: one text, or one for each of the entries that the
   * parameter sets.
   * @return nothing where entries do not change in one common ratio (compute_common_ratio()), or
   * one goes up and down.
   */
  std::vector<double> derive_sizes(const std::vector<std::vector<std::string>> &values);

  /** The same by numbers of cells in three dimensions, h = (n_last/n)^(1/3); nothing unless they
   * grow from each to the next. */
  std::vector<double> derive_sizes_of_cells(const std::vector<double> &n_cells);
} // namespace vfife

#endif
