// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/model/model.h>
#include <vfife/reduced/body_waves.h>
#include <vfife/reduced/reduced_body.h>
#include <vfife/study/waves/free_lines.h>
#include <vfife/study/waves/wave_line.h>
#include <vfife/study/waves/waves_options.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  FreeLines::FreeLines(const WavesOptions &options,
                       const Model        &model,
                       const ReducedBody  &body,
                       const double        sense)
    : options_(options)
    , model_(model)
    , body_(body)
    , sense_(sense)
  {
  }

  std::vector<WaveLine> FreeLines::find(const double zeta) const
  {
    const Transmission   &t       = *model_.transmission;
    const double          ratio   = std::abs(t.ratio());
    const double          turning = model_.bodies[t.driven].rate < 0 ? -1. : 1.;
    std::vector<WaveLine> lines;
    for (const unsigned int n : options_.diameter_numbers())
      try
        {
          for (WaveMeeting &meeting : find_wave_meetings(body_,
                                                         n,
                                                         options_.wave_orders,
                                                         options_.mesh_orders,
                                                         ratio * options_.lowest_speed,
                                                         ratio * options_.highest_speed,
                                                         turning,
                                                         sense_))
            {
              WaveLine line;
              line.meeting      = std::move(meeting);
              line.speed        = std::abs(line.meeting.rate) / ratio;
              line.driver_teeth = t.driver_teeth;
              line.zeta         = zeta;
              lines.push_back(std::move(line));
            }
        }
      catch (const InputError &error)
        {
          throw InputError("Waves/diameters", error.what());
        }
    std::sort(lines.begin(), lines.end(), [](const WaveLine &a, const WaveLine &b) {
      return a.speed < b.speed;
    });
    return lines;
  }

  Table FreeLines::list_frequencies() const
  {
    const Transmission             &t       = *model_.transmission;
    const std::vector<unsigned int> numbers = options_.diameter_numbers();
    Table                           table   = make_wave_frequency_table();
    for (unsigned int k = 0; k < options_.n_speeds; ++k)
      {
        const double speed = options_.highest_speed * k / (options_.n_speeds - 1);
        const double rate  = model_.bodies[t.driven].rate / t.driver_rate * speed;
        for (std::size_t h = 0; h < body_.harmonics.size(); ++h)
          if (std::count(numbers.begin(), numbers.end(), body_.harmonics[h].number) > 0)
            for (const BodyWave &wave : find_waves(body_, h, rate, sense_))
              if (wave.order <= options_.wave_orders)
                add_wave_frequency(wave, speed, rate, table);
      }
    return table;
  }
} // namespace vfife
