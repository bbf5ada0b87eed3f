// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/study/sweep/error_bars.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** The sum of the errors by all sequences, of which the values @p value_at gives are. */
    template <typename Values>
    ErrorBar sum_errors(const SweepVariant &variant, const double value, const Values &values_of)
    {
      ErrorBar bar;
      bar.value = value;
      for (std::size_t s = 0; s < variant.sequences.size(); ++s)
        {
          bar.by.push_back(estimate_error(values_of(s), variant.sequences[s].sizes));
          // NaN stays: an error that is not known does not make the sum smaller.
          bar.error += bar.by.back().error;
        }
      return bar;
    }

    /** "mesh: Richardson, order 1.8; penalty: spread of 2 of 3 values, without run_05" */
    std::string describe(const SweepVariant             &variant,
                         const ErrorBar                 &bar,
                         const std::vector<double>      &values,
                         const std::vector<std::string> &runs)
    {
      std::string text;
      for (std::size_t s = 0; s < variant.sequences.size(); ++s)
        {
          const NumericalSequence &sequence = variant.sequences[s];
          text += (s > 0 ? "; " : "") + sequence.parameter + ": " + bar.by[s].describe();
          if (sequence.sizes.empty() && sequence.runs.size() > 2)
            text += ", no ratio of refinement";
          for (const std::size_t run : sequence.runs)
            if (!std::isfinite(values[run]))
              text += ", without " + runs[run];
        }
      return text;
    }
  } // namespace

  ErrorBar compute_error_bar(const SweepVariant &variant, const std::vector<double> &values)
  {
    return sum_errors(variant, values[variant.run], [&](const std::size_t s) {
      std::vector<double> own;
      for (const std::size_t run : variant.sequences[s].runs)
        own.push_back(values[run]);
      return own;
    });
  }

  ErrorBar compute_difference(const SweepVariant        &first,
                              const SweepVariant        &second,
                              const std::vector<double> &values)
  {
    return sum_errors(first, values[first.run] - values[second.run], [&](const std::size_t s) {
      std::vector<double> differences;
      for (std::size_t k = 0; k < first.sequences[s].runs.size(); ++k)
        differences.push_back(values[first.sequences[s].runs[k]] -
                              values[second.sequences[s].runs[k]]);
      return differences;
    });
  }

  std::string word_for(const Verdict verdict)
  {
    static const Choices<Verdict> words = {{"significant", Verdict::significant},
                                           {"sign significant", Verdict::sign_significant},
                                           {"not significant", Verdict::not_significant},
                                           {"not known", Verdict::not_known}};
    return word_of(verdict, words);
  }

  Verdict
  judge_difference(const ErrorBar &first, const ErrorBar &second, const ErrorBar &difference)
  {
    const double size = std::abs(difference.value), both = first.error + second.error;
    if (!std::isfinite(size) || !std::isfinite(both) || !std::isfinite(difference.error))
      return Verdict::not_known;
    constexpr double round_off = 1e-9;
    const double     least = round_off * std::max(std::abs(first.value), std::abs(second.value));
    if (!(size > difference.error) || !(size > least))
      return Verdict::not_significant;
    return size > both ? Verdict::significant : Verdict::sign_significant;
  }

  ErrorTables make_error_tables(const std::vector<std::string> &numerical_parameters)
  {
    // Rows differ in their unit: it is a cell of its own, and the columns' unit says so.
    ErrorTables tables;
    tables.bars = {
      {"quantity"}, {"variant"}, {"run"}, {"unit"}, {"value", "unit"}, {"error", "unit"}};
    for (const std::string &parameter : numerical_parameters)
      tables.bars.add_column("error by " + parameter, "unit");
    tables.bars.add_text_column("method");

    tables.differences = {{"quantity"},
                          {"variant"},
                          {"other variant"},
                          {"unit"},
                          {"difference", "unit"},
                          {"error of the difference", "unit"},
                          {"sum of both errors", "unit"},
                          {"verdict"}};
    return tables;
  }

  ErrorTables compute_error_tables(const std::vector<SweepVariant> &variants,
                                   const std::vector<std::string>  &runs,
                                   const std::vector<NamedFigures> &all)
  {
    std::vector<std::string> parameters;
    for (const NumericalSequence &sequence : variants.front().sequences)
      parameters.push_back(sequence.parameter);
    ErrorTables tables = make_error_tables(parameters);
    for (std::size_t f = 0; f < all.front().size(); ++f)
      {
        std::vector<double> values;
        for (const NamedFigures &run : all)
          values.push_back(run[f].second.value);
        if (std::none_of(values.begin(), values.end(), [](const double v) {
              return std::isfinite(v);
            }))
          continue;
        const auto &[name, figure] = all.front()[f];
        std::vector<ErrorBar> bars;
        for (const SweepVariant &variant : variants)
          {
            bars.push_back(compute_error_bar(variant, values));
            const ErrorBar          &bar = bars.back();
            std::vector<Table::Cell> row = {name, variant.name, runs[variant.run], figure.unit};
            row.insert(row.end(), {bar.value, bar.error});
            for (const ErrorEstimate &error : bar.by)
              row.emplace_back(error.error);
            row.emplace_back(describe(variant, bar, values, runs));
            tables.bars.add_row(row);
          }
        for (std::size_t i = 0; i < variants.size(); ++i)
          for (std::size_t j = i + 1; j < variants.size(); ++j)
            {
              const ErrorBar difference = compute_difference(variants[i], variants[j], values);
              tables.differences.add_row(
                {name,
                 variants[i].name,
                 variants[j].name,
                 figure.unit,
                 difference.value,
                 difference.error,
                 bars[i].error + bars[j].error,
                 word_for(judge_difference(bars[i], bars[j], difference))});
            }
      }
    return tables;
  }
} // namespace vfife
