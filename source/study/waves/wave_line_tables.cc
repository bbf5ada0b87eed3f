// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/types.h>
#include <vfife/output/files/result_places.h>
#include <vfife/study/waves/wave_line_tables.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    constexpr double rpm = 30. / pi; // of 1 rad/s
    /** The columns that say which line a row is of. */
    Table make_table_of_lines()
    {
      return {{"wave"}, {"nodal diameter", "-"}, {"order", "-"}, {"mesh order", "-"}, {"solver"}};
    }

    /** Of a wave with diameters. */
    const char *direction_of(const BodyWave &wave)
    {
      return wave.diameters == 0 ? "-" : name_of(wave.direction);
    }

    std::vector<Table::Cell> start_row(const WaveLine &line, const std::string &solver)
    {
      const BodyWave &wave = line.meeting.wave;
      return {direction_of(wave), wave.diameters, wave.order, line.meeting.mesh_order, solver};
    }
  } // namespace

  Table make_wave_line_table()
  {
    Table table = make_table_of_lines();
    table.add_column(column::speed, "rpm");
    table.add_column(column::frequency, "Hz");
    table.add_column("stiffening", "-");
    table.add_column(column::damping_ratio, "-");
    table.add_column("speed in contact", "rpm");
    table.add_column(column::mesh_frequency, "Hz");
    table.add_column("predicted width", "-");
    table.add_column("predicted amplitude", "um");
    table.add_column("peak speed", "rpm");
    table.add_column("width", "-");
    table.add_column("amplitude", "um");
    table.add_column("misfit", "-");
    table.add_column("damping ratio of the width", "-");
    table.add_column("damping ratio of the build-up", "-");
    table.add_column("amplitude by the forces", "um");
    table.add_column("stress amplification", "-");
    table.add_column("web amplification", "-");
    table.add_column("root amplification", "-");
    table.add_column("resonances", "-");
    table.add_column("predicted amplitude by the fit", "um");
    table.add_column("width of one resonance", "-");
    table.add_column("predicted width of one resonance", "-");
    return table;
  }

  void add_wave_lines(const WaveLine &line, Table &table)
  {
    const double frequency = line.meeting.wave.frequency();
    const auto   predicted = [&](const std::string &solver) {
      std::vector<Table::Cell> row = start_row(line, solver);
      for (const double value : {line.speed * rpm,
                                 frequency / (2. * pi),
                                 line.meeting.stiffening,
                                 line.damping_ratio(),
                                 line.linear_curve.peak * rpm,
                                 line.mesh_frequency(),
                                 line.linear_curve.width / line.linear_curve.peak,
                                 line.linear_curve.amplitude})
        row.emplace_back(value);
      return row;
    };
    for (const WaveResponse &found : line.responses)
      {
        std::vector<Table::Cell> row   = predicted(found.solver);
        const double             width = found.curve.width / found.curve.peak;
        for (const double value : {found.curve.peak * rpm,
                                   width,
                                   found.curve.amplitude,
                                   found.curve.residual,
                                   .5 * width * (1. - line.meeting.stiffening),
                                   found.build_up.decay / frequency,
                                   found.forced_peak,
                                   found.amplification(),
                                   found.web_amplification(),
                                   found.root_amplification(),
                                   1. + found.curve.others.size(),
                                   found.linear_fit.amplitude,
                                   found.single.width / found.single.peak,
                                   found.linear_single.width / found.linear_single.peak})
          row.emplace_back(value);
        table.add_row(row);
      }
    if (!line.responses.empty())
      return;
    std::vector<Table::Cell> row = predicted("none");
    row.insert(row.end(), 14, not_known);
    table.add_row(row);
  }

  NamedFigures list_line_figures(const std::vector<WaveLine>      &lines,
                                 const std::optional<NearestWave> &nearest)
  {
    NamedFigures figures;
    for (const WaveLine &line : lines)
      figures.push_back({"speed of the " + line.name(), {line.linear_curve.peak * rpm, "rpm"}});
    if (nearest)
      figures.push_back({figure_name::nearest_wave_distance, {100. * nearest->distance, "%"}});
    return figures;
  }

  Table make_wave_frequency_table()
  {
    return {{"wave"},
            {"nodal diameter", "-"},
            {"order", "-"},
            {column::speed, "rpm"},
            {column::frequency, "Hz"},
            {"fixed frequency", "Hz"},
            {"fixed frequency in contact", "Hz"}};
  }

  void add_wave_frequency(const BodyWave &wave,
                          const double    speed,
                          const double    rate,
                          const double    in_contact,
                          Table          &table)
  {
    // What meets the wave at a place that stands in space: crests pass it faster or slower by the
    // turn of the body.
    const double turn = wave.diameters * std::abs(rate);
    const double fixed =
      wave.direction == WaveDirection::forward ? wave.frequency() + turn : wave.frequency() - turn;
    table.add_row({direction_of(wave),
                   wave.diameters,
                   wave.order,
                   speed * rpm,
                   wave.frequency() / (2. * pi),
                   fixed / (2. * pi),
                   in_contact / (2. * pi)});
  }

  Table make_wave_motion_table()
  {
    Table table = make_table_of_lines();
    table.add_column(column::speed, "rpm");
    table.add_column("amplitude", "um");
    table.add_column("phase", "deg");
    table.add_column("fitted amplitude", "um");
    table.add_column("linear amplitude", "um");
    table.add_column("travelling wave", "um");
    table.add_column(column::peak_to_peak_dte, "arcsec");
    table.add_column(column::largest_force, "N");
    table.add_column(column::energy_error, "-");
    return table;
  }

  void add_wave_motions(const WaveLine &line, Table &table)
  {
    for (const WaveResponse &response : line.responses)
      for (std::size_t k = 0; k < response.motions.size(); ++k)
        {
          const WaveMotion        &motion = response.motions[k];
          std::vector<Table::Cell> row    = start_row(line, response.solver);
          for (const double value : {motion.speed * rpm,
                                     std::abs(motion.amplitude),
                                     std::arg(motion.amplitude) * 180. / pi,
                                     std::abs(response.curve.value(motion.speed)),
                                     std::abs(response.linear[k]),
                                     motion.running,
                                     motion.pp_error / arcsecond,
                                     motion.largest_force,
                                     motion.energy_error})
            row.emplace_back(value);
          table.add_row(row);
        }
  }

  Table make_build_up_table()
  {
    Table table = make_table_of_lines();
    table.add_column(column::speed, "rpm");
    table.add_column(column::time, "s");
    table.add_column("amplitude", "um");
    table.add_column("fitted amplitude", "um");
    return table;
  }

  void add_build_up(const WaveLine &line, Table &table)
  {
    for (const WaveResponse &found : line.responses)
      {
        const WaveMotion &motion = found.nearest(line.linear_curve.peak);
        for (std::size_t m = 0; m < motion.meshes.size(); ++m)
          {
            std::vector<Table::Cell> row   = start_row(line, found.solver);
            const double             since = m * motion.mesh_time;
            row.emplace_back(motion.speed * rpm);
            row.emplace_back(since + .5 * motion.mesh_time);
            row.emplace_back(std::abs(motion.meshes[m]));
            row.emplace_back(std::abs(found.build_up.value(since)));
            table.add_row(row);
          }
      }
  }

  Table make_wave_stress_table()
  {
    Table table = make_table_of_lines();
    table.add_column(column::speed, "rpm");
    table.add_text_column(column::probe);
    table.add_column("stress without waves", "MPa");
    table.add_column("stress of the wave", "MPa");
    table.add_column("stress amplification", "-");
    return table;
  }

  void add_wave_stresses(const WaveLine &line, const std::vector<std::string> &places, Table &table)
  {
    for (const WaveResponse &response : line.responses)
      for (const WaveMotion &motion : response.motions)
        for (std::size_t p = 0; p < places.size(); ++p)
          {
            std::vector<Table::Cell> row = start_row(line, response.solver);
            row.emplace_back(motion.speed * rpm);
            row.emplace_back(places[p]);
            row.emplace_back(motion.static_stress[p]);
            row.emplace_back(motion.wave_stress[p]);
            row.emplace_back(1. + motion.wave_stress[p] / motion.static_stress[p]);
            table.add_row(row);
          }
  }

  Table make_avoided_speed_table(const std::vector<WaveLine> &lines,
                                 const double                 allowed,
                                 const double                 margin)
  {
    struct Range
    {
      double      from, to, amplification;
      std::string waves;
    };
    std::vector<Range> ranges;
    for (const WaveLine &line : lines)
      if (const auto found = line.find_range_to_avoid(allowed))
        ranges.push_back({found->first * (1. - margin),
                          found->second * (1. + margin),
                          line.responses.front().amplification(),
                          line.name()});
    std::sort(ranges.begin(), ranges.end(), [](const Range &a, const Range &b) {
      return a.from < b.from;
    });
    Table table{{"from", "rpm"}, {"to", "rpm"}, {"stress amplification", "-"}, {"waves"}};
    for (std::size_t k = 0; k < ranges.size();)
      {
        Range whole = ranges[k];
        for (++k; k < ranges.size() && ranges[k].from <= whole.to; ++k)
          {
            whole.to            = std::max(whole.to, ranges[k].to);
            whole.amplification = std::max(whole.amplification, ranges[k].amplification);
            whole.waves += "; " + ranges[k].waves;
          }
        table.add_row({whole.from * rpm, whole.to * rpm, whole.amplification, whole.waves});
      }
    return table;
  }

  void log_wave_line(const WaveLine &line, Log &log)
  {
    log.line(line.name(),
             ": ",
             line.speed * rpm,
             " rpm by the free body, ",
             line.linear_curve.peak * rpm,
             " rpm in contact; ",
             line.meeting.wave.frequency() / (2. * pi),
             " Hz in the rotating frame, damping ratio ",
             100. * line.damping_ratio(),
             " %, width ",
             100. * line.linear_curve.width / line.linear_curve.peak,
             " % of the speed, amplitude ",
             line.linear_curve.amplitude,
             " um");
  }

  void log_wave_response(const WaveLine &line, const WaveResponse &response, Log &log)
  {
    log.line(line.name(),
             ", ",
             response.solver,
             " pair: peak at ",
             response.curve.peak * rpm,
             " rpm, ",
             100. * (response.curve.peak / line.linear_curve.peak - 1.),
             " % from its prediction in contact, width ",
             100. * response.curve.width / response.curve.peak,
             " %, decay ",
             response.build_up.decay,
             " 1/s, amplitude ",
             response.curve.amplitude,
             " um, stress amplified by ",
             response.amplification());
  }
} // namespace vfife
