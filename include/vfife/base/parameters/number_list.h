// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_number_list_h
#define vfife_base_parameters_number_list_h

#include <vfife/base/parameter_handler.h>

#include <string>
#include <vector>

namespace vfife
{
  /** The parts of a text between its commas, without blanks around them; one at least. */
  std::vector<std::string> split_at_commas(const std::string &text);

  /** What the numbers of a list are: whole ones have no decimals. */
  enum class ListNumbers
  {
    any,
    whole
  };

  /**
   * Throws InputError for what may be one number with a comma in it as well as two of a list:
   * "1,5 ms" (a decimal comma) and "9,000 rpm" (thousands). A blank behind a comma makes it a list
   * whatever the numbers are, and so does a number that no such reading has: "0,5,10",
   * "0,4000,9000 rpm", of whole numbers "2,3".
   */
  void check_list_commas(const std::string &text, ListNumbers numbers);

  /** Declares a list of numbers, which may have units, separated by commas; one that
   * check_list_commas() refuses is an error. Of each number @p value gets the text. */
  void declare_number_list(dealii::ParameterHandler &prm,
                           const std::string        &name,
                           std::vector<std::string> &value,
                           const std::string        &meaning,
                           ListNumbers               numbers = ListNumbers::any);

  /** The numbers of such a list [internal units]. A unit behind the last one is that of all that
   * carry none ("0, 100, 200 rad/s"); without it bare ones are in @p unit. Throws InputError. */
  std::vector<double> read_number_list(const std::vector<std::string> &texts,
                                       const std::string              &unit);
} // namespace vfife

#endif
