// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/sample_measures.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/base/text/former_result_names.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/quantity.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/study/sweep/history_figure.h>
#include <vfife/study/sweep/refinement.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
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

    /**
     * Tooth meshes of equally spaced samples, a mesh of @p meshes_per_sample: whole meshes at the
     * end laid over each other. Empty for less than two.
     */
    std::vector<Numbers> fold_meshes(const Numbers &column, const double meshes_per_sample)
    {
      const double      samples  = 1 / meshes_per_sample; // in a mesh
      const double      n_meshes = std::floor((column.size() - 1 + 1e-6) * meshes_per_sample);
      const std::size_t n        = std::max(std::lround(samples), 2L); // positions in a mesh
      if (!(n_meshes >= 2))
        return {};
      // Between samples linear, where a mesh is no whole number of them.
      const double         begin = column.size() - 1 - n_meshes * samples;
      std::vector<Numbers> meshes(n_meshes, Numbers(n));
      for (std::size_t m = 0; m < meshes.size(); ++m)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double      place = begin + (m + double(j) / n) * samples;
            const std::size_t i =
              std::min(static_cast<std::size_t>(std::max(place, 0.)), column.size() - 2);
            meshes[m][j] = column[i] + (place - i) * (column[i + 1] - column[i]);
          }
      return meshes;
    }

    /** Mean of the meshes, of which there is one at least. */
    Numbers find_mean_mesh(const std::vector<Numbers> &meshes)
    {
      Numbers mean_mesh(meshes.front().size(), 0.);
      for (const Numbers &mesh : meshes)
        for (std::size_t j = 0; j < mesh.size(); ++j)
          mean_mesh[j] += mesh[j] / meshes.size();
      return mean_mesh;
    }

    /** Part of the variance that repeats with the mesh: that of the mean mesh. */
    double compute_periodic_share(const std::vector<Numbers> &meshes)
    {
      const Numbers mean_mesh = find_mean_mesh(meshes);
      const double  mean      = mean_of(mean_mesh);
      double        square = 0, square_of_mesh = 0;
      for (const Numbers &mesh : meshes)
        for (std::size_t j = 0; j < mesh.size(); ++j)
          {
            square += (mesh[j] - mean) * (mesh[j] - mean);
            square_of_mesh += (mean_mesh[j] - mean) * (mean_mesh[j] - mean);
          }
      return square > 0 ? square_of_mesh / square : 1;
    }

    /** Slope of the meshes' means by least squares, a mesh. */
    double compute_trend(const std::vector<Numbers> &meshes)
    {
      // About the middle number of a mesh the sum of the numbers is zero.
      double sum = 0, square = 0;
      for (std::size_t m = 0; m < meshes.size(); ++m)
        {
          const double number = m - .5 * (meshes.size() - 1.);
          sum += number * mean_of(meshes[m]);
          square += number * number;
        }
      return sum / square;
    }

    double compute_periodic_peak_to_peak(const std::vector<Numbers> &meshes)
    {
      return peak_to_peak_of(find_mean_mesh(meshes));
    }

    using OfMeshes = double (*)(const std::vector<Numbers> &);

    /** How a value follows from two mesh cycles or more; null for those of single samples. */
    OfMeshes find_value_of_meshes(const FigureValue value)
    {
      switch (value)
        {
        case FigureValue::periodic_share:
          return compute_periodic_share;
        case FigureValue::periodic_peak_to_peak:
          return compute_periodic_peak_to_peak;
        case FigureValue::trend:
          return compute_trend;
        default:
          return nullptr;
        }
    }

    /** One number of a column, in its unit but for change [-], where largest [that of @p time,
     * which is a speed in tables over speed], time above half [s] and zero crossing rate [Hz]. */
    double compute_value(const FigureValue value, const Numbers &time, const Numbers &column)
    {
      switch (value)
        {
        case FigureValue::last:
          return column.back();
        case FigureValue::first:
          return column.front();
        case FigureValue::mean:
          return mean_of(column);
        case FigureValue::largest:
          return *std::max_element(column.begin(), column.end());
        case FigureValue::smallest:
          return *std::min_element(column.begin(), column.end());
        case FigureValue::where_largest:
          return time[std::max_element(column.begin(), column.end()) - column.begin()];
        case FigureValue::largest_size:
          return std::max(*std::max_element(column.begin(), column.end()),
                          -*std::min_element(column.begin(), column.end()));
        case FigureValue::peak_to_peak:
          return peak_to_peak_of(column);
        case FigureValue::change:
          return column.back() / column.front() - 1;
        case FigureValue::mean_above_half:
          return compute_mean_above_half(column);
        case FigureValue::time_above_half:
          return compute_time_above_half(time, column);
        case FigureValue::zero_crossing_rate:
          return compute_zero_crossing_rate(time, column);
        default: // find_value_of_meshes()
          break;
        }
      return not_known;
    }

    /** Why compute_value() finds no number in the column. */
    std::string describe_lack(const FigureValue value, const Numbers &column)
    {
      if (!std::all_of(column.begin(), column.end(), [](const double x) {
            return std::isfinite(x);
          }))
        return "the column has values that are no numbers";
      switch (value)
        {
        case FigureValue::zero_crossing_rate:
          return "the column crosses zero less than twice";
        case FigureValue::mean_above_half:
          return "the column has no positive value";
        default: // FigureValue::change
          return "the first value of the column is zero";
        }
    }

    /** By the names of their files. */
    const Choices<FigureTable> &figure_table_choices()
    {
      static const Choices<FigureTable> choices = {{"history", FigureTable::history},
                                                   {"teeth", FigureTable::teeth},
                                                   {"probe_waves", FigureTable::probe_waves},
                                                   {"fillet_waves", FigureTable::fillet_waves},
                                                   {"resonance", FigureTable::resonance},
                                                   {"wave_response", FigureTable::wave_response},
                                                   {"stress_response",
                                                    FigureTable::stress_response}};
      return choices;
    }

    /** @p own: that of the column; @p over: that of the column of times or speeds. */
    std::string unit_of(const FigureValue value, const std::string &own, const std::string &over)
    {
      switch (value)
        {
        case FigureValue::where_largest:
          return over;
        case FigureValue::change:
        case FigureValue::periodic_share:
          return "-";
        case FigureValue::time_above_half:
          return "s";
        case FigureValue::zero_crossing_rate:
          return "Hz";
        case FigureValue::trend:
          return own + "/mesh";
        default:
          return own;
        }
    }
  } // namespace

  const Choices<FigureValue> &figure_value_choices()
  {
    static const Choices<FigureValue> choices = {
      {"last", FigureValue::last},
      {"first", FigureValue::first},
      {"mean", FigureValue::mean},
      {"largest", FigureValue::largest},
      {"where largest", FigureValue::where_largest},
      {"smallest", FigureValue::smallest},
      {"largest size", FigureValue::largest_size},
      {"peak to peak", FigureValue::peak_to_peak},
      {"peak to peak of mean mesh cycle", FigureValue::periodic_peak_to_peak},
      {"periodic share", FigureValue::periodic_share},
      {"trend", FigureValue::trend},
      {"change", FigureValue::change},
      {"mean above half", FigureValue::mean_above_half},
      {"time above half", FigureValue::time_above_half},
      {"zero crossing rate", FigureValue::zero_crossing_rate}};
    return choices;
  }

  void HistoryFigure::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm,
                   "table",
                   table,
                   figure_table_choices(),
                   "Table with the column. Histories have all values below; other tables have "
                   "mean, largest, where largest, smallest and largest size, over all rows "
                   "(tooth pairs, speeds, places)");
    declare_text(prm, "column", column, "Name of the column, without its unit");
    declare_choice(prm,
                   "value",
                   value,
                   figure_value_choices(),
                   "Value of the column. where largest: time or speed of the largest value; "
                   "change: last divided by first, minus one; half: time of half the largest "
                   "value; zero crossing rate: frequency of a vibration; mean mesh cycle: mean of "
                   "all mesh cycles, without the initial vibration; periodic share: part of "
                   "the variance that repeats with the mesh cycle; trend: slope of the means per "
                   "mesh cycle");
    declare_quantity(prm,
                     "from",
                     from,
                     "s",
                     "Samples from this time on, after the initial vibration has decayed; for "
                     "tables over time",
                     Range::not_negative());
    declare_text(prm,
                 "reference",
                 reference,
                 "Reference value in the unit of the results; the table then has errors and "
                 "orders of convergence");
  }

  void HistoryFigure::check(const std::string &section) const
  {
    if (column.empty())
      throw InputError(section + "/column", "the column of " + file() + " is missing");
    const std::vector<FigureValue> of_rows = {FigureValue::mean,
                                              FigureValue::largest,
                                              FigureValue::where_largest,
                                              FigureValue::smallest,
                                              FigureValue::largest_size};
    if (table != FigureTable::history && std::count(of_rows.begin(), of_rows.end(), value) == 0)
      throw InputError(section + "/value",
                       "expected mean, largest, where largest, smallest or largest size for " +
                         file() + ", got \"" + word_of(value, figure_value_choices()) + "\"");
    if (is_over_speed() && from > 0)
      throw InputError(section + "/from", file() + " has speeds and no times");
    if (!reference.empty())
      for_entry(section + "/reference", [this] { parse_quantity(reference, "-"); });
  }

  std::string HistoryFigure::file() const
  {
    return word_of(table, figure_table_choices()) + ".csv";
  }

  bool HistoryFigure::is_over_speed() const
  {
    return table == FigureTable::resonance || table == FigureTable::wave_response ||
           table == FigureTable::stress_response;
  }

  FoundFigure HistoryFigure::compute(const Table &history) const
  {
    std::vector<std::string> names;
    for (const Table::Column &one : history.columns())
      names.push_back(one.name);
    // Which columns there are depends on the case: only its file tells.
    const auto find = [this, &names, &history](const std::string &name) -> const Numbers & {
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw InputError("\"" + name + "\" is not a column of " + file() +
                         did_you_mean(name, names));
      return history.numbers(name);
    };
    const std::string over = is_over_speed() ? column::speed : column::time;
    const std::string own  = present_result_name(file(), column);
    const Numbers    &all = find(own), &all_times = find(over);
    const std::string unit = unit_of(value, history.column(own).unit, history.column(over).unit);
    // Speeds may rise and fall, and all of them count.
    const auto first =
      is_over_speed()
        ? 0
        : std::lower_bound(all_times.begin(), all_times.end(), from) - all_times.begin();
    const Numbers time(all_times.begin() + first, all_times.end()),
      samples(all.begin() + first, all.end());
    const auto none = [&unit](const std::string &fault) -> FoundFigure {
      return {{not_known, unit}, fault};
    };
    const auto found = [&](const double number) -> FoundFigure {
      return std::isfinite(number) ? FoundFigure{{number, unit}, ""}
                                   : none(describe_lack(value, samples));
    };
    if (all.empty())
      return none(file() + " has no rows");
    if (samples.empty())
      return none(sentence_of(
        4, "no samples from ", from, " s on; the record ends at ", all_times.back(), " s"));
    const OfMeshes value_of_meshes = find_value_of_meshes(value);
    if (value_of_meshes == nullptr)
      return found(compute_value(value, time, samples));
    std::vector<Numbers> meshes;
    if (samples.size() > 1)
      meshes = fold_meshes(samples,
                           find(column::mesh_frequency).back() * (time.back() - time.front()) /
                             (time.size() - 1));
    return meshes.empty() ? none("the samples have less than two mesh cycles")
                          : found(value_of_meshes(meshes));
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
    // p = log |e_before/e| / |log(h/h_before)|
    const double ratio = compute_common_ratio(values_before, values);
    // Where nothing differs, or an error is zero, this is not finite.
    const double order = std::log(std::abs(error_before / error)) / ratio;
    return std::isfinite(order) ? order : not_known;
  }
} // namespace vfife
