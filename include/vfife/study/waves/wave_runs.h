// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_wave_runs_h
#define vfife_study_waves_wave_runs_h

#include <vfife/base/process/command_line.h>
#include <vfife/study/waves/wave_record.h>

#include <string>

namespace vfife
{
  class CaseRunner;
  class Log;
  class OutputFolder;
  class StressWavePlaces;
  struct Model;

  /** Drives waves of a pair's driven body by explicit runs of whole bodies, each in a folder of its
   * own. */
  class WaveRuns
  {
  public:
    /** @p study: the study's own file and overrides. With @p resumes finished runs with the same
     * entries are read as they are, and others go on from their checkpoints. All but @p study must
     * outlive the object. */
    WaveRuns(const CaseRunner       &runner,
             CommandLine             study,
             const Model            &model,
             const StressWavePlaces &places,
             const OutputFolder     &folder,
             Log                    &log,
             bool                    resumes);

    /** The run of a study's file at a speed of the driver [rad/s] that measures stress waves of @p
     * diameters, also those of @p fillets. */
    static CommandLine command_line(
      CommandLine study, double speed, unsigned int n_meshes, unsigned int diameters, bool fillets);

    /** Does the run in the subfolder @p name, says so, and reads it; without WaveMotion::force.
     * Throws NumericalError where it has failed, Interrupted. Collective. */
    WaveMotion
    drive(const WaveMeeting &meeting, const WaveSchedule &schedule, const std::string &name) const;

  private:
    WaveMotion
    read(const WaveMeeting &meeting, const WaveSchedule &schedule, const std::string &path) const;
    /** Adds the stresses; @p turned: WaveRecord::turned() of all samples behind the start. */
    void read_stresses(const std::string                       &path,
                       const WaveSchedule                      &schedule,
                       const std::vector<std::complex<double>> &turned,
                       WaveMotion                              &motion) const;

    const CaseRunner       &runner_;
    CommandLine             study_;
    const Model            &model_;
    const StressWavePlaces &places_;
    const OutputFolder     &folder_;
    Log                    &log_;
    bool                    resumes_;
  };
} // namespace vfife

#endif
