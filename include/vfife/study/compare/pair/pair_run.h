// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_pair_pair_run_h
#define vfife_study_compare_pair_pair_run_h

#include <vfife/base/text/table.h>
#include <vfife/study/compare/compared_case.h>
#include <vfife/study/compare/comparison.h>

#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  /** A number in the words of a row, six digits. */
  std::string rounded_text(double value);

  /** A run of a gear pair and what rows of its comparison need. */
  class PairRun
  {
  public:
    /** Both must outlive this. Throws InputError where results cannot be read. */
    PairRun(const ComparedCase &run, const ComparisonTolerances &tolerances);

    const ComparedCase &folder() const
    {
      return run_;
    }

    /** Of summary.json, at a JSON pointer; NaN where there is none. */
    double summary(const std::string &pointer) const
    {
      return run_.number("summary.json", pointer);
    }

    /** Mean of a column of the history over the steady part. */
    double steady_mean(const std::string &column) const;

    bool has(const std::string &file) const
    {
      return run_.has(file);
    }

    Table table(const std::string &file) const
    {
      return run_.table(file);
    }

    /** The times and values of a column in the steady part. */
    void
    cut(const std::string &column, std::vector<double> &time, std::vector<double> &values) const;

    /** Means of a column over the mesh cycles of the steady part, at @p positions. */
    std::vector<std::optional<double>> at_positions(const std::string         &column,
                                                    const std::vector<double> &positions) const;

    /** The tolerance of what holds for slow runs only, and why. @p swing: what the modes may add,
     * in the unit of the row. */
    void judge_slow(double tolerance, ComparisonRow &row, double swing = 0.) const;

    /** The same for figures of the ripple. */
    void judge_slow_ripple(double tolerance, ComparisonRow &row, double swing) const;

    /** The tolerance of what holds on average at any speed. */
    void judge_steady(double tolerance, ComparisonRow &row) const;

    const ComparisonTolerances &tolerances;
    const Table                 history;

  private:
    const ComparedCase &run_;
    double              rate_; ///< of the pinion [rpm]

  public:
    const double mesh_frequency; ///< [Hz]
    const double start;          ///< of the steady part [s]

  private:
    bool is_steady_, is_ripple_unsteady_;
  };
} // namespace vfife

#endif
