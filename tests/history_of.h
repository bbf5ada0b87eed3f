// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_history_of_h
#define vfife_tests_history_of_h

#include <vfife/base/parameters/parameter_history.h>
#include <vfife/base/parameters/parameters.h>

#include <deal.II/base/parameter_handler.h>

/** A quantity over time as a parameter file gives it. */
struct QuantityOverTime
{
  double                  start = 0; ///< at time zero [internal units]
  vfife::ParameterHistory factor;
};

/** What the text of an entry says, numbers in @p unit. */
inline QuantityOverTime history_of(const std::string  &text,
                                   const std::string  &unit,
                                   const vfife::Range &range = vfife::Range::any())
{
  QuantityOverTime         quantity;
  dealii::ParameterHandler prm;
  vfife::declare_quantity_over_time(
    prm, "quantity", quantity.start, quantity.factor, unit, "A quantity", range);
  prm.set("quantity", text);
  return quantity;
}

#endif
