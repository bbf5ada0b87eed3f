// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_sweep_sweep_tables_h
#define vfife_study_sweep_sweep_tables_h

#include <vfife/base/text/json.h>
#include <vfife/study/case_runner.h>
#include <vfife/study/sweep/history_figure.h>
#include <vfife/study/sweep/sweep_runs.h>

#include <string>
#include <vector>

namespace vfife
{
  class Log;
  class OutputFolder;

  /** What a sweep writes of its runs: the key figures of all (sweep.csv, sweep.json), and with
   * numerical parameters their errors (error_bars.csv, differences.csv). */
  struct SweepTables
  {
    const std::string                &base; ///< parameter file of the case
    const SweepRuns                  &runs;
    const std::vector<HistoryFigure> &figures; ///< further columns

    /** Throws InputError where columns would have equal names, and for wrong figures. */
    void check() const;
    /** Writes anew what is known now; @p reports: of all runs. */
    void write(const OutputFolder &folder, const std::vector<CaseReport> &reports, Log &log) const;

  private:
    /** The key figures of each run; as many and with the same names for all. */
    std::vector<NamedFigures> read_figures(const OutputFolder            &folder,
                                           const std::vector<CaseReport> &reports,
                                           Log                           &log) const;
    /** error_bars.csv and differences.csv; what they have as JSON. */
    Json write_errors(const OutputFolder              &folder,
                      const std::vector<CaseReport>   &reports,
                      const std::vector<NamedFigures> &all) const;
  };

  /** sweep.csv without rows: the values of parameters, and figures of the runs. */
  Table make_sweep_table(const std::vector<std::string> &parameters, const NamedFigures &figures);
} // namespace vfife

#endif
