// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/stress_waves/stress_wave_places.h>
#include <vfife/study/waves/driven_lines.h>
#include <vfife/study/waves/driven_wave.h>
#include <vfife/study/waves/line_theory.h>
#include <vfife/study/waves/wave_line_tables.h>
#include <vfife/study/waves/waves_options.h>

namespace vfife
{
  DrivenLines::DrivenLines(const WavesOptions     &options,
                           const LineTheory       &theory,
                           const StressWavePlaces &places,
                           const WaveDriver       &driver,
                           const OutputFolder     &folder,
                           Log                    &log)
    : options_(options)
    , theory_(theory)
    , places_(places)
    , driver_(driver)
    , folder_(folder)
    , log_(log)
    , motions_(make_wave_motion_table())
    , growth_(make_build_up_table())
    , stresses_(make_wave_stress_table())
  {
  }

  void DrivenLines::drive(const unsigned int                               number,
                          const std::vector<NamedSolver>                  &solvers,
                          const std::function<WaveSchedule(double speed)> &schedule,
                          WaveLine                                        &line)
  {
    for (const NamedSolver &solver : solvers)
      {
        std::vector<WaveMotion>           found;
        std::vector<std::complex<double>> expected;
        for (const double part : options_.offset_parts())
          {
            const double      speed = line.linear_curve.peak * (1. + part);
            const std::string name =
              "line_" + std::to_string(number) + "_speed_" + std::to_string(found.size() + 1);
            found.push_back(solver.drive(line.meeting, schedule(speed), name));
            expected.push_back(theory_.amplitude(line, speed));
          }
        line.responses.push_back(evaluate_wave(line,
                                               solver.name,
                                               std::move(found),
                                               std::move(expected),
                                               driver_.rim_gains(line.meeting.wave.diameters)));
        line.responses.back().n_probes = places_.n_probes();
        log_wave_response(line, line.responses.back(), log_);
      }
    add_wave_motions(line, motions_);
    add_build_up(line, growth_);
    add_wave_stresses(line, places_.names(), stresses_);
    write_csv(folder_, "waves_response.csv", motions_);
    write_csv(folder_, "waves_build_up.csv", growth_);
    write_csv(folder_, "waves_stress.csv", stresses_);
  }

  void DrivenLines::finish(const std::vector<WaveLine> &lines) const
  {
    write_csv(folder_,
              "speeds_to_avoid.csv",
              make_avoided_speed_table(lines, options_.allowed_amplification, options_.margin));
  }
} // namespace vfife
