// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_dynamic_run_h
#define vfife_study_run_dynamic_run_h

#include <vfife/base/process/timers.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/output_options.h>
#include <vfife/study/cases/gear_case.h>
#include <vfife/study/run/deflection_parts.h>
#include <vfife/study/study_kind.h>

#include <optional>

namespace vfife
{
  class ExplicitSolver;
  class OutputFolder;
  class Table;

  /** Study kind `run`: explicit dynamics of a gear pair from the start to the last tooth mesh, with
   * all results. */
  class DynamicRun : public StudyKind
  {
  public:
    void        declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void        check() const override;
    void        inspect(Communicator &communicator, Log &log) override;
    std::size_t go_on(const std::string  &folder,
                      const EntryValues  &now,
                      const Communicator &communicator,
                      Log                &log) override;
    void        run(OutputFolder &folder, Log &log) override;

  private:
    /** What the equilibrium before the start tells. */
    struct Preload
    {
      DeflectionParts parts;
      Swing           swing;
      double          penalty_lag = 0; ///< [rad]
    };

    void         log_step(const Model &model, ExplicitSolver &solver, double dt, Log &log) const;
    double       expect_run_time(ExplicitSolver &solver, const State &state, double dt) const;
    void         report_contradictions(const Model              &model,
                                       ExplicitSolver           &solver,
                                       double                    dt,
                                       double                    run_time,
                                       std::vector<std::string> &found,
                                       Log                      &log) const;
    Preload      preload(const Model        &model,
                         ExplicitSolver     &solver,
                         State              &state,
                         const Communicator &communicator,
                         Log                &log) const;
    void         log_preload(const Model &model, const Preload &preload, Log &log) const;
    NamedFigures list_figures(const Model &model, ExplicitSolver &solver) const;
    void         add_preload(const Preload &preload, RunSummary &summary) const;
    void         complete_summary(const Model   &model,
                                  const Table   &history,
                                  const Preload &preload,
                                  RunSummary    &summary,
                                  Log           &log) const;

    GearCase        gear_case_;
    DynamicsOptions dynamics_;
    OutputOptions   output_;

    std::optional<Checkpoint> checkpoint_;
  };
} // namespace vfife

#endif
