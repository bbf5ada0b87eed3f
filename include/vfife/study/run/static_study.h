// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_static_study_h
#define vfife_study_run_static_study_h

#include <vfife/dynamics/dynamics_options.h>
#include <vfife/model/observer.h>
#include <vfife/output/output_options.h>
#include <vfife/study/cases/model_case.h>
#include <vfife/study/study_kind.h>

namespace vfife
{
  /**
   * Study kind `static`: equilibrium of a general model by dynamic relaxation, load step by load
   * step. Bodies with a speed are in equilibrium with their centrifugal force. A row of the
   * histories a load step; its time is the part of the loads.
   */
  class StaticStudy : public StudyKind
  {
  public:
    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void check() const override;
    void inspect(Communicator &communicator, Log &log) override;
    void run(OutputFolder &folder, Log &log) override;

  private:
    Model     make_model(Log &log) const;
    Observers make_observers(const OutputFolder &folder, const Model &model) const;

    ModelCase       case_;
    DynamicsOptions dynamics_;
    OutputOptions   output_;
  };
} // namespace vfife

#endif
