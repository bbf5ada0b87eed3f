// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_tooth_contact_study_h
#define vfife_study_gear_tooth_contact_study_h

#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/study/study_kind.h>

namespace vfife
{
  /**
   * Study kind `tooth contact analysis`: unloaded contact of both sides of a gear pair; writes
   * tca.csv, path.csv and tca.json.
   */
  class ToothContactStudy : public StudyKind
  {
  public:
    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void check() const override;
    void inspect(Communicator &communicator, Log &log) override;
    void run(OutputFolder &folder, Log &log) override;

    std::string last_file() const override;

  private:
    GearPairOptions        pair_;
    ContactAnalysisOptions options_;
  };
} // namespace vfife

#endif
