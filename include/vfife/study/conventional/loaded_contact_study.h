// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_contact_study_h
#define vfife_study_conventional_loaded_contact_study_h

#include <vfife/base/text/table.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/element/stress.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/pair/coupled_modes.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/output/output_options.h>
#include <vfife/study/cases/gear_case.h>
#include <vfife/study/study_kind.h>

namespace vfife
{
  /** Section Loaded contact. */
  struct LoadedContactOptions
  {
    unsigned int positions     = 8;    ///< over one tooth mesh, from the reference position on
    bool         centrifugal   = true; ///< both bodies spin
    unsigned int coupled_modes = 0;    ///< of the pair in contact at the first position

    void declare(dealii::ParameterHandler &prm);
  };

  /**
   * Study kind `loaded tooth contact analysis`: static equilibrium of the loaded pair by
   * conventional finite elements at positions over one tooth mesh, with the penalties of a run of
   * the same file.
   */
  class LoadedContactStudy : public StudyKind
  {
  public:
    LoadedContactStudy();

    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void check() const override;
    void inspect(Communicator &communicator, Log &log) override;
    void run(OutputFolder &folder, Log &log) override;

    std::string last_file() const override;

  private:
    std::vector<double>
         find_penalties(const Model &model, const Communicator &communicator, Log &log) const;
    void add_position(const Model                 &model,
                      const Compliance            &compliance,
                      double                       position,
                      const PairEquilibriumResult &result,
                      const std::vector<Stress>   &stresses,
                      Log                         &log);

    void find_modes(const Model                 &model,
                    const Compliance            &compliance,
                    const PairEquilibriumResult &result,
                    const OutputFolder          &folder,
                    Log                         &log) const;

    GearCase             gear_case_;
    DynamicsOptions      dynamics_;
    OutputOptions        output_;
    FemOptions           fem_;
    LoadedContactOptions options_;
    Table                positions_, teeth_;
  };
} // namespace vfife

#endif
