// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_lumped_study_h
#define vfife_study_gear_lumped_study_h

#include <vfife/lumped/lumped_options.h>
#include <vfife/lumped/speed_sweep.h>
#include <vfife/output/files/figures.h>
#include <vfife/study/cases/gear_case.h>
#include <vfife/study/study_kind.h>

namespace vfife
{
  /**
   * Study kind `lumped`: a gear pair of few degrees of freedom (doc/lumped.md), by values or with
   * inertias and geometry of a section Gear pair; writes lumped.csv, resonance.csv, lumped.json.
   */
  class LumpedStudy : public StudyKind
  {
  public:
    void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void check() const override;
    void inspect(Communicator &communicator, Log &log) override;
    void run(OutputFolder &folder, Log &log) override;

    std::string last_file() const override;

  private:
    const OperationOptions &operation() const;
    /** Fills what the options leave open from the gear pair. */
    LumpedPair make_pair(Log &log) const;

    bool              has_pair_ = false;
    GearCase          gear_case_;
    OperationOptions  operation_; ///< without a gear pair
    LumpedOptions     options_;
    LumpedRunOptions  run_;
    SpeedSweepOptions sweep_;
    bool              pictures_ = true;
  };
} // namespace vfife

#endif
