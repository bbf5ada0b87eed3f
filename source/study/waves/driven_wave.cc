// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/complex.h>
#include <vfife/element/stress.h>
#include <vfife/model/state.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/study/cases/probe_copies.h>
#include <vfife/study/reduced/fillet_readings.h>
#include <vfife/study/waves/driven_wave.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vfife
{
  namespace
  {
    constexpr unsigned int axial = 2; ///< component of the rim's motion

    /** Parts of a wave's period at which its stress is looked at. */
    constexpr unsigned int n_phases = 128;

    /** Of a measure of what stresses @p amplitudes are at the parts of a period. */
    template <std::size_t n, typename Measure>
    double find_largest_of(const std::array<Complex, n> &amplitudes, const Measure &measure)
    {
      double largest = 0;
      for (unsigned int k = 0; k < n_phases; ++k)
        {
          std::array<double, n> parts;
          for (std::size_t c = 0; c < n; ++c)
            parts[c] = (amplitudes[c] * std::polar(1., 2. * pi * k / n_phases)).real();
          largest = std::max(largest, measure(parts));
        }
      return largest;
    }

    /** Tension at a facet with a strain [MPa]. */
    double find_tension(const SurfaceTensor &strain, const Material &material)
    {
      return compute_principal_stresses(compute_surface_stress(strain, material)).first;
    }

    /** Frequency of the force in the turning axes at a driven rate [rad/s], signed as the wave's.
     */
    double force_frequency(const WaveMeeting &meeting, const unsigned int teeth, const double rate)
    {
      const double sense = meeting.wave.omega < 0 ? -1. : 1.;
      return sense * meeting.turns_order(teeth) * std::abs(rate);
    }
  } // namespace

  WaveDriver::WaveDriver(const Model &model, ReducedPair &pair, const RootStress *const roots)
    : model_(model)
    , pair_(pair)
  {
    const unsigned int driven = model.transmission->driven;
    for (const Probe &probe : model.probes)
      if (probe.body == driven)
        {
          places_.push_back(probe.name);
          copies_.push_back(list_copies(model, probe));
        }
    if (roots == nullptr)
      return;
    for (const MemberFillet &member : roots->fillets())
      if (member.body == driven)
        {
          places_.push_back(member.fillet.side() + " fillet");
          fillets_.push_back(&member);
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
    return 1e3 * double(reduced.n_sectors) * (row(false) - imaginary_unit * row(true));
  }

  Complex WaveDriver::read_rim(const unsigned int n)
  {
    return find_rim_wave(pair_.measure_rim(n), axial, n);
  }

  void WaveDriver::read_fillets(const FacetStrains &take) const
  {
    if (fillets_.empty())
      return;
    const FilletStrains strains = measure_fillet_readings(pair_)(State());
    for (std::size_t f = 0; f < fillets_.size(); ++f)
      {
        const Fillet &fillet = fillets_[f]->fillet;
        std::size_t   facet  = 0;
        for (unsigned int column = 0; column < fillet.n_columns(); ++column)
          for (unsigned int row = Fillet::first_row; row < fillet.end_row(); ++row, ++facet)
            for (unsigned int tooth = 0; tooth < fillet.n_teeth(); ++tooth)
              take(f, facet, tooth, strains.facet(*fillets_[f], column, row, tooth));
      }
  }

  std::vector<double> WaveDriver::read_stresses() const
  {
    std::vector<double> stresses(places_.size(), 0.);
    for (std::size_t p = 0; p < copies_.size(); ++p)
      for (const ProbeValue &value : pair_.measure_probes(copies_[p]))
        stresses[p] = std::max(stresses[p], value.von_mises);
    const Material &material = model_.bodies[model_.transmission->driven].material();
    read_fillets([&](const std::size_t f, std::size_t, unsigned int, const SurfaceTensor &strain) {
      double &largest = stresses[copies_.size() + f];
      largest         = std::max(largest, find_tension(strain, material));
    });
    return stresses;
  }

  WaveDriver::WaveStresses WaveDriver::no_stresses() const
  {
    WaveStresses none;
    none.probes.resize(copies_.size());
    for (const MemberFillet *member : fillets_)
      none.fillets.emplace_back(member->fillet.n_columns() *
                                (member->fillet.end_row() - Fillet::first_row));
    return none;
  }

  void WaveDriver::add_wave_stresses(const unsigned int n,
                                     const Complex     &turned,
                                     WaveStresses      &sums) const
  {
    const ReducedBody &reduced = body();
    const auto         phase   = [&](const unsigned int sector) {
      return turned * std::polar(2. / reduced.n_sectors, -(n * sector * reduced.sector_angle));
    };
    for (std::size_t p = 0; p < copies_.size(); ++p)
      {
        const std::vector<ProbeValue> values = pair_.measure_probes(copies_[p]);
        for (std::size_t m = 0; m < values.size(); ++m)
          for (std::size_t c = 0; c < 6; ++c)
            sums.probes[p][c] +=
              phase(copies_[p][m].node / reduced.nodes_per_sector) * values[m].stress[c];
      }
    read_fillets([&](const std::size_t    f,
                     const std::size_t    facet,
                     const unsigned int   tooth,
                     const SurfaceTensor &strain) {
      for (std::size_t c = 0; c < 3; ++c)
        sums.fillets[f][facet][c] += phase(tooth) * strain[c];
    });
  }

  std::vector<double> WaveDriver::find_largest(const WaveStresses &stresses) const
  {
    std::vector<double> largest;
    for (const auto &probe : stresses.probes)
      largest.push_back(find_largest_of(probe, [](const std::array<double, 6> &parts) {
        return von_mises(Eigen::Map<const Stress>(parts.data()));
      }));
    const Material &material = model_.bodies[model_.transmission->driven].material();
    for (const auto &fillet : stresses.fillets)
      {
        largest.push_back(0);
        for (const auto &facet : fillet)
          largest.back() =
            std::max(largest.back(),
                     find_largest_of(facet, [&](const std::array<double, 3> &parts) {
                       return find_tension(SurfaceTensor(parts[0], parts[1], parts[2]), material);
                     }));
      }
    return largest;
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
    motion.static_stress  = read_stresses();
    WaveStresses stresses = no_stresses();
    motion.force          = Eigen::VectorXcd::Zero(body().harmonics[harmonic].n_modes());

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
            sum += rim * std::exp(-imaginary_unit * (omega * time));
            if (!counts)
              continue;
            motion.force += std::exp(-imaginary_unit * (omega * time)) *
                            pair_.measure_modal_forces(t.driven)[harmonic];
            pair_.measure(state);
            const double error   = state.measured.transmission_error;
            least_error          = counted.empty() ? error : std::min(least_error, error);
            largest_error        = counted.empty() ? error : std::max(largest_error, error);
            motion.largest_force = std::max(motion.largest_force, state.measured.contact_force);
            counted.push_back(rim * std::exp(-imaginary_unit * (spin * time)));
            if (mesh + 1 < schedule.settling_meshes + schedule.counted_meshes)
              continue;
            add_wave_stresses(n,
                              std::exp(-imaginary_unit * (omega * time)) / double(schedule.samples),
                              stresses);
          }
        motion.meshes.push_back(sum / double(schedule.samples));
      }
    motion.wave_stress = find_largest(stresses);
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
