// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/figure_text.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/output/measures/ripple.h>

#include "sample_integral.h"

#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    constexpr unsigned int highest_order = 3;

    /** Peak to peak of a half and of the harmonics of the gear mesh in it. */
    struct Half
    {
      double              peak_to_peak;
      std::vector<double> harmonics;
    };

    /** Of the rows [begin, end], which are whole mesh cycles. */
    Half measure_half(const std::vector<double> &values,
                      const double               begin,
                      const double               end,
                      const double               samples_per_mesh)
    {
      Half         half{compute_peak_to_peak(values, begin, end), {}};
      const double mean = SampleIntegral(values).mean(begin, end);
      // Twice the amplitude |2/T int x exp(-i 2 pi n t/T_mesh) dt|; those above half the sampling
      // rate are not known.
      for (unsigned int order = 1; order <= highest_order && 2 * order < samples_per_mesh; ++order)
        {
          std::vector<double> cosine(values.size()), sine(values.size());
          for (std::size_t i = 0; i < values.size(); ++i)
            {
              const double phase = 2 * pi * order * static_cast<double>(i) / samples_per_mesh;
              cosine[i]          = (values[i] - mean) * std::cos(phase);
              sine[i]            = (values[i] - mean) * std::sin(phase);
            }
          half.harmonics.push_back(4 *
                                   std::hypot(SampleIntegral(std::move(cosine)).mean(begin, end),
                                              SampleIntegral(std::move(sine)).mean(begin, end)));
        }
      return half;
    }

    RippleChange compare(const Table::Column &column,
                         const double         begin,
                         const double         middle,
                         const double         end,
                         const double         samples_per_mesh)
    {
      const Half   before = measure_half(column.numbers, begin, middle, samples_per_mesh);
      const Half   after  = measure_half(column.numbers, middle, end, samples_per_mesh);
      RippleChange ripple{column.name, column.unit, before.peak_to_peak, after.peak_to_peak, 0};
      const double mean = SampleIntegral(column.numbers).mean(begin, end);
      const double size = std::max(before.peak_to_peak, after.peak_to_peak);
      if (!std::isfinite(mean) || !std::isfinite(size))
        ripple.change = std::numeric_limits<double>::infinity();
      else if (size > 1e-4 * std::abs(mean))
        {
          ripple.change = std::abs(after.peak_to_peak - before.peak_to_peak) / size;
          for (std::size_t n = 0; n < before.harmonics.size(); ++n)
            ripple.change =
              std::max(ripple.change, std::abs(after.harmonics[n] - before.harmonics[n]) / size);
        }
      return ripple;
    }
  } // namespace

  Ripple compare_halves(const Table                    &history,
                        const std::vector<std::string> &names,
                        const double                    samples_per_mesh,
                        const unsigned int              first_cycle,
                        const unsigned int              end_cycle,
                        const double                    tolerance)
  {
    Ripple ripple;
    if (end_cycle < first_cycle + 2)
      return ripple;
    //   first | neither |  first half   |  second half  | end
    const unsigned int half   = (end_cycle - first_cycle) / 2;
    const double       end    = std::min(end_cycle * samples_per_mesh, history.n_rows() - 1.);
    const double       middle = (end_cycle - half) * samples_per_mesh;
    const double       begin  = (end_cycle - 2 * half) * samples_per_mesh;
    ripple.judged = ripple.steady = true;
    for (const std::string &name : names)
      {
        ripple.columns.push_back(
          compare(history.column(name), begin, middle, end, samples_per_mesh));
        ripple.steady = ripple.steady && ripple.columns.back().change < tolerance;
      }
    return ripple;
  }

  std::string Ripple::explain() const
  {
    if (!judged)
      return "The ripple is not judged: two whole mesh cycles are required";
    std::ostringstream text;
    text << "The ripple is " << (steady ? "steady" : "still transient");
    const char *separator = ": ";
    for (const RippleChange &column : columns)
      {
        text << separator << column.name << " has " << figure_text(column.peak_to_peak_before)
             << " " << column.unit << " peak to peak in the first half and "
             << figure_text(column.peak_to_peak_after) << " " << column.unit
             << " in the second, the largest change including mesh harmonics is "
             << figure_text(100 * column.change) << " %";
        separator = "; ";
      }
    return text.str();
  }
} // namespace vfife
