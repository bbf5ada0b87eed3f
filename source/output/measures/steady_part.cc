// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/contact/contact_impulse.h>
#include <vfife/output/measures/steady_part.h>

#include "sample_integral.h"

#include <functional>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Rows [begin, end] by fractional index, of which means are taken. */
    struct Window
    {
      double begin, end;
    };

    std::string meshes_text(const unsigned int n)
    {
      return std::to_string(n) + (n == 1 ? " mesh cycle" : " mesh cycles");
    }

    /** Whether a column is the integral of another one over time. */
    bool is_impulse(const Table &history, const std::string &name)
    {
      return std::any_of(history.columns().begin(),
                         history.columns().end(),
                         [&name](const Table::Column &c) {
                           return ContactImpulse::column_of(c.name) == name;
                         });
    }

    bool has_numbers(const Table &table, const std::string &name)
    {
      return std::any_of(table.columns().begin(),
                         table.columns().end(),
                         [&name](const Table::Column &c) { return c.name == name && !c.is_text; });
    }

    /** Between the samples around a row index. */
    double interpolate(const std::vector<double> &values, const double row)
    {
      const std::size_t i = std::min(static_cast<std::size_t>(row), values.size() - 2);
      return values[i] + (row - static_cast<double>(i)) * (values[i + 1] - values[i]);
    }

    /** Over all steps in the window, @p interval [s] a row, where the history knows the integral of
     * the column; else the integral over the samples. */
    double compute_mean(const Table         &history,
                        const Table::Column &column,
                        const Window        &window,
                        const double         interval)
    {
      if (const std::string impulse = ContactImpulse::column_of(column.name);
          has_numbers(history, impulse))
        {
          const std::vector<double> &values = history.numbers(impulse);
          const double               mean =
            (interpolate(values, window.end) - interpolate(values, window.begin)) /
            (interval * (window.end - window.begin));
          // Rows of a version that did not know it have none.
          if (std::isfinite(mean))
            return mean;
        }
      return SampleIntegral(column.numbers).mean(window.begin, window.end);
    }

    /** With @p mean; of the samples in the window standard deviation, as an integral, and peak to
     * peak. */
    ColumnStatistics
    compute_statistics(const Table::Column &column, const double mean, const Window &window)
    {
      const std::vector<double> &values = column.numbers;
      ColumnStatistics           statistics;
      statistics.name = column.name;
      statistics.unit = column.unit;
      statistics.mean = mean;
      // Squares of the differences from the mean, so that a small ripple on a large mean keeps its
      // digits.
      std::vector<double> squares;
      const double        own = SampleIntegral(values).mean(window.begin, window.end);
      for (const double value : values)
        squares.push_back((value - own) * (value - own));
      statistics.standard_deviation =
        std::sqrt(SampleIntegral(std::move(squares)).mean(window.begin, window.end));

      // Less than two samples have no ripple.
      statistics.peak_to_peak = std::floor(window.end + 1e-6) > std::ceil(window.begin - 1e-6)
                                  ? compute_peak_to_peak(values, window.begin, window.end)
                                  : not_known;
      return statistics;
    }

    /** Largest number that @p change finds in a column; infinity where one is no number (lost
     * contact: 0/0, or a run that blew up), which is no steady state. */
    double find_largest(const std::vector<SampleIntegral>                   &judged,
                        const std::function<double(const SampleIntegral &)> &change)
    {
      double largest = 0;
      for (const SampleIntegral &column : judged)
        {
          const double here = change(column);
          if (!std::isfinite(here))
            return std::numeric_limits<double>::infinity();
          largest = std::max(largest, here);
        }
      return largest;
    }

    /** Largest relative difference of the means over [k, k+period) and [k+period, k+2 period) mesh
     * cycles. */
    double compute_change(const std::vector<SampleIntegral> &judged,
                          const unsigned int                 k,
                          const unsigned int                 period,
                          const double                       samples_per_mesh)
    {
      return find_largest(judged, [=](const SampleIntegral &column) {
        const double before = column.mean(k * samples_per_mesh, (k + period) * samples_per_mesh);
        const double after =
          column.mean((k + period) * samples_per_mesh, (k + 2 * period) * samples_per_mesh);
        return std::abs(after - before) / std::abs(after);
      });
    }

    /** Largest relative spread of the means of the single mesh cycles [k, end). */
    double compute_spread(const std::vector<SampleIntegral> &judged,
                          const unsigned int                 k,
                          const unsigned int                 end,
                          const double                       samples_per_mesh)
    {
      return find_largest(judged, [=](const SampleIntegral &column) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (unsigned int i = k; i < end; ++i)
          {
            const double mean = column.mean(i * samples_per_mesh, (i + 1) * samples_per_mesh);
            least             = std::min(least, mean);
            most              = std::max(most, mean);
          }
        return (most - least) / std::abs(column.mean(k * samples_per_mesh, end * samples_per_mesh));
      });
    }
  } // namespace

  namespace
  {
    /**
     * Judges the ripple of the part [start, end) of whole mesh cycles. Where the means are steady
     * and the ripple is not yet, the part begins later, as far as half of what was judged and what
     * the means ask for remain. Returns where it begins.
     */
    unsigned int judge_ripple(const Table                    &history,
                              const std::vector<std::string> &names,
                              const double                    samples_per_mesh,
                              const unsigned int              start,
                              const unsigned int              end,
                              SteadyPart                     &part)
    {
      part.ripple = compare_halves(history, names, samples_per_mesh, start, end);
      if (!part.found || part.ripple.steady)
        return start;
      const unsigned int least =
        std::max((part.by_cycles ? 1 : 2) * part.period, (part.judged_cycles + 1) / 2);
      for (unsigned int later = start + 1; later + least <= end; ++later)
        {
          const Ripple ripple = compare_halves(history, names, samples_per_mesh, later, end);
          if (ripple.steady)
            {
              part.ripple = ripple;
              return later;
            }
        }
      return start;
    }
  } // namespace

  SteadyPart find_steady_part(const Table                    &history,
                              const double                    samples_per_mesh,
                              const double                    swing_period_meshes,
                              const double                    ramp_end,
                              const std::vector<std::string> &judged_names,
                              const double                    tolerance)
  {
    if (history.n_rows() < 2)
      throw InputError("a history of fewer than two rows has no steady part");
    if (!(samples_per_mesh > 1) || !std::isfinite(swing_period_meshes))
      throw InputError("the steady part requires more than one sample per mesh cycle and a finite "
                       "period of the torsional mode");

    const std::vector<double> &time     = history.numbers(column::time);
    const double               interval = (time.back() - time.front()) / (time.size() - 1);
    const double               last_row = time.size() - 1;
    // Round-off of the samples per mesh must not cost a whole cycle.
    const unsigned int n_cycles    = std::floor(last_row / samples_per_mesh + 1e-6);
    const unsigned int first_cycle = std::min<double>(
      n_cycles,
      std::ceil(std::max(0., ramp_end - time.front()) / (interval * samples_per_mesh) - 1e-6));

    //    ramp  | judged cycles, the swing period being 3                    |
    // ---------+-----+-----+-----+-----+-----+-----+-----+-----+-----+-----+|
    //                [ mean before    |   mean after    ]  moves back from the end, a cycle a time
    SteadyPart part;
    // A period longer than the run is never compared, however long.
    part.period =
      static_cast<unsigned int>(std::clamp(std::ceil(swing_period_meshes - 1e-6), 1., 1e6));
    std::vector<std::string>    names;
    std::vector<SampleIntegral> judged;
    for (const std::string &name : judged_names)
      if (has_numbers(history, name))
        {
          names.push_back(name);
          judged.emplace_back(history.numbers(name));
        }
    if (judged.empty())
      throw InputError("the history has no column that can be judged for a steady part");

    // Two swing periods are compared with each other, or, where there is only one,
    // its single cycles.
    part.judged_cycles = n_cycles - first_cycle;
    part.after_ramp    = first_cycle > 0;
    part.by_cycles     = part.judged_cycles >= part.period && part.judged_cycles < 2 * part.period;
    const int span     = (part.by_cycles ? 1 : 2) * static_cast<int>(part.period);
    // Backwards from the end as long as all agree: the first disagreement ends the steady part.
    unsigned int start = n_cycles;
    for (int k = static_cast<int>(n_cycles) - span; k >= static_cast<int>(first_cycle); --k)
      {
        const double change = part.by_cycles
                                ? compute_spread(judged, k, n_cycles, samples_per_mesh)
                                : compute_change(judged, k, part.period, samples_per_mesh);
        if (!(change < tolerance))
          {
            if (!part.found)
              part.largest_change = change;
            break;
          }
        part.found          = true;
        part.largest_change = std::max(part.largest_change, change);
        start               = k;
      }
    // The last third in whole cycles; a history shorter than one cycle has rows only.
    if (!part.found && n_cycles > 0)
      start = n_cycles - std::max(1U, n_cycles / 3);
    start = judge_ripple(history, names, samples_per_mesh, start, n_cycles, part);

    Window window{2. / 3. * last_row, last_row};
    if (n_cycles > 0)
      {
        part.cycles = n_cycles - start;
        window      = {start * samples_per_mesh, std::min(last_row, n_cycles * samples_per_mesh)};
      }
    part.first_row  = std::ceil(window.begin - 1e-6);
    part.end_row    = static_cast<std::size_t>(std::floor(window.end + 1e-6)) + 1;
    part.start_time = time.front() + interval * window.begin;
    part.end_time   = time.front() + interval * window.end;
    for (const Table::Column &column : history.columns())
      if (!column.is_text && column.name != column::time && !is_impulse(history, column.name))
        part.columns.push_back(
          compute_statistics(column, compute_mean(history, column, window, interval), window));
    return part;
  }

  const ColumnStatistics &SteadyPart::column(const std::string &name) const
  {
    for (const ColumnStatistics &c : columns)
      if (c.name == name)
        return c;
    throw InputError("the steady part has no column \"" + name + "\"");
  }

  std::string SteadyPart::explain() const
  {
    std::ostringstream text;
    set_figure_digits(text, 4);
    const auto        milliseconds = [](const double t) { return 1e3 * t; };
    const double      percent      = 100 * largest_change;
    const std::string cycles_to_judge =
      meshes_text(judged_cycles) + (after_ramp ? " after the ramp" : "");
    if (found)
      text << (ripple.steady ? "steady from " : "means steady from ") << milliseconds(start_time)
           << " ms to " << milliseconds(end_time) << " ms (" << meshes_text(cycles) << "): ";
    else
      text << "no steady part: ";
    if (by_cycles)
      text << cycles_to_judge << (judged_cycles == 1 ? " is" : " are")
           << " fewer than two periods (" << meshes_text(period)
           << " each) of the torsional mode; means over single mesh cycles differ by "
           << (found ? "at most " : "") << percent << " %";
    else if (judged_cycles < period)
      text << cycles_to_judge << (judged_cycles == 1 ? " is" : " are") << " less than one period ("
           << meshes_text(period) << ") of the torsional mode";
    else
      text << "means over " << (found ? "" : "the last two times ") << meshes_text(period)
           << " differ by " << (found ? "at most " : "") << percent << " %";
    if (!found)
      text << "; values are from the " << (first_row == 0 ? "whole record, " : "last third, ")
           << milliseconds(start_time) << " ms to " << milliseconds(end_time) << " ms";
    text << ". " << ripple.explain();
    return text.str();
  }
} // namespace vfife
