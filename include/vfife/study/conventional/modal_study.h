// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_modal_study_h
#define vfife_study_conventional_modal_study_h

#include <vfife/fem/fem_options.h>
#include <vfife/fem/modes/campbell.h>
#include <vfife/study/study_kind.h>

#include <memory>

namespace vfife
{
  class Case;
  struct Model;

  /** Study kind `modal`: natural vibrations of the bodies of a gear pair or a general model, each
   * for itself, at rest and at speed. */
  class ModalStudy : public StudyKind
  {
  public:
    ModalStudy();
    ~ModalStudy() override;

    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void check() const override;
    void inspect(Communicator &communicator, Log &log) override;
    void run(OutputFolder &folder, Log &log) override;

    std::string last_file() const override;

  private:
    void solve_body(const Model &model, unsigned int body, const OutputFolder &folder, Log &log);

    std::unique_ptr<Case> case_;
    FemOptions            fem_;
    Table                 modes_      = make_mode_table();
    Table                 campbell_   = make_campbell_table();
    Table                 resonances_ = make_resonance_table();
  };
} // namespace vfife

#endif
