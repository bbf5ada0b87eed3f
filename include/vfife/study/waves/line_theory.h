// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_line_theory_h
#define vfife_study_waves_line_theory_h

#include <vfife/base/text/table.h>
#include <vfife/study/waves/contact_meetings.h>

#include <complex>
#include <vector>

namespace vfife
{
  class LinearResponse;
  class WaveDriver;
  struct Transmission;
  struct WaveLine;
  struct WavesOptions;

  /** What linear theory says of waves of the rim over the driver's speed. */
  class LineTheory
  {
  public:
    /** All must outlive the object; speeds are those of the @p options, @p turning as in
     * find_contact_meetings(). */
    LineTheory(const WavesOptions   &options,
               const Transmission   &transmission,
               double                turning,
               const LinearResponse &linear,
               const WaveDriver     &driver);

    /** Sets WaveLine::linear_curve and neighbours: the pole in contact that has most of the free
     * body's wave, and the others. Throws NumericalError where there is none. */
    void predict(WaveLine &line) const;

    /** Amplitude [um] of a line's wave at a speed of the driver [rad/s]. */
    std::complex<double> amplitude(const WaveLine &line, double speed) const;

    /** waves_in_contact.csv. @p most: largest number of diameters that the rim is looked at for. */
    Table list_meetings(unsigned int most) const;

  private:
    const WavesOptions         &options_;
    double                      ratio_; ///< of the driven body's rate over the driver's, > 0
    const LinearResponse       &linear_;
    const WaveDriver           &driver_;
    std::vector<ContactMeeting> meetings_; ///< around the range of speeds
  };
} // namespace vfife

#endif
