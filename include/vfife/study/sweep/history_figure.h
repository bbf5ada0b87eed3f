// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_sweep_history_figure_h
#define vfife_study_sweep_history_figure_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/output/files/figures.h>

#include <string>
#include <vector>

namespace vfife
{
  class Table;

  /** What is taken of a column of a history. */
  enum class FigureValue
  {
    last,
    first,
    mean,
    largest,
    smallest,
    where_largest,         ///< time or speed of the row with the largest value
    largest_size,          ///< of the absolute values
    peak_to_peak,          ///< largest less smallest
    periodic_peak_to_peak, ///< of the mean mesh cycle
    periodic_share,        ///< part of the variance that repeats with the mesh cycle [-]
    trend,                 ///< slope of the meshes' means by least squares [per mesh cycle]
    change,                ///< last over first, minus one [-]
    mean_above_half,   ///< mean over the time in which the column is above half its largest value
    time_above_half,   ///< that time, its ends interpolated [s]
    zero_crossing_rate ///< half the crossings between the first and the last one a second [Hz]
  };

  const Choices<FigureValue> &figure_value_choices();

  /** Where the column is. */
  enum class FigureTable
  {
    history,        ///< history.csv
    teeth,          ///< teeth.csv: rows of several tooth pairs at a time
    probe_waves,    ///< probe_waves.csv: rows of several probes at a time
    fillet_waves,   ///< fillet_waves.csv: rows of several facets at a time
    resonance,      ///< resonance.csv: rows over speed
    wave_response,  ///< wave_response.csv: rows over speed
    stress_response ///< stress_response.csv: rows of several places at a speed
  };

  /** A number of a history, with its unit also where it is not known. */
  struct FoundFigure : Figure
  {
    std::string fault; ///< why the number is not known; empty where it is
  };

  /** A number that is taken of the history of a run, or of its response over speed, and what it
   * should be. */
  struct HistoryFigure
  {
    std::string name;
    FigureTable table = FigureTable::history;
    std::string column;
    FigureValue value = FigureValue::last;
    double      from  = 0; ///< samples from this time on [s], of tables over time
    std::string reference; ///< number in the figure's unit; empty: not known

    void declare(dealii::ParameterHandler &prm);

    /** Throws InputError with the name of @p section and the entry. */
    void check(const std::string &section) const;

    /** Name of the table's file. */
    std::string file() const;

    /** Whether its rows are of speeds, not of times. */
    bool is_over_speed() const;

    /**
     * The number with its unit, of the file's table.
     * @throws InputError where it has no such column, with the nearest name.
     */
    FoundFigure compute(const Table &history) const;

    /** (value - reference)/reference, or the value where the reference is 0; NaN without one. */
    double compute_error(double value) const;

    /** The unit of compute_error(): none, but that of the value where the reference is 0. */
    std::string error_unit(const std::string &unit) const;
  };

  /**
   * Order of convergence from one run to the next, log(|error before/error|) over
   * |log(value/value before)| of the parameters that differ; NaN unless these are numbers in one
   * common ratio, each with its unit or none of them with one.
   */
  double compute_order(double                          error_before,
                       double                          error,
                       const std::vector<std::string> &values_before,
                       const std::vector<std::string> &values);
} // namespace vfife

#endif
