// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/complex.h>
#include <vfife/base/errors.h>
#include <vfife/model/transmission.h>
#include <vfife/study/waves/driven_wave.h>
#include <vfife/study/waves/line_theory.h>
#include <vfife/study/waves/linear_response.h>
#include <vfife/study/waves/wave_line.h>
#include <vfife/study/waves/waves_options.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace vfife
{
  namespace
  {
    /** Free vibrations in contact are found this part of the speed beyond the range as well: the
     * contact moves lines, and neighbours add to their amplitudes. */
    constexpr double beyond = .2;
    /** Mesh orders of the meetings that are listed, at least. */
    constexpr unsigned int least_orders = 3;
  } // namespace

  LineTheory::LineTheory(const WavesOptions   &options,
                         const Transmission   &transmission,
                         const double          turning,
                         const LinearResponse &linear,
                         const WaveDriver     &driver)
    : options_(options)
    , ratio_(std::abs(transmission.ratio()))
    , linear_(linear)
    , driver_(driver)
    , meetings_(find_contact_meetings(linear,
                                      std::max(options.mesh_orders, least_orders),
                                      (1. - beyond) * ratio_ * options.lowest_speed,
                                      (1. + beyond) * ratio_ * options.highest_speed,
                                      turning))
  {
  }

  Complex LineTheory::amplitude(const WaveLine &line, const double speed) const
  {
    const unsigned int n    = line.meeting.wave.diameters;
    const int          p    = line.meeting.mesh_harmonic();
    const double       rate = line.meeting.rate * speed / line.speed;
    return (driver_.rim_gains(n) *
            linear_.coordinates(driver_.find_harmonic(n), p, rate, linear_.moment(p, rate)))(0);
  }

  void LineTheory::predict(WaveLine &line) const
  {
    const ReducedBody &body  = linear_.body();
    const auto         share = [&](const ContactMeeting &meeting) {
      return meeting.share_of(line.meeting, body);
    };
    const ContactMeeting *own = nullptr;
    for (const ContactMeeting &meeting : meetings_)
      if (share(meeting) > 0 && (own == nullptr || share(meeting) > share(*own)))
        own = &meeting;
    if (own == nullptr)
      throw NumericalError("linear theory finds nothing of the " + line.name() + " in contact");

    // Speeds are those of the driver; a forward wave has the conjugate of what is analytic.
    const BodyWave           &wave     = line.meeting.wave;
    const bool                forward  = wave.direction == WaveDirection::forward;
    const std::size_t         harmonic = driver_.find_harmonic(wave.diameters);
    const Eigen::RowVectorXcd gains    = driver_.rim_gains(wave.diameters);
    const double              factor   = line.speed / line.meeting.rate;
    const auto                part     = [&](const ContactMeeting &meeting) {
      const std::complex<double> pole = meeting.rate * factor;
      return std::make_pair(factor * (gains * meeting.residues(wave.direction)[harmonic])(0),
                            forward ? std::conj(pole) : pole);
    };
    ResonanceFit &curve                 = line.linear_curve;
    std::tie(curve.residue, curve.pole) = part(*own);
    curve.peak                          = curve.pole.real();
    curve.width                         = 2. * std::abs(curve.pole.imag());
    curve.amplitude                     = std::abs(curve.residue / curve.pole.imag());
    curve.background                    = amplitude(line, curve.peak) - curve.value(curve.peak);
    for (const ContactMeeting &meeting : meetings_)
      if (&meeting != own && meeting.mesh_order == own->mesh_order)
        line.neighbours.push_back(part(meeting));
    std::sort(line.neighbours.begin(), line.neighbours.end(), [&](const auto &a, const auto &b) {
      return std::abs(a.first / (curve.peak - a.second)) >
             std::abs(b.first / (curve.peak - b.second));
    });
  }

  Table LineTheory::list_meetings(const unsigned int most) const
  {
    std::vector<ContactMeeting> listed;
    for (const ContactMeeting &meeting : meetings_)
      if (const double speed = std::abs(meeting.rate.real()) / ratio_;
          speed >= options_.lowest_speed && speed <= options_.highest_speed)
        listed.push_back(meeting);
    return make_contact_meeting_table(
      listed,
      [&](const unsigned int n) {
        return n > 0 && n <= most ? driver_.rim_gains(n) : Eigen::RowVectorXcd();
      },
      1. / ratio_);
  }
} // namespace vfife
