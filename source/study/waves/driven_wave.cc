// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/model/state.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/study/reduced/fillet_readings.h>
#include <vfife/study/stress_waves/stress_wave_places.h>
#include <vfife/study/waves/driven_wave.h>

#include <cmath>

namespace vfife
{
  using Eigen::VectorXcd;

  namespace
  {
    constexpr unsigned int axial = 2; ///< component of the rim's motion
  }                                   // namespace

  WaveDriver::WaveDriver(const Model &model, ReducedPair &pair, const StressWavePlaces &places)
    : model_(model)
    , pair_(pair)
    , places_(places)
  {
  }

  const ReducedBody &WaveDriver::body() const
  {
    return pair_.body(model_.only_transmission()->driven);
  }

  Eigen::RowVectorXcd WaveDriver::rim_gains(const unsigned int diameters) const
  {
    // The sum over sectors of exp(i n k alpha) Re(z c exp(i n k alpha)) is N/2 conj(z c), and rim
    // coefficients are twice that of the real reading and i times that of the imaginary one.
    // Without diameters it is N z c, of the real reading alone.
    const ReducedBody &reduced = body();
    const auto        &shapes  = reduced.harmonics[find_harmonic(reduced, diameters)].shapes;
    const auto         row     = [&](const bool imaginary) {
      return shapes.row(3 * reduced.touch_nodes.size() +
                        reduced.find_reading(reading::of_rim(axial, diameters, imaginary)));
    };
    const double factor = 1e3 * reduced.n_sectors;
    if (diameters == 0)
      return factor * row(false);
    return factor * (row(false) - imaginary_unit * row(true));
  }

  Complex WaveDriver::read_rim(const unsigned int n)
  {
    return find_rim_wave(pair_.reader().read_rim(n), axial, n);
  }

  WaveMotion WaveDriver::drive(const WaveMeeting &meeting, const WaveSchedule &schedule)
  {
    const unsigned int n = meeting.wave.diameters, driven = model_.only_transmission()->driven;
    const std::size_t  harmonic = find_harmonic(body(), n);
    const ProbeMeasure probes   = [this](const std::vector<Probe> &copies) {
      return pair_.reader().read_probes(copies);
    };
    const FilletMeasure measure_fillets = measure_fillet_readings(pair_);
    WaveRecord          record(meeting, *model_.only_transmission(), schedule);
    pair_.set_speed(schedule.speed,
                    2. * pi /
                      (schedule.speed * model_.only_transmission()->driver_teeth * schedule.steps));
    pair_.start();
    const FilletStrains at_rest       = measure_fillets(State());
    std::vector<double> static_stress = places_.measure_largest(probes, &at_rest);

    StressWaves    stresses = places_.none();
    VectorXcd      force    = VectorXcd::Zero(body().harmonics[harmonic].n_modes());
    State          state;
    const unsigned n_counted = schedule.counted_meshes * schedule.samples;
    const unsigned stride    = schedule.steps / schedule.samples;
    for (unsigned s = 0; s < schedule.n_meshes() * schedule.samples; ++s)
      {
        for (unsigned k = 0; k < stride; ++k)
          pair_.step();
        const Complex turned = record.turned();
        if (record.counts())
          {
            force +=
              turned / double(n_counted) * pair_.reader().read_modal_forces(driven)[harmonic];
            pair_.measure(state);
          }
        if (record.is_last_mesh())
          {
            const FilletStrains strains = measure_fillets(state);
            stresses.add(places_.measure(n, probes, &strains), turned / double(schedule.samples));
          }
        record.add(read_rim(n), state.measured.transmission_error, state.measured.contact_force);
      }
    WaveMotion motion    = record.finish();
    motion.force         = force;
    motion.energy_error  = std::abs(state.measured.energy.error());
    motion.static_stress = std::move(static_stress);
    motion.wave_stress   = places_.find_largest(stresses);
    return motion;
  }
} // namespace vfife
