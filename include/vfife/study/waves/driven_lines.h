// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_driven_lines_h
#define vfife_study_waves_driven_lines_h

#include <vfife/base/text/table.h>
#include <vfife/study/waves/wave_record.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  class LineTheory;
  class Log;
  class OutputFolder;
  class StressWavePlaces;
  class WaveDriver;
  struct WaveLine;
  struct WavesOptions;

  /** What drives waves: its word in the tables, and what it does at one speed; @p name is of a
   * folder and no other's. */
  struct NamedSolver
  {
    std::string name;
    std::function<WaveMotion(const WaveMeeting &, const WaveSchedule &, const std::string &name)>
      drive;
  };

  /** Lines that are driven at and around their speeds, and what is written of them. */
  class DrivenLines
  {
  public:
    /** All must outlive the object. @p driver: whose gains are those of the rim. */
    DrivenLines(const WavesOptions     &options,
                const LineTheory       &theory,
                const StressWavePlaces &places,
                const WaveDriver       &driver,
                const OutputFolder     &folder,
                Log                    &log);

    /** Drives the line, whose number is @p number, by all solvers, and writes the tables of all
     * lines so far. @p schedule: of a speed of the driver. */
    void drive(unsigned int                                     number,
               const std::vector<NamedSolver>                  &solvers,
               const std::function<WaveSchedule(double speed)> &schedule,
               WaveLine                                        &line);

    /** Writes speeds_to_avoid.csv. */
    void finish(const std::vector<WaveLine> &lines) const;

  private:
    const WavesOptions     &options_;
    const LineTheory       &theory_;
    const StressWavePlaces &places_;
    const WaveDriver       &driver_;
    const OutputFolder     &folder_;
    Log                    &log_;
    Table                   motions_, growth_, stresses_;
  };
} // namespace vfife

#endif
