// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_model_case_h
#define vfife_study_cases_model_case_h

#include <vfife/model/options/model_options.h>
#include <vfife/study/cases/case.h>

namespace vfife
{
  /** A general model, from the section Model. */
  class ModelCase : public Case
  {
  public:
    void   declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void   check() const override;
    Model  make_model(Log &log) const override;
    void   set_defaults(DynamicsOptions &dynamics, OutputOptions &output) const override;
    void   declare_run(dealii::ParameterHandler &prm) override;
    void   check_run(const DynamicsOptions &dynamics) const override;
    double end_time() const override;
    double choose_step(double stable_step, unsigned int samples) const override;
    std::vector<std::string> report_checks(const RunPlan &plan, Log &log) const override;

    /** The part of check_run() that concerns any explicit solution, also at rest. */
    void check_dynamics(const DynamicsOptions &dynamics) const;

  private:
    ModelOptions options_;
    double       end_time_ = 0; ///< [s]
  };
} // namespace vfife

#endif
