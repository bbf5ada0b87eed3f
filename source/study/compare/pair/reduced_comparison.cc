// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/sample_measures.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/lumped/fourier_series.h>
#include <vfife/output/files/result_places.h>
#include <vfife/study/compare/pair/pair_run.h>
#include <vfife/study/compare/pair/reduced_comparison.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace vfife
{
  namespace
  {
    constexpr const char *kind = "reduced";

    constexpr unsigned int n_positions = 32, n_orders = 4;

    /** The mean mesh cycle of a steady part at positions that lie evenly over it. */
    struct MeanMesh
    {
      std::vector<double> values;
      double              scatter  = 0; ///< of single meshes about it, rms
      unsigned int        n_meshes = 0;
    };

    /** Orders with the largest amplitudes in either curve, ascending. */
    std::vector<unsigned int> find_largest_orders(const FourierSeries &one,
                                                  const FourierSeries &other)
    {
      const auto largest = [&](const unsigned int order) {
        return std::max(one.amplitude(order), other.amplitude(order));
      };
      std::vector<unsigned int> orders(one.n_harmonics());
      std::iota(orders.begin(), orders.end(), 1u);
      std::sort(orders.begin(), orders.end(), [&](const unsigned int a, const unsigned int b) {
        return largest(a) > largest(b);
      });
      orders.resize(std::min<std::size_t>(orders.size(), n_orders));
      std::sort(orders.begin(), orders.end());
      return orders;
    }

    /** Nothing where the steady part is shorter than a mesh cycle. */
    std::optional<MeanMesh> find_mean_mesh(const PairRun &run, const std::string &column)
    {
      std::vector<double> positions;
      for (unsigned int i = 0; i < n_positions; ++i)
        positions.push_back(double(i) / n_positions);
      const auto means = run.at_positions(column, positions);
      MeanMesh   mesh;
      for (const std::optional<double> &value : means)
        {
          if (!value)
            return {};
          mesh.values.push_back(*value);
        }
      std::vector<double> time, values;
      run.cut(column, time, values);
      const FourierSeries curve = FourierSeries::interpolate(mesh.values);
      for (std::size_t i = 0; i < time.size(); ++i)
        mesh.scatter +=
          std::pow(values[i] - curve.value(time[i] * run.mesh_frequency), 2) / time.size();
      mesh.scatter  = std::sqrt(mesh.scatter);
      mesh.n_meshes = static_cast<unsigned int>((time.back() - time.front()) * run.mesh_frequency);
      return mesh;
    }

    /** Distance of two curves less their means, rms. */
    double distance(const MeanMesh &a, const MeanMesh &b)
    {
      const double mean = mean_of(a.values), other = mean_of(b.values);
      double       sum = 0;
      for (unsigned int i = 0; i < n_positions; ++i)
        sum += std::pow(a.values[i] - mean - b.values[i] + other, 2) / n_positions;
      return std::sqrt(sum);
    }

    /** Judged by @p tolerance where both have steady parts. */
    void add(const PairRun  &run,
             const PairRun  &reduced,
             const double    tolerance,
             ComparisonRow   row,
             ComparisonRows &rows)
    {
      run.judge_steady(tolerance, row);
      if (row.tolerance)
        {
          row.tolerance.reset();
          reduced.judge_steady(tolerance, row);
        }
      rows.push_back(std::move(row));
    }

    void add_curve(const PairRun     &run,
                   const PairRun     &reduced,
                   const std::string &column,
                   const std::string &unit,
                   ComparisonRows    &rows)
    {
      const auto one = find_mean_mesh(run, column), other = find_mean_mesh(reduced, column);
      if (!one || !other)
        return;
      // What single meshes of the run scatter by their mean does, too, over the root of their
      // number.
      const double part  = run.tolerances.reduced_ripple * peak_to_peak_of(one->values),
                   noise = one->scatter;
      add(run,
          reduced,
          std::max(part, noise),
          {column + " over the mesh cycle, rms distance from the reduced pair's",
           unit,
           distance(*one, *other),
           0.,
           kind,
           {},
           "mean mesh cycles less their means; tolerance: " +
             (part > noise
                ? "a part of the run's peak to peak"
                : "scatter of single mesh cycles of the run, " + rounded_text(noise) + " " + unit)},
          rows);
      if (column != column::dte)
        return;
      const FourierSeries curve = FourierSeries::interpolate(one->values),
                          same  = FourierSeries::interpolate(other->values);
      for (const unsigned int order : find_largest_orders(curve, same))
        {
          const double amplitude = same.amplitude(order),
                       part      = run.tolerances.reduced_order * curve.amplitude(order),
                       noise     = one->scatter / std::sqrt(std::max(1u, one->n_meshes));
          ComparisonRow row      = {column + ", amplitude of mesh order " + std::to_string(order),
                                    unit,
                                    curve.amplitude(order),
                                    amplitude,
                                    kind,
                                    {},
                                    "from the mean mesh cycles"};
          if (noise > part)
            row.reason += "; the scatter of single mesh cycles of the run makes " +
                          figure_text(noise) + " " + unit + " uncertain";
          // Vibrations next to the cut-off are not in the reduced pair.
          const double cutoff = reduced.summary(summary_place::figure("cut-off frequency"));
          if (order * run.mesh_frequency > .5 * cutoff)
            {
              row.reason += "; above half the cut-off of " + rounded_text(cutoff) + " Hz";
              rows.push_back(std::move(row));
            }
          else if (noise > std::max(curve.amplitude(order), amplitude))
            rows.push_back(std::move(row));
          else
            add(run, reduced, std::max(part, noise), std::move(row), rows);
        }
    }
  } // namespace

  void add_reduced(const PairRun &run, const PairRun &reduced, ComparisonRows &rows)
  {
    // Shafts move the flanks by parts of a millimetre, on which reduced bodies, as all of small
    // displacements, do not let forces act: the tolerance of the loaded analysis.
    const bool on_shafts = run.has("bearings.csv");
    const auto mean      = [&](const char *column, const char *unit, const double part) {
      const double reference = reduced.steady_mean(column);
      add(run,
          reduced,
          part * std::abs(reference),
          {std::string("mean ") + column,
           unit,
           run.steady_mean(column),
           reference,
           kind,
           {},
           std::string("the same flanks, contact and penalty between reduced bodies") +
             (on_shafts ? "; forces on undisplaced shafts" : "")},
          rows);
    };
    mean(column::dte, "arcsec", on_shafts ? run.tolerances.error : run.tolerances.reduced_error);
    mean(column::contact_force_total, "N", run.tolerances.force);
    add_curve(run, reduced, column::dte, "arcsec", rows);
    add_curve(run, reduced, column::contact_force_total, "N", rows);

    const std::string swing = summary_place::figure(figure_name::torsional_frequency);
    ComparisonRow     row   = {"torsional mode frequency",
                               "Hz",
                               run.summary(swing),
                               reduced.summary(swing),
                               kind,
                               {},
                               "both from the slope of the equilibrium"};
    row.tolerance           = run.tolerances.frequency * row.reference;
    rows.push_back(row);
  }
} // namespace vfife
