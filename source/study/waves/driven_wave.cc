// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/element/stress.h>
#include <vfife/model/state.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/study/cases/probe_copies.h>
#include <vfife/study/waves/driven_wave.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vfife
{
  using Complex = std::complex<double>;

  namespace
  {
    constexpr unsigned int axial = 2; ///< component of the rim's motion
    constexpr Complex      i(0., 1.);

    /** Parts of a wave's period at which its stress is looked at. */
    constexpr unsigned int n_phases = 64;

    double find_largest_von_mises(const std::array<Complex, 6> &amplitudes)
    {
      double largest = 0;
      for (unsigned int k = 0; k < n_phases; ++k)
        {
          Stress stress;
          for (unsigned int c = 0; c < 6; ++c)
            stress[c] = (amplitudes[c] * std::polar(1., pi * k / n_phases)).real();
          largest = std::max(largest, von_mises(stress));
        }
      return largest;
    }

    /** Frequency of the force in the turning axes at a driven rate [rad/s], signed as the wave's.
     */
    double force_frequency(const WaveMeeting &meeting, const unsigned int teeth, const double rate)
    {
      const double sense = meeting.wave.omega < 0 ? -1. : 1.;
      return sense * meeting.turns_order(teeth) * std::abs(rate);
    }
  } // namespace

  WaveDriver::WaveDriver(const Model &model, ReducedPair &pair)
    : model_(model)
    , pair_(pair)
  {
    for (const Probe &probe : model.probes)
      if (probe.body == model.transmission->driven)
        {
          probes_.push_back(probe);
          copies_.push_back(list_copies(model, probe));
        }
  }

  const ReducedBody &WaveDriver::body() const
  {
    return pair_.body(model_.transmission->driven);
  }

  std::size_t WaveDriver::find_harmonic(const unsigned int diameters) const
  {
    const auto &harmonics = body().harmonics;
    return std::find_if(harmonics.begin(),
                        harmonics.end(),
                        [&](const auto &harmonic) { return harmonic.number == diameters; }) -
           harmonics.begin();
  }

  Eigen::RowVectorXcd WaveDriver::rim_gains(const unsigned int diameters) const
  {
    // The sum over sectors of exp(i n k alpha) Re(z c exp(i n k alpha)) is N/2 conj(z c), and rim
    // coefficients are twice that of the real reading and i times that of the imaginary one.
    const ReducedBody &reduced = body();
    const auto        &shapes  = reduced.harmonics[find_harmonic(diameters)].shapes;
    const auto         row     = [&](const bool imaginary) {
      return shapes.row(3 * reduced.touch_nodes.size() +
                        reduced.find_reading(reading::of_rim(axial, diameters, imaginary)));
    };
    return 1e3 * double(reduced.n_sectors) * (row(false) - i * row(true));
  }

  Complex WaveDriver::read_rim(const unsigned int n)
  {
    return find_rim_wave(pair_.measure_rim(n), axial, n);
  }

  std::vector<double> WaveDriver::read_stresses() const
  {
    std::vector<double> stresses;
    for (const std::vector<Probe> &copies : copies_)
      {
        double largest = 0;
        for (const ProbeValue &value : pair_.measure_probes(copies))
          largest = std::max(largest, value.von_mises);
        stresses.push_back(largest);
      }
    return stresses;
  }

  void WaveDriver::add_wave_stresses(const unsigned int         n,
                                     const Complex             &turned,
                                     std::vector<WaveStresses> &sums) const
  {
    const ReducedBody &reduced = body();
    for (std::size_t p = 0; p < copies_.size(); ++p)
      {
        const std::vector<ProbeValue> values = pair_.measure_probes(copies_[p]);
        for (std::size_t m = 0; m < values.size(); ++m)
          {
            const unsigned int sector = copies_[p][m].node / reduced.nodes_per_sector;
            const Complex      phase =
              turned * std::polar(2. / reduced.n_sectors, -(n * sector * reduced.sector_angle));
            for (std::size_t c = 0; c < sums[p].size(); ++c)
              sums[p][c] += phase * values[m].stress[c];
          }
      }
  }

  WaveMotion WaveDriver::drive(const WaveMeeting &meeting, const WaveSchedule &schedule)
  {
    const Transmission &t = *model_.transmission;
    const unsigned int  n = meeting.wave.diameters, teeth = t.driven_teeth;
    const double        rate  = std::abs(schedule.speed * t.ratio());
    const double        omega = force_frequency(meeting, teeth, rate);
    // What stands in space has this frequency in the turning axes.
    const double spin = (meeting.wave.direction == WaveDirection::forward ? -1. : 1.) * n * rate *
                        (omega < 0 ? -1. : 1.);
    const std::size_t harmonic = find_harmonic(n);

    WaveMotion motion;
    motion.speed      = schedule.speed;
    motion.mesh_time  = 2. * pi / (schedule.speed * t.driver_teeth);
    const double step = motion.mesh_time / schedule.steps;
    pair_.set_speed(schedule.speed, step);
    pair_.start();
    motion.static_stress = read_stresses();
    std::vector<WaveStresses> stresses(probes_.size(), WaveStresses{});
    motion.force = Eigen::VectorXcd::Zero(body().harmonics[harmonic].n_modes());

    const unsigned int   stride = schedule.steps / schedule.samples;
    std::vector<Complex> counted;
    double               least_error = 0, largest_error = 0, time = 0;
    State                state;
    for (unsigned int mesh = 0; mesh < schedule.settling_meshes + schedule.counted_meshes; ++mesh)
      {
        const bool counts = mesh >= schedule.settling_meshes;
        Complex    sum    = 0;
        for (unsigned int s = 1; s <= schedule.steps; ++s)
          {
            pair_.step();
            if (s % stride != 0)
              continue;
            time              = (mesh + double(s) / schedule.steps) * motion.mesh_time;
            const Complex rim = read_rim(n);
            sum += rim * std::exp(-i * (omega * time));
            if (!counts)
              continue;
            motion.force +=
              std::exp(-i * (omega * time)) * pair_.measure_modal_forces(t.driven)[harmonic];
            pair_.measure(state);
            const double error   = state.measured.transmission_error;
            least_error          = counted.empty() ? error : std::min(least_error, error);
            largest_error        = counted.empty() ? error : std::max(largest_error, error);
            motion.largest_force = std::max(motion.largest_force, state.measured.contact_force);
            counted.push_back(rim * std::exp(-i * (spin * time)));
            if (mesh + 1 < schedule.settling_meshes + schedule.counted_meshes)
              continue;
            add_wave_stresses(n,
                              std::exp(-i * (omega * time)) / double(schedule.samples),
                              stresses);
          }
        motion.meshes.push_back(sum / double(schedule.samples));
      }
    for (const WaveStresses &stress : stresses)
      motion.wave_stress.push_back(find_largest_von_mises(stress));
    motion.force /= double(counted.size());
    motion.pp_error     = largest_error - least_error;
    motion.energy_error = std::abs(state.measured.energy.error());
    for (unsigned int k = 0; k < schedule.counted_meshes; ++k)
      motion.amplitude +=
        motion.meshes[schedule.settling_meshes + k] / double(schedule.counted_meshes);
    Complex standing = 0;
    for (const Complex &wave : counted)
      standing += wave / double(counted.size());
    for (const Complex &wave : counted)
      motion.running = std::max(motion.running, std::abs(wave - standing));
    return motion;
  }
} // namespace vfife
