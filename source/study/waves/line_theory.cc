// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/model/transmission.h>
#include <vfife/reduced/resonance/linear_response.h>
#include <vfife/study/waves/driven_wave.h>
#include <vfife/study/waves/line_theory.h>
#include <vfife/study/waves/wave_line_tables.h>
#include <vfife/study/waves/waves_options.h>

#include <algorithm>
#include <cmath>
#include <map>
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
    /** Part of the kinetic energy that the wave of a line has, at least. */
    constexpr double least_share = .25;
  } // namespace

  LineTheory::LineTheory(const WavesOptions   &options,
                         const Transmission   &transmission,
                         const double          turning,
                         const double          operation,
                         const LinearResponse &linear,
                         const WaveDriver     &driver)
    : options_(options)
    , driver_teeth_(transmission.driver_teeth)
    , ratio_(std::abs(transmission.ratio()))
    , turning_(turning)
    , linear_(linear)
    , driver_(driver)
    , meetings_(
        find_contact_meetings(linear,
                              std::max(options.mesh_orders, least_orders),
                              (1. - beyond) * ratio_ * std::min(options.lowest_speed, operation),
                              (1. + beyond) * ratio_ * std::max(options.highest_speed, operation),
                              turning))
  {
    for (NamedMeeting &named : name_meetings())
      if (is_asked_for(named.wave))
        lines_.push_back(std::move(named));
    std::sort(lines_.begin(), lines_.end(), [](const NamedMeeting &a, const NamedMeeting &b) {
      return a.place < b.place;
    });
  }

  double LineTheory::speed_of(const ContactMeeting &meeting) const
  {
    return std::abs(meeting.rate.real()) / ratio_;
  }

  bool LineTheory::is_between(const ContactMeeting &meeting) const
  {
    return speed_of(meeting) >= options_.lowest_speed &&
           speed_of(meeting) <= options_.highest_speed;
  }

  bool LineTheory::is_asked_for(const BodyWave &wave) const
  {
    const std::vector<unsigned int> asked = options_.diameter_numbers();
    return wave.order <= options_.wave_orders &&
           std::count(asked.begin(), asked.end(), wave.diameters) > 0;
  }

  Eigen::RowVectorXcd LineTheory::gains(const unsigned int diameters) const
  {
    return (diameters == 0 ? 2. : 1.) * driver_.rim_gains(diameters);
  }

  Complex LineTheory::amplitude(const WaveLine &line, const double speed) const
  {
    const unsigned int n    = line.meeting.wave.diameters;
    const int          p    = line.meeting.mesh_harmonic();
    const double       rate = line.meeting.rate * speed / line.speed;
    return (
      gains(n) *
      linear_.coordinates(find_harmonic(linear_.body(), n), p, rate, linear_.moment(p, rate)))(0);
  }

  std::vector<LineTheory::NamedMeeting> LineTheory::name_meetings() const
  {
    const ReducedBody        &body = linear_.body();
    std::vector<NamedMeeting> all, named;
    for (std::size_t m = 0; m < meetings_.size(); ++m)
      for (std::size_t k = 0; k < body.harmonics.size(); ++k)
        {
          const ContactMeeting &meeting = meetings_[m];
          const unsigned int    n       = body.harmonics[k].number;
          if (!is_between(meeting) || meeting.mesh_order > options_.mesh_orders ||
              body.harmonics[k].n_modes() == 0 || 2 * n == body.n_sectors ||
              !(meeting.harmonic_share(k, body) > least_share))
            continue;
          for (BodyWave &wave : find_waves(body, k, meeting.rate.real(), linear_.sense()))
            {
              const double share = meeting.share_of({wave, meeting.mesh_order}, body);
              if (share > least_share && share > meeting.turn_share)
                all.push_back({m, std::move(wave), share});
            }
        }
    std::sort(all.begin(), all.end(), [](const NamedMeeting &a, const NamedMeeting &b) {
      return a.share > b.share;
    });
    // A pole has one wave, and a wave one pole for each mesh order: the largest shares first. A
    // wave that is parted among the poles of others is at the one with most of it as well.
    const auto is_same_wave = [this](const NamedMeeting &a, const NamedMeeting &b) {
      return meetings_[a.place].mesh_order == meetings_[b.place].mesh_order &&
             a.wave.diameters == b.wave.diameters && a.wave.direction == b.wave.direction &&
             a.wave.order == b.wave.order;
    };
    for (const bool alone : {true, false})
      for (const NamedMeeting &one : all)
        if (std::none_of(named.begin(), named.end(), [&](const NamedMeeting &other) {
              return (alone && other.place == one.place) || is_same_wave(one, other);
            }))
          named.push_back(one);
    return named;
  }

  std::vector<WaveLine> LineTheory::find_lines(const double zeta) const
  {
    std::vector<WaveLine> lines;
    for (const NamedMeeting &named : lines_)
      {
        const ContactMeeting &meeting = meetings_[named.place];
        WaveLine             &line    = lines.emplace_back();
        line.meeting                  = find_wave_meeting(
          linear_.body(), named.wave, meeting.mesh_order, meeting.rate.real(), linear_.sense());
        line.speed        = std::abs(line.meeting.rate) / ratio_;
        line.driver_teeth = driver_teeth_;
        line.zeta         = zeta;
        predict(meeting, line);
      }
    return lines;
  }

  std::optional<NearestWave> LineTheory::find_nearest(const double speed) const
  {
    return find_nearest_wave(meetings_, ratio_, speed);
  }

  void LineTheory::predict(const ContactMeeting &own, WaveLine &line) const
  {
    // Speeds are those of the driver; a forward wave has the conjugate of what is analytic.
    const BodyWave           &wave     = line.meeting.wave;
    const bool                forward  = wave.direction == WaveDirection::forward;
    const std::size_t         harmonic = find_harmonic(linear_.body(), wave.diameters);
    const Eigen::RowVectorXcd rim      = gains(wave.diameters);
    const double              factor   = line.speed / line.meeting.rate;
    const auto                part     = [&](const ContactMeeting &meeting) {
      const std::complex<double> pole = meeting.rate * factor;
      return std::make_pair(factor * (rim * meeting.residues(wave.direction)[harmonic])(0),
                            forward ? std::conj(pole) : pole);
    };
    ResonanceFit &curve                 = line.linear_curve;
    std::tie(curve.residue, curve.pole) = part(own);
    curve.peak                          = curve.pole.real();
    curve.width                         = 2. * std::abs(curve.pole.imag());
    curve.amplitude                     = std::abs(curve.residue / curve.pole.imag());
    curve.background                    = amplitude(line, curve.peak) - curve.value(curve.peak);
    for (const ContactMeeting &meeting : meetings_)
      if (&meeting != &own && meeting.mesh_order == own.mesh_order)
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
      if (is_between(meeting))
        listed.push_back(meeting);
    return make_contact_meeting_table(
      listed,
      [&](const unsigned int n) { return n <= most ? gains(n) : Eigen::RowVectorXcd(); },
      1. / ratio_,
      linear_.body().n_sectors);
  }

  Table LineTheory::list_frequencies() const
  {
    const ReducedBody  &body = linear_.body();
    std::vector<double> rates;
    for (unsigned int k = 0; k < options_.n_speeds; ++k)
      rates.push_back(ratio_ * options_.highest_speed * k / (options_.n_speeds - 1));
    // Of a wave that several orders meet by the first of them.
    std::map<std::tuple<unsigned int, WaveDirection, unsigned int>, std::vector<double>> contact;
    const auto key_of = [](const BodyWave &wave) {
      return std::make_tuple(wave.diameters, wave.direction, wave.order);
    };
    for (const NamedMeeting &named : lines_)
      if (const auto key = key_of(named.wave); contact.count(key) == 0)
        contact[key] = follow_vibration(linear_, meetings_[named.place], rates);
    Table table = make_wave_frequency_table();
    for (std::size_t i = 0; i < rates.size(); ++i)
      for (std::size_t k = 0; k < body.harmonics.size(); ++k)
        if (body.harmonics[k].n_modes() > 0 && 2 * body.harmonics[k].number != body.n_sectors)
          for (const BodyWave &wave : find_waves(body, k, turning_ * rates[i], linear_.sense()))
            if (is_asked_for(wave))
              {
                const auto found = contact.find(key_of(wave));
                add_wave_frequency(wave,
                                   rates[i] / ratio_,
                                   rates[i],
                                   found == contact.end() ? not_known : found->second[i],
                                   table);
              }
    return table;
  }
} // namespace vfife
