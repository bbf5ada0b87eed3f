// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>
#include <vfife/base/text/table.h>
#include <vfife/study/sweep/history_figure.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vfife
{
  namespace
  {
    constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

    using Numbers = std::vector<double>;

    /** Instants at which the column crosses @p level, linear between the samples. */
    Numbers find_crossings(const Numbers &time, const Numbers &column, const double level)
    {
      Numbers crossings;
      for (std::size_t i = 1; i < column.size(); ++i)
        if ((column[i - 1] > level) != (column[i] > level))
          crossings.push_back(time[i - 1] + (level - column[i - 1]) / (column[i] - column[i - 1]) *
                                              (time[i] - time[i - 1]));
      return crossings;
    }

    /** The time in which the column is above half its largest value. */
    double compute_time_above_half(const Numbers &time, const Numbers &column)
    {
      const double half      = 0.5 * *std::max_element(column.begin(), column.end());
      Numbers      crossings = find_crossings(time, column, half);
      // Crossings go up and down in turn. A record that begins or ends above half has its end for
      // the crossing that is missing, so that they make pairs.
      if (column.front() > half)
        crossings.insert(crossings.begin(), time.front());
      if (column.back() > half)
        crossings.push_back(time.back());
      double sum = 0;
      for (std::size_t i = 1; i < crossings.size(); i += 2)
        sum += crossings[i] - crossings[i - 1];
      return sum;
    }

    /** Mean of the samples above half the largest value; not known where none is positive. */
    double compute_mean_above_half(const Numbers &column)
    {
      // The plateau of a pulse, whose flanks below half its height do not count.
      const double half = 0.5 * *std::max_element(column.begin(), column.end());
      double       sum  = 0;
      unsigned int n    = 0;
      for (const double value : column)
        if (value > half)
          {
            sum += value;
            ++n;
          }
      return n > 0 ? sum / n : not_known;
    }

    /** Frequency of a vibration about zero [Hz]: n crossings are (n - 1)/2 periods. */
    double compute_zero_crossing_rate(const Numbers &time, const Numbers &column)
    {
      const Numbers crossings = find_crossings(time, column, 0);
      return crossings.size() < 2
               ? not_known
               : 0.5 * (crossings.size() - 1) / (crossings.back() - crossings.front());
    }

    /** One number of a column, in its unit but for change [-], time above half [s] and zero
     * crossing rate [Hz]. */
    double compute_value(const FigureValue value, const Numbers &time, const Numbers &column)
    {
      switch (value)
        {
        case FigureValue::last:
          return column.back();
        case FigureValue::first:
          return column.front();
        case FigureValue::mean:
          return std::accumulate(column.begin(), column.end(), 0.) / column.size();
        case FigureValue::largest:
          return *std::max_element(column.begin(), column.end());
        case FigureValue::smallest:
          return *std::min_element(column.begin(), column.end());
        case FigureValue::largest_size:
          return std::max(*std::max_element(column.begin(), column.end()),
                          -*std::min_element(column.begin(), column.end()));
        case FigureValue::change:
          return column.back() / column.front() - 1;
        case FigureValue::mean_above_half:
          return compute_mean_above_half(column);
        case FigureValue::time_above_half:
          return compute_time_above_half(time, column);
        case FigureValue::zero_crossing_rate:
          return compute_zero_crossing_rate(time, column);
        }
      return not_known;
    }

    /** A value of an entry: how large it is in internal units, and of what dimension. */
    struct Size
    {
      double      value = not_known;
      std::string dimension; ///< empty: a bare number, whose unit is the entry's
    };

    /** Not known of what is no number, or has a unit that is none. */
    Size read_size(const std::string &text)
    {
      try
        {
          std::string  name;
          const double number = read_number(text, name);
          if (name.empty())
            return {number, ""};
          const Unit &unit = find_unit(name);
          return {number * unit.factor, unit.dimension};
        }
      catch (const InputError &)
        {
          return {};
        }
    }

    /** |log(a/b)| of two values of one entry; not known unless both have units or neither has. */
    double compute_log_ratio(const std::string &a, const std::string &b)
    {
      // Which unit a bare number is in, the entry knows and this does not.
      const Size first = read_size(a), second = read_size(b);
      return first.dimension == second.dimension ? std::abs(std::log(first.value / second.value))
                                                 : not_known;
    }
  } // namespace

  const Choices<FigureValue> &figure_value_choices()
  {
    static const Choices<FigureValue> choices = {{"last", FigureValue::last},
                                                 {"first", FigureValue::first},
                                                 {"mean", FigureValue::mean},
                                                 {"largest", FigureValue::largest},
                                                 {"smallest", FigureValue::smallest},
                                                 {"largest size", FigureValue::largest_size},
                                                 {"change", FigureValue::change},
                                                 {"mean above half", FigureValue::mean_above_half},
                                                 {"time above half", FigureValue::time_above_half},
                                                 {"zero crossing rate",
                                                  FigureValue::zero_crossing_rate}};
    return choices;
  }

  void HistoryFigure::declare(dealii::ParameterHandler &prm)
  {
    declare_text(prm, "column", column, "Column of history.csv, without its unit");
    declare_choice(prm,
                   "value",
                   value,
                   figure_value_choices(),
                   "What is taken of the column; change: last over first minus one; half: of the "
                   "largest value; zero crossing rate: a vibration's frequency");
    declare_text(prm,
                 "reference",
                 reference,
                 "What it should be, a number in the unit of the results; with it errors and "
                 "orders of convergence are stated");
  }

  void HistoryFigure::check(const std::string &section) const
  {
    if (column.empty())
      throw InputError(section + "/column", "the column of history.csv is missing");
    if (!reference.empty())
      try
        {
          parse_quantity(reference, "-");
        }
      catch (const InputError &error)
        {
          throw InputError(section + "/reference", error.what());
        }
  }

  Figure HistoryFigure::compute(const Table &history) const
  {
    std::vector<std::string> names;
    for (const Table::Column &one : history.columns())
      names.push_back(one.name);
    // Which columns a history has depends on the case: only its file tells.
    if (std::find(names.begin(), names.end(), column) == names.end())
      throw InputError("\"" + column + "\" is not a column of history.csv" +
                       did_you_mean(column, names));
    const std::string unit = value == FigureValue::change            ? "-"
                             : value == FigureValue::time_above_half ? "s"
                             : value == FigureValue::zero_crossing_rate
                               ? "Hz"
                               : history.column(column).unit;
    if (history.n_rows() == 0)
      return {not_known, unit};
    return {compute_value(value, history.numbers(column::time), history.numbers(column)), unit};
  }

  double HistoryFigure::compute_error(const double number) const
  {
    if (reference.empty())
      return not_known;
    const double expected = parse_quantity(reference, "-");
    // e = value/reference - 1, or the value itself
    return expected == 0 ? number : number / expected - 1;
  }

  std::string HistoryFigure::error_unit(const std::string &unit) const
  {
    return !reference.empty() && parse_quantity(reference, "-") == 0 ? unit : "-";
  }

  double compute_order(const double                    error_before,
                       const double                    error,
                       const std::vector<std::string> &values_before,
                       const std::vector<std::string> &values)
  {
    // p = log |e_before/e| / |log(h/h_before)|. All parameters that differ must do so by one ratio,
    // up or down (a cell's number grows where its size falls); otherwise there is no h.
    double ratio = 0; // logarithm
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] != values_before[i])
        {
          const double own = compute_log_ratio(values[i], values_before[i]);
          if (!std::isfinite(own) || (ratio > 0 && std::abs(own - ratio) > 1e-6))
            return not_known;
          ratio = own;
        }
    // Where nothing differs, or an error is zero, this is not finite.
    const double order = std::log(std::abs(error_before / error)) / ratio;
    return std::isfinite(order) ? order : not_known;
  }
} // namespace vfife
