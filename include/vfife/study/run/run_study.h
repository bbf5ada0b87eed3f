// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_run_study_h
#define vfife_study_run_run_study_h

#include <vfife/dynamics/dynamics_options.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/output_options.h>
#include <vfife/study/study_kind.h>

#include <memory>
#include <optional>

namespace vfife
{
  class Case;
  struct Model;
  struct SteppedSolver;

  /** Study kind `run`: explicit dynamics of a gear pair or a general model from the start to the
   * end, with all results. */
  class RunStudy : public StudyKind
  {
  public:
    RunStudy();
    ~RunStudy() override;

    void        declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void        check() const override;
    void        inspect(Communicator &communicator, Log &log) override;
    std::size_t resume(const std::string  &folder,
                       const EntryValues  &now,
                       const Communicator &communicator,
                       Log                &log) override;
    void        run(OutputFolder &folder, Log &log) override;

  private:
    Model                    make_model(Log &log) const;
    double                   choose_step(double stable_step) const;
    std::vector<std::string> report_contradictions(const Model   &model,
                                                   SteppedSolver &stepped,
                                                   double         run_time,
                                                   Log           &log) const;

    std::unique_ptr<Case>     case_;
    DynamicsOptions           dynamics_;
    OutputOptions             output_;
    std::optional<Checkpoint> checkpoint_;
  };
} // namespace vfife

#endif
