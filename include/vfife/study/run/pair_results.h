// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_pair_results_h
#define vfife_study_run_pair_results_h

#include <vfife/contact/law/hertz.h>
#include <vfife/output/files/summary.h>

#include <cstdint>

namespace vfife
{
  class ExplicitSolver;
  class Log;
  class Stepping;
  class Table;
  struct Model;
  struct OutputOptions;
  struct PairPreload;

  /** What a run of a gear pair writes and tells beyond a run of any model. */
  class PairResults
  {
  public:
    /** Adds the writers of the pair to @p stepping; @p history_steps from sample to sample, the run
     * ends at @p end_time [s]. Everything given must outlive the object. */
    PairResults(const Model         &model,
                const HertzContact  &hertz,
                const OutputOptions &output,
                std::uint64_t        history_steps,
                double               end_time,
                Stepping            &stepping);

    /** What is known before the first step: speeds, torque, penalty. */
    NamedFigures list_figures(ExplicitSolver &solver) const;

    /** Says what Hertz expects of one tooth pair under all the torque. */
    void log_hertz(Log &log) const;

    /** Adds to the summary of a run that has ended, or failed, what follows from its @p history. */
    void
    complete(const Table &history, const PairPreload &preload, RunSummary &summary, Log &log) const;

    /** Rows of probes.csv. */
    const Table &probe_rows() const
    {
      return *probes_;
    }

  private:
    void find_steady(const Table       &history,
                     const PairPreload &preload,
                     RunSummary        &summary,
                     Log               &log) const;
    void add_contact(const PairPreload &preload, std::size_t n_samples, RunSummary &summary) const;

    const Model         &model_;
    HertzContact         hertz_;
    const OutputOptions &output_;
    const Table         *teeth_  = nullptr; ///< rows of teeth.csv
    const Table         *probes_ = nullptr;
  };
} // namespace vfife

#endif
