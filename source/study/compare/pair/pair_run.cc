// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/column_names.h>
#include <vfife/output/files/result_places.h>
#include <vfife/study/compare/pair/pair_run.h>
#include <vfife/study/compare/pair/quasi_static.h>

#include <sstream>

namespace vfife
{
  std::string rounded_text(const double value)
  {
    std::ostringstream text;
    text << value;
    return text.str();
  }

  PairRun::PairRun(const ComparedCase &run, const ComparisonTolerances &tolerances)
    : tolerances(tolerances)
    , history(run.table("history.csv"))
    , run_(run)
    , rate_(summary(summary_place::figure(figure_name::speed_of("pinion"))))
    , mesh_frequency(summary(summary_place::figure(figure_name::mesh_frequency)))
    , start(summary(summary_place::steady_start))
    , is_steady_(summary(summary_place::is_steady) == 1)
    , is_ripple_unsteady_(summary(summary_place::is_ripple_steady) == 0)
  {
    if (!(mesh_frequency > 0))
      throw InputError(
        "the case \"" + run.name +
        "\" cannot be compared: its run has no mesh frequency, because its speed changes");
  }

  double PairRun::steady_mean(const std::string &column) const
  {
    return summary(summary_place::steady_mean(column));
  }

  void PairRun::cut(const std::string   &column,
                    std::vector<double> &time,
                    std::vector<double> &values) const
  {
    // Up to the end of the run, which is that of the steady part but for a part of a tooth
    // mesh.
    for (std::size_t i = 0; i < history.n_rows(); ++i)
      if (history.numbers(column::time)[i] >= start)
        {
          time.push_back(history.numbers(column::time)[i]);
          values.push_back(history.numbers(column)[i]);
        }
  }

  std::vector<std::optional<double>>
  PairRun::at_positions(const std::string &column, const std::vector<double> &positions) const
  {
    std::vector<double> time, values;
    cut(column, time, values);
    return compute_mean_mesh(time, values, mesh_frequency, positions);
  }

  void PairRun::judge_slow(const double tolerance, ComparisonRow &row, const double swing) const
  {
    // [rpm]. What the speed excludes is said first, then what the run, then what the modes do.
    const double limit = tolerances.slow * 30 / pi;
    if (rate_ > limit * (1 + 1e-9))
      row.reason += "; the static pair is a reference up to " + rounded_text(limit) +
                    " rpm only: at " + rounded_text(rate_) + " rpm the difference is stated";
    else if (!is_steady_)
      row.reason += "; the run has no steady part";
    else if (swing > tolerance)
      row.reason += "; mesh orders near the coupled modes may add " + rounded_text(swing) + " " +
                    row.unit + " without damping";
    else
      row.tolerance = tolerance;
  }

  void
  PairRun::judge_slow_ripple(const double tolerance, ComparisonRow &row, const double swing) const
  {
    if (is_ripple_unsteady_)
      row.reason += "; the run's ripple is still transient";
    else
      judge_slow(tolerance, row, swing);
  }

  void PairRun::judge_steady(const double tolerance, ComparisonRow &row) const
  {
    if (is_steady_)
      row.tolerance = tolerance;
    else
      row.reason += "; the run has no steady part, so means are from its last third";
  }
} // namespace vfife
