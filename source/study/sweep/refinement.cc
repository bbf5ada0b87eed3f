// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/quantity.h>
#include <vfife/base/types.h>
#include <vfife/study/sweep/refinement.h>

#include <cmath>

namespace vfife
{
  namespace
  {
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
  } // namespace

  double compute_log_ratio(const std::string &a, const std::string &b)
  {
    // Which unit a bare number is in, the entry knows and this does not.
    const Size   first = read_size(a), second = read_size(b);
    const double ratio =
      first.dimension == second.dimension ? std::log(first.value / second.value) : not_known;
    return std::isfinite(ratio) ? ratio : not_known;
  }

  double compute_common_ratio(const std::vector<std::string> &values_before,
                              const std::vector<std::string> &values)
  {
    double common = not_known;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] != values_before[i])
        {
          const double own = std::abs(compute_log_ratio(values[i], values_before[i]));
          if (!std::isfinite(own) ||
              std::abs(own - common) > 1e-6) // false as long as none is known
            return not_known;
          common = own;
        }
    return common;
  }

  std::vector<double> derive_sizes(const std::vector<std::vector<std::string>> &values)
  {
    std::vector<double> sizes(values.size(), 1.);
    std::vector<double> direction(values.back().size(), 0.);
    for (std::size_t k = values.size() - 1; k > 0; --k)
      {
        const double ratio = compute_common_ratio(values[k - 1], values[k]);
        if (!(ratio > 0))
          return {};
        for (std::size_t i = 0; i < direction.size(); ++i)
          if (values[k][i] != values[k - 1][i])
            {
              const double way = compute_log_ratio(values[k][i], values[k - 1][i]);
              if (way * direction[i] < 0)
                return {};
              direction[i] = way;
            }
        sizes[k - 1] = sizes[k] * std::exp(ratio);
      }
    return sizes;
  }

  std::vector<double> derive_sizes_of_cells(const std::vector<double> &n_cells)
  {
    std::vector<double> sizes;
    for (const double n : n_cells)
      {
        sizes.push_back(std::cbrt(n_cells.back() / n));
        const bool falls = sizes.size() == 1 || sizes.back() < sizes[sizes.size() - 2];
        if (!falls || !std::isfinite(sizes.back()))
          return {};
      }
    return sizes;
  }
} // namespace vfife
