// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_waves_line_theory_h
#define vfife_study_waves_line_theory_h

#include <vfife/base/text/table.h>
#include <vfife/reduced/resonance/nearest_wave.h>

#include <complex>
#include <optional>
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
    /** All must outlive the object; speeds are those of the @p options and, for the nearest wave,
     * that of @p operation [rad/s]; @p turning as in find_contact_meetings(). */
    LineTheory(const WavesOptions   &options,
               const Transmission   &transmission,
               double                turning,
               double                operation,
               const LinearResponse &linear,
               const WaveDriver     &driver);

    /** The lines that the options ask for, with a damping @p zeta [1/s]: poles in contact between
     * the speeds, each with the wave of the free body that it has most of and no other pole more;
     * ascending by speed in contact. */
    std::vector<WaveLine> find_lines(double zeta) const;

    /** Of all meetings, between the speeds and around them. */
    std::optional<NearestWave> find_nearest(double speed) const;

    /** waves_frequencies.csv: of the waves that the options ask for by themselves, and in contact
     * of those that lines are of. */
    Table list_frequencies() const;

    /** Amplitude [um] of a line's wave at a speed of the driver [rad/s]. */
    std::complex<double> amplitude(const WaveLine &line, double speed) const;

    /** waves_in_contact.csv. @p most: largest number of diameters that the rim is looked at for. */
    Table list_meetings(unsigned int most) const;

  private:
    /** A pole, by its place among the meetings, with the free body's wave that it is of, and how
     * much of its energy that has. */
    struct NamedMeeting
    {
      std::size_t place;
      BodyWave    wave;
      double      share;
    };
    /** Those between the speeds of the orders that the options ask for. */
    std::vector<NamedMeeting> name_meetings() const;
    bool                      is_asked_for(const BodyWave &wave) const;
    double                    speed_of(const ContactMeeting &meeting) const; ///< [rad/s]
    bool                      is_between(const ContactMeeting &meeting) const;
    /** Amplitudes of the rim [um] for coordinates of a mesh harmonic: twice those of real
     * coordinates, which have the opposite harmonic as well. */
    Eigen::RowVectorXcd gains(unsigned int diameters) const;
    /** Sets WaveLine::linear_curve and neighbours. */
    void predict(const ContactMeeting &own, WaveLine &line) const;

    const WavesOptions         &options_;
    unsigned int                driver_teeth_;
    double                      ratio_;   ///< of the driven body's rate over the driver's, > 0
    double                      turning_; ///< as in find_contact_meetings()
    const LinearResponse       &linear_;
    const WaveDriver           &driver_;
    std::vector<ContactMeeting> meetings_; ///< around the range of speeds
    std::vector<NamedMeeting>   lines_;    ///< those asked for, ascending by speed in contact
  };
} // namespace vfife

#endif
