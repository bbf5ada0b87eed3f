// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/sample_measures.h>
#include <vfife/study/sweep/error_estimate.h>

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

namespace vfife
{
  namespace
  {
    // Below, the limit lies many differences away; above, linear elements do not go on so.
    constexpr double lowest_order = 0.5, highest_order = 2.1;
    // The extrapolated limit is an estimate: without the factor half of the bars would be too
    // small.
    constexpr double safety_factor = 1.25;

    /** The order p of f = f_0 + C h^p through three values; nothing where there is no sensible one.
     */
    std::optional<double> find_order(const double *f, const double *h)
    {
      const double first = f[0] - f[1], second = f[1] - f[2];
      if (!(first * second > 0))
        return std::nullopt;
      // (f_0 - f_1)/(f_1 - f_2) = (h_0^p - h_1^p)/(h_1^p - h_2^p), which grows with p.
      const auto excess = [&](const double p) {
        return (std::pow(h[0], p) - std::pow(h[1], p)) / (std::pow(h[1], p) - std::pow(h[2], p)) -
               first / second;
      };
      if (excess(lowest_order) > 0 || excess(highest_order) < 0)
        return std::nullopt;
      std::uintmax_t n_iterations = 100;
      const auto     bracket =
        boost::math::tools::toms748_solve(excess,
                                          lowest_order,
                                          highest_order,
                                          boost::math::tools::eps_tolerance<double>(50),
                                          n_iterations);
      return 0.5 * (bracket.first + bracket.second);
    }
  } // namespace

  std::string ErrorEstimate::describe() const
  {
    std::ostringstream text;
    if (method == ErrorMethod::richardson)
      text << "Richardson, order " << std::fixed << std::setprecision(2) << order;
    else
      text << (method == ErrorMethod::spread ? "spread of " : "not known");
    if (n_used < n_all)
      text << (method == ErrorMethod::spread ? "" : ", ") << n_used << " of " << n_all << " values";
    else if (method == ErrorMethod::spread)
      text << n_all << " values";
    return text.str();
  }

  ErrorEstimate estimate_error(const std::vector<double> &values, const std::vector<double> &sizes)
  {
    std::vector<double> f, h;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (std::isfinite(values[k]))
        {
          f.push_back(values[k]);
          h.push_back(sizes.empty() ? 0 : sizes[k]);
        }
    ErrorEstimate result;
    result.n_used = f.size();
    result.n_all  = values.size();
    if (f.size() < 2 || !std::isfinite(values.back()))
      return result;

    const std::size_t last = f.size() - 1;
    if (f.size() >= 3 && !sizes.empty())
      if (const auto order = find_order(&f[last - 2], &h[last - 2]))
        {
          result.method = ErrorMethod::richardson;
          result.order  = *order;
          // |C| h^p of the last value
          const double distance =
            std::abs(f[last - 1] - f[last]) / (std::pow(h[last - 1] / h[last], *order) - 1);
          result.error = safety_factor * distance;
          return result;
        }
    result.method = ErrorMethod::spread;
    result.error  = peak_to_peak_of(f);
    return result;
  }
} // namespace vfife
