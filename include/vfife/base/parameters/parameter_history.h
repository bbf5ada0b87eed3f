// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_parameter_history_h
#define vfife_base_parameters_parameter_history_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/parameters/expression.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  struct Range;

  /** A factor over time, as a user gives it: 1, a formula of t [s], or a table in a file. */
  class ParameterHistory
  {
  public:
    /** Declares "history" in the section entered. */
    void declare(dealii::ParameterHandler &prm);

    /**
     * Reads formula or file; to be called before value(). A text that ends in ".csv" or ".txt" is
     * the name of a file of two columns, time [s] and factor, separated by comma or blanks; lines
     * that do not begin with a number are passed over, but for units that a heading has in
     * brackets ("time [ms], factor [-]"); between the rows the factor is interpolated, outside it
     * is that of the nearest row. Throws InputError for @p section.
     */
    void check(const std::string &section);

    /** Whether it is the factor 1 by default, neither formula nor table. */
    bool is_constant() const;

    /** What the user gave: "1" by default. */
    const std::string &text() const
    {
      return text_;
    }

    /** Whether it is a formula. */
    bool is_formula() const;

    /** The time from which on the factor is constant [s]: of a table its last row's, else 0. */
    double end() const;

    /** The factor at @p time [s]. Throws InputError for a formula without a value there. */
    double value(double time) const;

    /** The integral of the factor from time zero to @p time [s]: of a table exact, of a formula by
     * quadrature to round-off. */
    double integral(double time) const;

    /** The time at which the integral comes to @p integral > 0 [s]. Throws InputError where the
     * factor falls to zero before. */
    double find_time(double integral) const;

    /** Least and largest factor between time zero and @p end [s]: of a table exact, of a formula
     * among 10,001 instants. */
    std::pair<double, double> find_range(double end) const;

  private:
    friend void declare_quantity_over_time(dealii::ParameterHandler &prm,
                                           const std::string        &name,
                                           double                   &start,
                                           ParameterHistory         &factor,
                                           const std::string        &unit,
                                           const std::string        &meaning,
                                           const Range              &range);

    /** Reads a formula, or a table whose values are in @p unit where a heading states no other;
     * factors are then values in internal units. Throws InputError; one of a value names @p entry.
     */
    void read(const std::string &text, const std::string &unit, const std::string &entry);
    /** Of a table from its first row on. */
    double table_integral(double time) const;
    double formula_integral(double begin, double end) const;

    std::string                            text_ = "1";
    std::optional<Expression>              formula_;
    std::vector<std::pair<double, double>> rows_;
    std::vector<double>                    areas_;     ///< integral from the first row to each
    double                                 scale_ = 1; ///< of the formula
    /** Of the formula from time zero to the ends of equal panels of time, as far as asked for. */
    mutable std::vector<double> panels_;
  };

  /**
   * Declares a dimensioned entry that may change with time: a quantity as of declare_quantity(), a
   * formula of t [s] with values in @p unit, or the name of a table (ParameterHistory::check())
   * with values in @p unit or in that of its heading. @p start becomes the value at time zero
   * [internal units] and holds the default on entry; @p factor the quantity over it, 1 of a
   * constant. A quantity that changes must not be zero at time zero. Values that the text states
   * (that at time zero of a formula, all rows of a table) are in @p range.
   */
  void declare_quantity_over_time(dealii::ParameterHandler &prm,
                                  const std::string        &name,
                                  double                   &start,
                                  ParameterHistory         &factor,
                                  const std::string        &unit,
                                  const std::string        &meaning,
                                  const Range              &range);
} // namespace vfife

#endif
