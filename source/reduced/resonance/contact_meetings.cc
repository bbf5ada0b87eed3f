// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/base/types.h>
#include <vfife/reduced/resonance/contact_meetings.h>
#include <vfife/reduced/resonance/linear_response.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vfife
{
  using Eigen::VectorXcd;

  namespace
  {
    /** A vibration is followed from one rate to the next as far as its frequency changes by less
     * than this part. */
    constexpr double near = .03;
    /** Points on the circle around a pole. */
    constexpr unsigned int n_points = 8;

    /** A zero of @p function near @p start: of the quotients of linear functions through three
     * points, which have a pole beside the zero as well (Jarratt and Nudds 1965). */
    template <typename Function>
    std::optional<Complex> find_zero(const Function &function, const Complex &start)
    {
      constexpr unsigned int n_iterations = 30;
      constexpr double       first = 1e-4, done = 1e-9;
      std::array<Complex, 3> x = {{start * (1. - first), start * (1. + first), start}};
      std::array<Complex, 3> f;
      for (std::size_t k = 0; k < 3; ++k)
        f[k] = function(x[k]);
      for (unsigned int n = 0; n < n_iterations; ++n)
        {
          const Complex to =
            (x[2] - x[1]) * (x[2] - x[0]) * f[2] * (f[1] - f[0]) /
            ((x[2] - x[1]) * (f[0] - f[2]) * f[1] + (x[2] - x[0]) * (f[2] - f[1]) * f[0]);
          if (!std::isfinite(to.real()) || !std::isfinite(to.imag()))
            return {};
          x = {{x[1], x[2], x[2] + to}};
          if (std::abs(to) < done * std::abs(start))
            return x[2];
          f = {{f[1], f[2], function(x[2])}};
          if (f[2] == 0.)
            return x[2];
        }
      return {};
    }

    /** What the response has around a pole: residues by Cauchy's integral on a circle that no other
     * pole lies in. */
    void find_residues(const LinearResponse &linear, const double radius, ContactMeeting &meeting)
    {
      const int   p         = meeting.mesh_order;
      const auto &harmonics = linear.body().harmonics;
      meeting.backward.clear();
      meeting.forward.clear();
      for (const auto &modes : harmonics)
        {
          meeting.backward.push_back(VectorXcd::Zero(modes.n_modes()));
          meeting.forward.push_back(VectorXcd::Zero(modes.n_modes()));
        }
      for (unsigned int k = 0; k < n_points; ++k)
        {
          const Complex way    = radius * std::polar(1., 2. * pi * k / n_points);
          const Complex rate   = meeting.rate + way;
          const Complex weight = way / double(n_points);
          const Complex moment = linear.moment(p, rate);
          meeting.moment += weight * moment;
          meeting.turn += weight * linear.turn(p, rate, moment);
          for (std::size_t h = 0; h < harmonics.size(); ++h)
            {
              // Of -p at the conjugate rate: with it the pole is that of the forward wave.
              meeting.backward[h] += weight * linear.coordinates(h, p, rate, moment);
              meeting.forward[h] +=
                std::conj(weight) * linear.coordinates(h, -p, std::conj(rate), std::conj(moment));
            }
        }
    }

    /** Which wave it is, by kinetic energies in the turning axes. */
    void characterise(const LinearResponse &linear, ContactMeeting &meeting)
    {
      const ReducedBody &body = linear.body();
      const int          p = meeting.mesh_order, z = body.n_sectors;
      const double       turn    = body.turn_inertia * std::norm(double(p * z) * meeting.turn);
      double             largest = 0;
      meeting.energy             = turn;
      for (std::size_t k = 0; k < body.harmonics.size(); ++k)
        {
          const int h = body.harmonics[k].number;
          for (const WaveDirection direction : {WaveDirection::backward, WaveDirection::forward})
            {
              if (h == 0 && direction == WaveDirection::forward)
                continue; // one vibration
              const VectorXcd &c      = meeting.residues(direction)[k];
              const double     energy = meeting.energy_of(c.squaredNorm(), h, z, direction);
              meeting.energy += energy;
              if (energy <= largest)
                continue;
              largest           = energy;
              meeting.diameters = h;
              meeting.harmonic  = k;
              meeting.direction = direction;
              Eigen::Index mode;
              c.cwiseAbs().maxCoeff(&mode);
              meeting.order = mode + 1;
            }
        }
      meeting.share      = largest / meeting.energy;
      meeting.turn_share = turn / meeting.energy;
    }
  } // namespace

  const std::vector<VectorXcd> &ContactMeeting::residues(const WaveDirection direction) const
  {
    return direction == WaveDirection::backward ? backward : forward;
  }

  double ContactMeeting::energy_of(const double        squared,
                                   const int           n,
                                   const int           teeth,
                                   const WaveDirection direction) const
  {
    // Real coordinates, those without diameters, have both signs of the frequency.
    const int z = mesh_order * teeth;
    return (n == 0 ? 1. : .5) * squared *
           std::pow(direction == WaveDirection::backward ? z + n : z - n, 2);
  }

  double ContactMeeting::harmonic_share(const std::size_t harmonic, const ReducedBody &body) const
  {
    const int n   = body.harmonics[harmonic].number;
    double    sum = 0;
    for (const WaveDirection one : {WaveDirection::backward, WaveDirection::forward})
      if (n > 0 || one == WaveDirection::backward)
        sum += energy_of(residues(one)[harmonic].squaredNorm(), n, body.n_sectors, one);
    return sum / energy;
  }

  double ContactMeeting::share_of(const WaveMeeting &free, const ReducedBody &body) const
  {
    const BodyWave &wave = free.wave;
    for (std::size_t k = 0; k < body.harmonics.size(); ++k)
      if (body.harmonics[k].number == wave.diameters && free.mesh_order == mesh_order)
        return energy_of(std::norm(wave.shape.dot(residues(wave.direction)[k])),
                         wave.diameters,
                         body.n_sectors,
                         wave.direction) /
               energy;
    return 0;
  }

  double ContactMeeting::width() const
  {
    return 2. * std::abs(rate.imag() / rate.real());
  }

  std::vector<ContactMeeting> find_contact_meetings(const LinearResponse &linear,
                                                    const unsigned int    mesh_orders,
                                                    const double          from_rate,
                                                    const double          highest,
                                                    const double          turning)
  {
    std::vector<ContactMeeting> meetings;
    for (unsigned int p = 1; p <= mesh_orders; ++p)
      for (const Complex &rate : linear.resonance_rates(p))
        // What is damped beyond that does not vibrate.
        if (const double turned = turning * rate.real();
            turned >= from_rate && turned < highest && std::abs(rate.imag()) < turned)
          {
            meetings.emplace_back();
            meetings.back().mesh_order = p;
            meetings.back().rate       = rate;
          }
    std::sort(meetings.begin(), meetings.end(), [](const auto &a, const auto &b) {
      return std::abs(a.rate.real()) < std::abs(b.rate.real());
    });
    for (ContactMeeting &meeting : meetings)
      {
        double radius = std::abs(meeting.rate.imag());
        for (const ContactMeeting &other : meetings)
          if (&other != &meeting && other.mesh_order == meeting.mesh_order)
            radius = std::min(radius, std::abs(other.rate - meeting.rate));
        find_residues(linear, .3 * radius, meeting);
        characterise(linear, meeting);
      }
    return meetings;
  }

  std::vector<double> follow_vibration(const LinearResponse      &linear,
                                       const ContactMeeting      &meeting,
                                       const std::vector<double> &rates)
  {
    // Beside the order's frequency crests pass a place in space by the turn of the body; what spin
    // and contact add to that is small from step to step.
    constexpr unsigned int steps = 4; // between two rates
    const double own = std::abs(meeting.rate.real()), turning = meeting.rate.real() < 0 ? -1. : 1.,
                 slope = (meeting.direction == WaveDirection::backward ? -1. : 1.) *
                         double(meeting.diameters) * linear.sense() * turning;
    std::vector<double> frequencies(rates.size(), not_known);
    for (const bool upwards : {true, false})
      {
        double  at        = own;
        Complex frequency = linear.mesh_frequency(meeting.mesh_order, meeting.rate);
        bool    lost      = false;
        for (std::size_t i = 0; i < rates.size(); ++i)
          {
            const std::size_t k = upwards ? i : rates.size() - 1 - i;
            if ((rates[k] >= own) != upwards)
              continue;
            const double change = (rates[k] - at) / steps;
            for (unsigned int n = 0; n < steps && !lost; ++n)
              {
                at += change;
                const Complex guess = frequency + slope * change;
                const auto    found = find_zero(
                  [&](const Complex &w) { return linear.loop_compliance(w, turning * at); }, guess);
                lost = !found || !(std::abs(*found - guess) < near * std::abs(guess));
                if (!lost)
                  frequency = *found;
              }
            if (!lost)
              frequencies[k] = std::abs(frequency.real());
          }
      }
    return frequencies;
  }

  std::string describe_wave(const ContactMeeting &meeting)
  {
    if (meeting.turn_share > meeting.share)
      return "torsional mode";
    return std::to_string(meeting.diameters) + " nodal diameter" +
           (meeting.diameters == 1 ? "" : "s") +
           (meeting.diameters == 0
              ? ""
              : ", " + std::string(name_of(meeting.direction)) + " travelling wave");
  }

  Table make_contact_meeting_table(
    const std::vector<ContactMeeting>                                &meetings,
    const std::function<Eigen::RowVectorXcd(unsigned int diameters)> &gains,
    const double                                                      ratio,
    const unsigned int                                                teeth)
  {
    Table table{{"mesh order", "-"},
                {column::speed, "rpm"},
                {column::mesh_frequency, "Hz"},
                {"width", "-"},
                {"wave"},
                {"nodal diameter", "-"},
                {"order", "-"},
                {"share of the wave", "-"},
                {"share of the rotation", "-"},
                {"amplitude", "um"},
                {"amplitude of the rotation", "arcsec"},
                {"amplitude of the moment", "N m"}};
    for (const ContactMeeting &meeting : meetings)
      {
        const Eigen::RowVectorXcd gain = gains(meeting.diameters);
        const VectorXcd          &wave = meeting.residues(meeting.direction)[meeting.harmonic];
        const double              half = std::abs(meeting.rate.imag());
        table.add_row({meeting.mesh_order,
                       std::abs(meeting.rate.real()) * ratio * 30. / pi,
                       std::abs(meeting.rate.real()) * teeth / (2. * pi),
                       meeting.width(),
                       meeting.diameters == 0 ? "-" : name_of(meeting.direction),
                       meeting.diameters,
                       meeting.order,
                       meeting.share,
                       meeting.turn_share,
                       gain.size() == 0 ? not_known : std::abs((gain * wave)(0)) / half,
                       2. * std::abs(meeting.turn) / half / arcsecond,
                       2e-3 * std::abs(meeting.moment) / half});
      }
    return table;
  }
} // namespace vfife
