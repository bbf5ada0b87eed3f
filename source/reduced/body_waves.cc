// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/reduced/body_waves.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <sstream>

namespace vfife
{
  using Eigen::Index;
  using Eigen::MatrixXcd;
  using Eigen::VectorXcd;

  namespace
  {
    constexpr std::complex<double> i(0., 1.);

    /** Change of the rate by which slopes of frequencies are found: they are smooth over it. */
    constexpr double slope_part = 1e-4;

    std::size_t find_harmonic(const ReducedBody &body, const unsigned int diameters)
    {
      for (std::size_t k = 0; k < body.harmonics.size(); ++k)
        if (body.harmonics[k].number == diameters)
          return k;
      std::ostringstream text;
      text << "no wave of " << diameters << " nodal diameters below the cut-off of "
           << body.cutoff / (2. * pi) << " Hz";
      throw InputError(text.str());
    }

    const BodyWave *find_wave(const std::vector<BodyWave> &waves,
                              const WaveDirection          direction,
                              const unsigned int           order)
    {
      for (const BodyWave &wave : waves)
        if (wave.direction == direction && wave.order == order)
          return &wave;
      return nullptr;
    }
  } // namespace

  const char *name_of(const WaveDirection direction)
  {
    return direction == WaveDirection::forward ? "forward" : "backward";
  }

  double BodyWave::frequency() const
  {
    return std::abs(omega);
  }

  double BodyWave::decay_rate(const double zeta) const
  {
    // The loss zeta |c'|^2 = 2 zeta T over the energy T + U, of which amplitudes have half.
    return zeta * kinetic_share;
  }

  double BodyWave::damping_ratio(const double zeta) const
  {
    return decay_rate(zeta) / frequency();
  }

  std::vector<BodyWave> find_waves(const ReducedBody &body,
                                   const std::size_t  harmonic,
                                   const double       rate,
                                   const double       sense)
  {
    const ReducedBody::Harmonic &modes = body.harmonics[harmonic];
    const Index                  n     = modes.n_modes();
    MatrixXcd stiffness = (rate * rate - body.rate * body.rate) * modes.spin_stiffness;
    stiffness += modes.eigenvalues.cast<std::complex<double>>().asDiagonal();
    if (Eigen::LLT<MatrixXcd>(stiffness).info() != Eigen::Success)
      {
        std::ostringstream text;
        text << "a body is not stable at " << rate * 30. / pi << " rpm: its waves with "
             << modes.number << " nodal diameters";
        throw NumericalError(text.str());
      }

    // omega^2 v = K v + omega B v with B = 2 i rate G, Hermitian: [0 1; K B] (v, omega v) = omega
    // (v, omega v), with frequencies over the highest one.
    const MatrixXcd B                 = 2. * rate * i * modes.coriolis;
    const double    w                 = std::sqrt(stiffness.cwiseAbs().maxCoeff());
    MatrixXcd       companion         = MatrixXcd::Zero(2 * n, 2 * n);
    companion.topRightCorner(n, n)    = MatrixXcd::Identity(n, n);
    companion.bottomLeftCorner(n, n)  = stiffness / (w * w);
    companion.bottomRightCorner(n, n) = B / w;
    const Eigen::ComplexEigenSolver<MatrixXcd> solver(companion);

    // Sector k has the phase k h alpha + omega t: with omega > 0 the wave runs in the - sense about
    // the sectors' axis.
    const double          spin = sense * (rate < 0 ? -1. : 1.);
    std::vector<BodyWave> waves;
    for (Index k = 0; k < 2 * n; ++k)
      {
        BodyWave wave;
        wave.diameters = modes.number;
        wave.omega     = w * solver.eigenvalues()[k].real();
        wave.direction = wave.omega * spin < 0 ? WaveDirection::forward : WaveDirection::backward;
        wave.shape     = solver.eigenvectors().col(k).head(n).normalized();
        const double share = (wave.shape.dot(B * wave.shape)).real() / wave.omega;
        wave.kinetic_share = 1. / (2. - share);
        waves.push_back(std::move(wave));
      }
    std::sort(waves.begin(), waves.end(), [](const BodyWave &a, const BodyWave &b) {
      return a.frequency() < b.frequency();
    });
    unsigned int n_forward = 0, n_backward = 0;
    for (BodyWave &wave : waves)
      wave.order = wave.direction == WaveDirection::forward ? ++n_forward : ++n_backward;
    return waves;
  }

  unsigned int WaveMeeting::turns_order(const unsigned int teeth) const
  {
    const unsigned int mesh = mesh_order * teeth;
    return wave.direction == WaveDirection::backward ? mesh + wave.diameters
                                                     : mesh - wave.diameters;
  }

  int WaveMeeting::mesh_harmonic() const
  {
    return wave.direction == WaveDirection::backward ? int(mesh_order) : -int(mesh_order);
  }

  double WaveMeeting::width(const double zeta) const
  {
    return 2. * wave.damping_ratio(zeta) / (1. - stiffening);
  }

  std::optional<double> find_meeting_rate(const std::function<double(double)> &frequency,
                                          const double                         order,
                                          const double                         lowest,
                                          const double                         highest)
  {
    const auto   excess = [&](const double rate) { return frequency(rate) - order * rate; };
    const double low = excess(lowest), high = excess(highest);
    if ((low > 0) == (high > 0))
      return {};
    boost::uintmax_t iterations = 100;
    const auto       found =
      boost::math::tools::toms748_solve(excess,
                                        lowest,
                                        highest,
                                        low,
                                        high,
                                        boost::math::tools::eps_tolerance<double>(40),
                                        iterations);
    return .5 * (found.first + found.second);
  }

  std::vector<WaveMeeting> find_wave_meetings(const ReducedBody &body,
                                              const unsigned int diameters,
                                              const unsigned int n_orders,
                                              const unsigned int mesh_orders,
                                              const double       lowest,
                                              const double       highest,
                                              const double       turning,
                                              const double       sense)
  {
    const std::size_t        harmonic = find_harmonic(body, diameters);
    std::vector<WaveMeeting> meetings;
    for (unsigned int k = 1; k <= mesh_orders; ++k)
      for (const WaveDirection direction : {WaveDirection::forward, WaveDirection::backward})
        for (unsigned int order = 1; order <= n_orders; ++order)
          {
            WaveMeeting meeting;
            meeting.mesh_order     = k;
            meeting.wave.diameters = diameters;
            meeting.wave.direction = direction;
            const double turns     = meeting.turns_order(body.n_sectors);
            const auto   at        = [&](const double rate) {
              const std::vector<BodyWave> waves = find_waves(body, harmonic, turning * rate, sense);
              return *find_wave(waves, direction, order);
            };
            const auto frequency = [&](const double rate) { return at(rate).frequency(); };
            if (order > body.harmonics[harmonic].n_modes())
              continue;
            const auto rate = find_meeting_rate(frequency, turns, lowest, highest);
            if (!rate)
              continue;
            meeting.wave = at(*rate);
            meeting.rate = turning * *rate;
            meeting.stiffening =
              (frequency(*rate * (1. + slope_part)) - frequency(*rate * (1. - slope_part))) /
              (2. * slope_part * frequency(*rate));
            meetings.push_back(std::move(meeting));
          }
    std::sort(meetings.begin(), meetings.end(), [](const WaveMeeting &a, const WaveMeeting &b) {
      return std::abs(a.rate) < std::abs(b.rate);
    });
    return meetings;
  }
} // namespace vfife
