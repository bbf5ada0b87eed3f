// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/measures/bearing_columns.h>
#include <vfife/study/compare/pair/bearing_comparison.h>
#include <vfife/study/conventional/loaded_contact_tables.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace vfife
{
  namespace
  {
    constexpr char bearing_file[] = "bearings.csv", misalignment_file[] = "misalignment.csv";

    /** Rows of a table that count: of a run those of the steady part. */
    std::vector<std::size_t> steady_rows(const PairRun &run, const Table &table)
    {
      std::vector<std::size_t> rows;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (table.numbers(column::time)[i] >= run.start)
          rows.push_back(i);
      return rows;
    }

    std::vector<std::size_t> all_rows(const Table &table)
    {
      std::vector<std::size_t> rows(table.n_rows());
      std::iota(rows.begin(), rows.end(), std::size_t(0));
      return rows;
    }

    double mean_of_rows(const std::vector<double> &values, const std::vector<std::size_t> &rows)
    {
      double sum = 0;
      for (const std::size_t i : rows)
        sum += values[i];
      return sum / rows.size();
    }

    /** Mean forces on the shaft of each bearing along its axes [N]. */
    std::map<std::string, Vector3> mean_forces(const Table                    &table,
                                               const std::vector<std::size_t> &rows)
    {
      std::map<std::string, std::vector<std::size_t>> of_bearing;
      for (const std::size_t i : rows)
        of_bearing[table.column(column::bearing).texts[i]].push_back(i);
      std::map<std::string, Vector3> means;
      for (const auto &[bearing, own] : of_bearing)
        for (unsigned int c = 0; c < 3; ++c)
          means[bearing][c] =
            mean_of_rows(table.numbers(std::string("force ") + column::fixed_axes[c]), own);
      return means;
    }

    /** What each bearing carries across and along its axis. */
    void add_forces(const PairRun &run, const ComparedCase &loaded, ComparisonRows &rows)
    {
      const Table table     = run.table(bearing_file);
      const auto  forces    = mean_forces(table, steady_rows(run, table));
      const Table reference = loaded.table(bearing_file);
      for (const auto &[bearing, expected] : mean_forces(reference, all_rows(reference)))
        {
          const auto found = forces.find(bearing);
          if (found == forces.end())
            continue;
          const auto add = [&](const char *direction, const double value, const double by) {
            ComparisonRow row{"bearing " + bearing + ", mean force " + direction + " its axis",
                              "N",
                              value,
                              by,
                              "FEM",
                              {},
                              "part of the total force of the bearing"};
            run.judge_slow(run.tolerances.force * expected.norm(), row);
            rows.push_back(row);
          };
          // Some carry nothing across or along: thrust bearings, cylindrical rollers.
          if (!expected.head<2>().isZero(0.))
            add("across", found->second.head<2>().norm(), expected.head<2>().norm());
          if (expected[2] != 0)
            add("along", found->second[2], expected[2]);
        }
    }

    /** The four numbers; lengths by the largest of them. */
    void add_misalignment(const PairRun &run, const ComparedCase &loaded, ComparisonRows &rows)
    {
      const Table table     = run.table(misalignment_file);
      const Table reference = loaded.table(misalignment_file);
      const auto  steady = steady_rows(run, table), all = all_rows(reference);
      if (steady.empty() || all.empty())
        return;
      std::map<std::string, double> largest; // by unit
      for (const MountingNumber &number : list_numbers(Mounting()))
        largest[number.unit] =
          std::max(largest[number.unit],
                   std::abs(mean_of_rows(reference.numbers(number.name), all)));
      for (const MountingNumber &number : list_numbers(Mounting()))
        {
          ComparisonRow row{
            "misalignment, mean " + number.name,
            number.unit,
            mean_of_rows(table.numbers(number.name), steady),
            mean_of_rows(reference.numbers(number.name), all),
            "FEM",
            {},
            "tolerance of the transmission error, relative to the largest in this unit"};
          run.judge_slow(run.tolerances.error * largest[number.unit], row);
          rows.push_back(row);
        }
    }

    /** Faster, the equilibrium before the run is that of shafts that turn with their displacement,
     * and the loaded analysis that of shafts which stand so in space. */
    void add_parts(const PairRun &run, const ComparedCase &loaded, ComparisonRows &rows)
    {
      const Table                reference = loaded.table(misalignment_file);
      const std::vector<double> &positions = reference.numbers(column::position);
      if (positions.empty() || positions.front() != 0)
        return;
      const double whole = std::abs(run.summary(summary_place::part_of_error(error_part::total)));
      const auto   add   = [&](const char *part, const char *column) {
        ComparisonRow row{std::string("dte at the start, part of the ") + part,
                          "arcsec",
                          run.summary(summary_place::part_of_error(part)),
                          reference.numbers(column).front(),
                          "FEM",
                          {},
                          "equilibrium before the run and the first position; part of the whole"};
        run.judge_slow(run.tolerances.error * whole, row);
        rows.push_back(row);
      };
      add(error_part::bearings, column::error_of_bearings);
      add(error_part::shaft_bending, column::error_of_shaft_bending);
    }
  } // namespace

  void add_supports(const PairRun &run, const ComparedCase &loaded, ComparisonRows &rows)
  {
    if (run.has(bearing_file) && loaded.has(bearing_file))
      add_forces(run, loaded, rows);
    if (!run.has(misalignment_file) || !loaded.has(misalignment_file))
      return;
    add_misalignment(run, loaded, rows);
    add_parts(run, loaded, rows);
  }
} // namespace vfife
