// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_wave_line_tables_h
#define vfife_study_waves_wave_line_tables_h

#include <vfife/base/text/table.h>
#include <vfife/output/files/figures.h>
#include <vfife/study/waves/wave_line.h>

#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  class Log;

  /** waves_lines.csv: a row a line and solver. Numbers of a line that was not driven are no
   * numbers. */
  Table make_wave_line_table();
  void  add_wave_lines(const WaveLine &line, Table &table);

  /** waves_frequencies.csv: a row a wave and speed of the driver [rad/s], @p rate of the driven
   * body [rad/s]; @p in_contact: as an observer at rest sees it there [rad/s]. */
  Table make_wave_frequency_table();
  void  add_wave_frequency(
     const BodyWave &wave, double speed, double rate, double in_contact, Table &table);

  /** waves_response.csv: a row a speed of a line and solver. */
  Table make_wave_motion_table();
  void  add_wave_motions(const WaveLine &line, Table &table);

  /** waves_build_up.csv: a row per mesh cycle and solver at the speed nearest to each line. */
  Table make_build_up_table();
  void  add_build_up(const WaveLine &line, Table &table);

  /** waves_stress.csv: a row a speed, solver and place, StressWavePlaces::names(). */
  Table make_wave_stress_table();
  void
  add_wave_stresses(const WaveLine &line, const std::vector<std::string> &places, Table &table);

  /** speeds_to_avoid.csv: ranges of the driver's speed with margins, ascending; those that touch
   * are one. @p margin: over the speed. */
  Table make_avoided_speed_table(const std::vector<WaveLine> &lines, double allowed, double margin);

  /** For tables of cases: the speeds of the lines in contact, and how far from the speed of
   * operation, over it, the @p nearest resonance is. */
  NamedFigures list_line_figures(const std::vector<WaveLine>      &lines,
                                 const std::optional<NearestWave> &nearest);

  /** Says what is predicted of a line. */
  void log_wave_line(const WaveLine &line, Log &log);
  /** Says what its driven pairs have shown. */
  void log_wave_response(const WaveLine &line, const WaveResponse &response, Log &log);
} // namespace vfife

#endif
