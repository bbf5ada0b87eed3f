// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_linear_static_study_h
#define vfife_study_conventional_linear_static_study_h

#include <vfife/dynamics/dynamics_options.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/output/output_options.h>
#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  class Case;

  /** Section Linear static. */
  struct LinearStaticOptions
  {
    bool   at_time          = false; ///< loads as their histories say, else in full
    double time             = 0;     ///< [s]
    bool   centrifugal      = true;  ///< on bodies that turn
    bool   spin_softening   = true;
    bool   stress_stiffness = true;

    /** Declares the section. */
    void declare(dealii::ParameterHandler &prm);
    /** Throws InputError when entries contradict each other. */
    void check() const;

    StaticLoads loads() const;
  };

  /**
   * Study kind `linear static`: small displacements of a general model, or of the members of a
   * gear pair in their turning axes without contact and torque, by conventional finite elements.
   * The file is that of a run: section Dynamics is read and not used.
   */
  class LinearStaticStudy : public StudyKind
  {
  public:
    LinearStaticStudy();
    ~LinearStaticStudy() override;

    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void check() const override;
    void inspect(Communicator &communicator, Log &log) override;
    void run(OutputFolder &folder, Log &log) override;

  private:
    Model make_model(Log &log) const;
    void  refuse_what_is_not_linear(const Model &model) const;
    void  write_probes(const OutputFolder        &folder,
                       const Model               &model,
                       const Discretization      &discretization,
                       const StaticResult        &result,
                       const std::vector<Stress> &stresses) const;

    std::unique_ptr<Case> case_;
    DynamicsOptions       dynamics_;
    OutputOptions         output_;
    FemOptions            fem_;
    LinearStaticOptions   options_;
  };
} // namespace vfife

#endif
