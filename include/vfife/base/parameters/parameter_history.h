// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_parameter_history_h
#define vfife_base_parameters_parameter_history_h

#include <vfife/base/parameters/expression.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace vfife
{
  /** A factor over time, as a user gives it: 1, a formula of t [s], or a table in a file. */
  class ParameterHistory
  {
  public:
    /** Declares "history" in the section entered. */
    void declare(dealii::ParameterHandler &prm);

    /**
     * Reads formula or file; to be called before value(). A text that ends in ".csv" or ".txt" is
     * the name of a file of two columns, time [s] and factor, separated by comma or blanks; lines
     * that do not begin with a number are passed over; between the rows the factor is
     * interpolated, outside it is that of the nearest row. Throws InputError for @p section.
     */
    void check(const std::string &section);

    /** The factor at @p time [s]. */
    double value(double time) const;

  private:
    std::string                            text_ = "1";
    std::optional<Expression>              formula_;
    std::vector<std::pair<double, double>> rows_;
  };
} // namespace vfife

#endif
