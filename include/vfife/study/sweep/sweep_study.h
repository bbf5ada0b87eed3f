// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_sweep_sweep_study_h
#define vfife_study_sweep_sweep_study_h

#include <vfife/study/case_runner.h>
#include <vfife/study/study_kind.h>
#include <vfife/study/sweep/history_figure.h>
#include <vfife/study/sweep/sweep_runs.h>
#include <vfife/study/sweep/sweep_tables.h>

#include <string>
#include <vector>

namespace vfife
{
  struct CommandLine;

  /**
   * Study kind `sweep`: the base case once for every value of some of its entries, or for every
   * combination of values. Each run has a folder of its own, run_01 and so on, in that of the
   * sweep; sweep.csv and sweep.json have the key figures of all, and those that `figures` take of
   * the histories, with errors and orders of convergence where references are known.
   *
   * Tables of folders that `reference folders` names are copied into the sweep's folder, for the
   * report: the coupled modes of a loaded tooth contact analysis, the sweep of speeds of a lumped
   * model.
   *
   * Parameters that `numerical parameters` names are numerical: they are not combined with others
   * but varied one by one, and figures get errors by them (error_bars.h).
   *
   * The ranks are dealt to groups of `ranks per run`, which do runs at the same time. A run that
   * fails stops no other. With --restart finished runs of the same parameters are kept, and others
   * go on from their checkpoints.
   */
  class SweepStudy : public StudyKind
  {
  public:
    explicit SweepStudy(const CaseRunner &runner);

    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    /** Reads the base case with the entries of every run. */
    void        check() const override;
    void        inspect(Communicator &communicator, Log &log) override;
    std::size_t resume(const std::string     &folder,
                       const DeclaredSection &now,
                       const Communicator    &communicator,
                       Log                   &log) override;
    void        run(OutputFolder &folder, Log &log) override;

  private:
    void         declare_own(dealii::ParameterHandler &prm);
    CommandLine  command_line(const SweepRuns::Values &values) const;
    unsigned int count_groups(const Communicator &communicator) const;
    /** Refers to this study. */
    SweepTables tables() const
    {
      return {base_, runs_, figures_};
    }
    void copy_beside(const OutputFolder &folder) const;

    const CaseRunner          &runner_;
    bool                       restart_ = false;
    std::string                base_, entries_;
    std::vector<std::string>   figure_names_, beside_;
    SweepRuns                  runs_;
    std::vector<HistoryFigure> figures_;
    unsigned int               ranks_per_run_ = 0;
    bool                       pictures_      = true;
  };
} // namespace vfife

#endif
