// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_history.h>
#include <vfife/base/parameters/parameter_table.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

namespace vfife
{
  namespace
  {
    using Quadrature = boost::math::quadrature::gauss<double, 10>;

    /** Of what has the integral @p whole by the rule on the whole: halved until both halves add up
     * to it, at most so many times, which a jump needs. */
    double integrate(const std::function<double(double)> &rate,
                     const double                         begin,
                     const double                         end,
                     const double                         whole,
                     const double                         tolerance,
                     const unsigned int                   halvings)
    {
      const double middle = 0.5 * (begin + end), left = Quadrature::integrate(rate, begin, middle),
                   right = Quadrature::integrate(rate, middle, end);
      if (std::abs(left + right - whole) <= tolerance || halvings == 0)
        return left + right;
      return integrate(rate, begin, middle, left, tolerance, halvings - 1) +
             integrate(rate, middle, end, right, tolerance, halvings - 1);
    }

    /** Length of the panels into which the integral of a formula is divided [s]. */
    constexpr double panel = 1e-4;
  } // namespace

  void ParameterHistory::declare(dealii::ParameterHandler &prm)
  {
    declare_formula_or_table(
      prm,
      "history",
      text_,
      "Factor over time: a formula of t [s], or a table file (.csv, .txt) of time [s] "
      "and factor");
  }

  void ParameterHistory::check(const std::string &section)
  {
    for_entry(section + "/history", [&] { read(text_, "-", section + "/history"); });
  }

  void
  ParameterHistory::read(const std::string &text, const std::string &unit, const std::string &entry)
  {
    text_ = text;
    formula_.reset();
    rows_.clear();
    areas_.clear();
    panels_.clear();
    scale_ = parse_quantity("1", unit);
    if (!names_a_table(text))
      {
        formula_.emplace(text, entry);
        return;
      }
    rows_ = read_time_table(text, unit);
    areas_.push_back(0.);
    for (std::size_t i = 1; i < rows_.size(); ++i)
      areas_.push_back(areas_.back() + 0.5 * (rows_[i].first - rows_[i - 1].first) *
                                         (rows_[i].second + rows_[i - 1].second));
  }

  bool ParameterHistory::is_constant() const
  {
    return !formula_ && rows_.empty();
  }

  bool ParameterHistory::is_formula() const
  {
    return formula_.has_value();
  }

  double ParameterHistory::end() const
  {
    return rows_.empty() ? 0. : rows_.back().first;
  }

  double ParameterHistory::value(const double time) const
  {
    // One of three: a formula of t, a table, or neither of them, which is the factor 1.
    if (formula_)
      return scale_ * (*formula_)(Vector3::Zero(), time);
    if (rows_.empty())
      return 1.;
    // The first row at or behind this time: linear from the one before, constant outside the table.
    const auto next =
      std::lower_bound(rows_.begin(), rows_.end(), time, [](const auto &row, const double t) {
        return row.first < t;
      });
    if (next == rows_.begin())
      return rows_.front().second;
    if (next == rows_.end())
      return rows_.back().second;
    const auto  &last = *(next - 1);
    const double part = (time - last.first) / (next->first - last.first);
    return last.second + part * (next->second - last.second);
  }

  double ParameterHistory::table_integral(const double time) const
  {
    if (time <= rows_.front().first)
      return (time - rows_.front().first) * rows_.front().second;
    const auto next =
      std::lower_bound(rows_.begin(), rows_.end(), time, [](const auto &row, const double t) {
        return row.first < t;
      });
    const std::size_t last = next - rows_.begin() - 1;
    return areas_[last] + 0.5 * (time - rows_[last].first) * (rows_[last].second + value(time));
  }

  double ParameterHistory::formula_integral(const double begin, const double end) const
  {
    if (begin == end)
      return 0.;
    const auto   rate  = [this](const double t) { return value(t); };
    const double whole = Quadrature::integrate(rate, begin, end);
    return integrate(rate, begin, end, whole, 1e-14 * std::abs(whole), 40);
  }

  double ParameterHistory::integral(const double time) const
  {
    if (is_constant())
      return time;
    if (!formula_)
      return table_integral(time) - table_integral(0.);
    if (time <= 0)
      return -formula_integral(time, 0.);
    // Whole panels are kept: whenever it is asked, and in whatever order, the answer is the same.
    const std::size_t whole = static_cast<std::size_t>(time / panel);
    if (panels_.empty())
      panels_.push_back(0.);
    while (panels_.size() <= whole)
      panels_.push_back(panels_.back() +
                        formula_integral((panels_.size() - 1) * panel, panels_.size() * panel));
    return panels_[whole] + formula_integral(whole * panel, time);
  }

  double ParameterHistory::find_time(const double integral) const
  {
    if (is_constant())
      return integral;
    // In steps of a hundredth of the time at the value of time zero, so that no fall to zero is
    // passed over; then the root between two of them.
    constexpr unsigned int most_steps = 1000000;
    const double           step       = 1e-2 * integral / value(0.);
    for (unsigned int i = 1; i <= most_steps && value(i * step) > 0; ++i)
      if (this->integral(i * step) >= integral)
        {
          const auto     rest       = [&](const double t) { return this->integral(t) - integral; };
          const auto     tolerance  = boost::math::tools::eps_tolerance<double>(50);
          std::uintmax_t iterations = 100;
          const auto     found      = boost::math::tools::toms748_solve(
            rest, (i - 1) * step, i * step, tolerance, iterations);
          return 0.5 * (found.first + found.second);
        }
    throw InputError("reaches zero, or almost zero, before the end");
  }

  std::pair<double, double> ParameterHistory::find_range(const double end) const
  {
    std::pair<double, double> range = std::minmax(value(0.), value(end));
    const auto                meet  = [&range](const double number) {
      range = {std::min(range.first, number), std::max(range.second, number)};
    };
    for (const auto &[time, number] : rows_)
      if (time > 0 && time < end)
        meet(number);
    constexpr unsigned int n = 10000;
    for (unsigned int i = 1; i < n && formula_; ++i)
      meet(value(i * end / n));
    return range;
  }

  void declare_quantity_over_time(dealii::ParameterHandler &prm,
                                  const std::string        &name,
                                  double                   &start,
                                  ParameterHistory         &factor,
                                  const std::string        &unit,
                                  const std::string        &meaning,
                                  const Range              &range)
  {
    const double      default_start = start;
    const std::string default_text  = quantity_text(start, unit);
    const auto        read          = [=](const std::string &text) {
      std::pair<double, ParameterHistory> both;
      if (!names_a_table(text) && !has_word(text, "t"))
        {
          both.first =
            text == default_text ? default_start : read_quantity_in_range(text, unit, range);
          return both;
        }
      ParameterHistory &history = both.second;
      history.read(text, unit, name);
      both.first = history.value(0.);
      // Each number that is given, in the unit in which its range is stated.
      std::vector<std::pair<double, double>> given = history.rows_;
      given.emplace_back(0., both.first);
      for (const auto &row : given)
        read_quantity_in_range(number_text(in_unit(row.second, unit)), unit, range);
      if (both.first == 0)
        throw InputError("the value at t = 0 must not be zero, because it is the reference of the "
                                         "formula or table");
      for (auto &row : history.rows_)
        row.second /= both.first;
      for (double &area : history.areas_)
        area /= both.first;
      history.scale_ /= both.first;
      return both;
    };
    declare_quantity_or_table(
      prm,
      name,
      default_text,
      [read](const std::string &text) { read(text); },
      [read, &start, &factor](const std::string &text) { std::tie(start, factor) = read(text); },
      describe_quantity(meaning + "; or over time, as a formula of t [s] or a table file (.csv, "
                                  ".txt) of time [s] and value",
                        unit,
                        range));
  }
} // namespace vfife
