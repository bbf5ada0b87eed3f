// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_model_run_h
#define vfife_study_run_model_run_h

#include <vfife/dynamics/dynamics_options.h>
#include <vfife/model/observer.h>
#include <vfife/model/options/model_options.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/output_options.h>
#include <vfife/study/study_kind.h>

#include <optional>

namespace vfife
{
  class ExplicitSolver;

  /** What the studies of general models (section Model) share: options, observers, summary. */
  class ModelStudy : public StudyKind
  {
  public:
    ModelStudy();

    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void check() const override;

  protected:
    void      log_model(const Model &model, Log &log) const;
    void      log_step(ExplicitSolver &solver, double dt, Log &log) const;
    Observers make_observers(const OutputFolder &folder,
                             const Model        &model,
                             std::uint64_t       history_steps,
                             std::uint64_t       field_steps) const;

    ModelOptions    model_;
    DynamicsOptions dynamics_;
    OutputOptions   output_;
  };

  /** Study kind `run` of a general model: explicit dynamics from time zero to Dynamics/end time. */
  class ModelRun : public ModelStudy
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
    /** Step that divides the run into whole steps, at most @p stable_step [s]. */
    double choose_step(double stable_step) const;

    double                    end_time_ = 0; ///< [s]
    std::optional<Checkpoint> checkpoint_;
  };

  /**
   * Study kind `static`: equilibrium of a general model by dynamic relaxation, load step by load
   * step. Bodies with a speed are in equilibrium with their centrifugal force. A row of the
   * histories a load step; its time is the part of the loads.
   */
  class StaticRun : public ModelStudy
  {
  public:
    void inspect(Communicator &communicator, Log &log) override;
    void run(OutputFolder &folder, Log &log) override;
  };
} // namespace vfife

#endif
