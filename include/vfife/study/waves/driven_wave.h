// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_driven_wave_h
#define vfife_study_waves_driven_wave_h

#include <vfife/model/model.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/study/waves/wave_record.h>

#include <complex>

namespace vfife
{
  class StressWavePlaces;

  /** Drives waves of a pair's driven body. */
  class WaveDriver
  {
  public:
    /** All must outlive the object. Where @p places has fillets, the driven body has their readings
     * (list_fillet_readings()). */
    WaveDriver(const Model &model, ReducedPair &pair, const StressWavePlaces &places);

    /** Starts from the equilibrium at the schedule's speed. Throws NumericalError. */
    WaveMotion drive(const WaveMeeting &meeting, const WaveSchedule &schedule);

    /** Amplitudes of the rim's axial wave with @p diameters [um] of unit coordinates of its
     * harmonic. */
    Eigen::RowVectorXcd rim_gains(unsigned int diameters) const;

  private:
    const ReducedBody   &body() const;
    std::complex<double> read_rim(unsigned int diameters);

    const Model            &model_;
    ReducedPair            &pair_;
    const StressWavePlaces &places_;
  };
} // namespace vfife

#endif
