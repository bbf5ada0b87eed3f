// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/lumped/speed_sweep.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/reduced_options.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/study/reduced/speed_response.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** Mean, standard deviation, smallest and largest of samples. */
    struct Statistics
    {
      double mean = 0, rms = 0, least = 0, largest = 0;

      explicit Statistics(const std::vector<double> &samples)
      {
        if (samples.empty())
          return;
        mean = std::accumulate(samples.begin(), samples.end(), 0.) / samples.size();
        for (const double value : samples)
          rms += (value - mean) * (value - mean);
        rms                    = std::sqrt(rms / samples.size());
        const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
        least                  = *low;
        largest                = *high;
      }
    };

    /** Waves of the rim's axial motion in space. In turning axes a wave is Re(w exp(i n alpha));
     * what stands in space has w ~ exp(i n psi), psi what the body has turned about the axis of its
     * sectors. */
    std::vector<std::complex<double>>
    find_waves(ReducedPair &pair, const unsigned int largest, const double turned)
    {
      const std::vector<double>         rim = pair.measure_rim(largest);
      std::vector<std::complex<double>> waves;
      for (unsigned int n = 1; n <= largest; ++n)
        waves.push_back(find_rim_wave(rim, 2, n) * std::polar(1., -(n * turned)));
      return waves;
    }
  } // namespace

  void SpeedResponse::add(const double                             error,
                          const double                             force,
                          const bool                               coast,
                          const std::vector<std::complex<double>> &waves)
  {
    errors_.push_back(error);
    forces_.push_back(force);
    n_coast_ += coast ? 1 : 0;
    waves_.push_back(waves);
  }

  LumpedResponse SpeedResponse::response(const double energy_error) const
  {
    const Statistics error(errors_), force(forces_);
    LumpedResponse   response;
    response.mean_error    = error.mean;
    response.rms_error     = error.rms;
    response.pp_error      = error.largest - error.least;
    response.mean_force    = force.mean;
    response.rms_force     = force.rms;
    response.pp_force      = force.largest - force.least;
    response.largest_force = force.largest;
    unsigned int n_apart   = 0;
    for (std::size_t i = 0; i < forces_.size(); ++i)
      if (!(forces_[i] > 0))
        {
          ++n_apart;
          response.losses += i > 0 && forces_[i - 1] > 0 ? 1 : 0;
        }
    response.time_apart   = double(n_apart) / forces_.size();
    response.time_coast   = double(n_coast_) / forces_.size();
    response.energy_error = energy_error;
    return response;
  }

  std::pair<double, double> SpeedResponse::wave(const unsigned int n) const
  {
    std::complex<double> mean = 0;
    for (const auto &waves : waves_)
      mean += waves[n - 1];
    mean /= double(waves_.size());
    double largest = 0;
    for (const auto &waves : waves_)
      largest = std::max(largest, std::abs(waves[n - 1] - mean));
    return {std::abs(mean), largest};
  }

  Table make_wave_response_table()
  {
    Table table;
    table.add_text_column(column::direction);
    table.add_column(column::speed, "rpm");
    for (unsigned int n = 1; n <= SpeedResponse::largest_wave; ++n)
      {
        table.add_column("standing wave " + std::to_string(n), "um");
        table.add_column("running wave " + std::to_string(n), "um");
      }
    return table;
  }

  void sweep_speeds(const Model                 &model,
                    const ReducedOptions        &options,
                    const double                 cutoff,
                    const SpeedSweepOptions     &sweep,
                    const unsigned int           samples,
                    ReducedPair                 &pair,
                    Table                       &resonance,
                    Table                       &waves,
                    const std::function<void()> &report,
                    Log                         &log)
  {
    const Transmission &t = *model.transmission;
    // Of the driven body's turn in the drive direction, about the axis of its sectors.
    const double sense   = t.driven_sense * pair.sector_sense(t.driven);
    const auto   turn_at = [&](const double speed, const std::string &direction) {
      const double       frequency = speed * t.driver_teeth / (2. * pi);
      const unsigned int steps     = options.find_steps(frequency, cutoff, samples);
      pair.set_speed(speed, 1. / (frequency * steps));
      for (unsigned int i = 0; i < options.settling_meshes * steps; ++i)
        pair.step();
      SpeedResponse response;
      State         state;
      for (unsigned int i = 1; i <= options.counted_meshes * steps; ++i)
        {
          pair.step();
          if (i % (steps / samples) != 0)
            continue;
          pair.measure(state);
          const Measurements &m = state.measured;
          response.add(m.transmission_error,
                       m.contact_force,
                       std::any_of(m.teeth.begin(),
                                   m.teeth.end(),
                                   [](const auto &tooth) { return tooth.side == "coast"; }),
                       find_waves(pair,
                                  SpeedResponse::largest_wave,
                                  sense * (m.driven_angle - t.driven_start)));
        }
      const LumpedResponse found = response.response(std::abs(state.measured.energy.error()));
      add_response(direction, speed, t.driver_teeth, found, resonance);
      std::vector<Table::Cell> row = {direction, speed * 30. / pi};
      for (unsigned int n = 1; n <= SpeedResponse::largest_wave; ++n)
        {
          row.emplace_back(response.wave(n).first);
          row.emplace_back(response.wave(n).second);
        }
      waves.add_row(row);
      log.line(direction,
               " ",
               speed * 30. / pi,
               " rpm: transmission error ",
               found.mean_error / arcsecond,
               " arcsec, peak to peak ",
               found.pp_error / arcsecond,
               " arcsec, largest force ",
               found.largest_force,
               " N, ",
               steps,
               " steps in a tooth mesh");
      report();
    };
    for (const double speed : list_speeds(sweep, true))
      turn_at(speed, "up");
    if (sweep.kind == SweepKind::up_and_down)
      for (const double speed : list_speeds(sweep, false))
        turn_at(speed, "down");
  }
} // namespace vfife
