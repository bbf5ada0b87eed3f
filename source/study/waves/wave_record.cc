// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/types.h>
#include <vfife/model/transmission.h>
#include <vfife/study/waves/wave_record.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  void WaveMotion::serialize(ByteStream &stream)
  {
    stream.pass(speed, mesh_time, meshes, amplitude);
    stream.pass(running, pp_error, largest_force, static_stress, wave_stress, energy_error);
  }

  WaveRecord::WaveRecord(const WaveMeeting  &meeting,
                         const Transmission &transmission,
                         const WaveSchedule &schedule)
    : schedule_(schedule)
  {
    const BodyWave &wave  = meeting.wave;
    const double    rate  = std::abs(schedule.speed * transmission.ratio());
    const double    sense = wave.omega < 0 ? -1. : 1.;
    omega_                = sense * meeting.turns_order(transmission.driven_teeth) * rate;
    spin_ = (wave.direction == WaveDirection::forward ? -sense : sense) * wave.diameters * rate;
    // A motion of all sectors alike is real, of which the mean has one half.
    amplitude_        = wave.diameters == 0 ? 2. : 1.;
    motion_.speed     = schedule.speed;
    motion_.mesh_time = 2. * pi / (schedule.speed * transmission.driver_teeth);
  }

  double WaveRecord::time() const
  {
    return (sample_ + 1.) / schedule_.samples * motion_.mesh_time;
  }

  Complex WaveRecord::turned() const
  {
    return std::polar(amplitude_, -omega_ * time());
  }

  void WaveRecord::add(const Complex &rim, const double error, const double force)
  {
    if (sample_ % schedule_.samples == 0)
      motion_.meshes.emplace_back(0.);
    motion_.meshes.back() += rim * turned() / double(schedule_.samples);
    if (counts())
      {
        least_error_          = counted_.empty() ? error : std::min(least_error_, error);
        largest_error_        = counted_.empty() ? error : std::max(largest_error_, error);
        motion_.largest_force = std::max(motion_.largest_force, force);
        counted_.push_back(rim * std::polar(1., -spin_ * time()));
      }
    ++sample_;
  }

  const WaveMotion &WaveRecord::finish()
  {
    motion_.pp_error  = largest_error_ - least_error_;
    motion_.amplitude = 0;
    for (unsigned int k = 0; k < schedule_.counted_meshes; ++k)
      motion_.amplitude +=
        motion_.meshes[schedule_.settling_meshes + k] / double(schedule_.counted_meshes);
    Complex standing = 0;
    for (const Complex &wave : counted_)
      standing += wave / double(counted_.size());
    motion_.running = 0;
    for (const Complex &wave : counted_)
      motion_.running = std::max(motion_.running, std::abs(wave - standing));
    return motion_;
  }
} // namespace vfife
