// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/reduced/body_waves.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

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

  std::size_t find_harmonic(const ReducedBody &body, const unsigned int diameters)
  {
    for (std::size_t k = 0; k < body.harmonics.size(); ++k)
      if (body.harmonics[k].number == diameters && body.harmonics[k].n_modes() > 0)
        return k;
    std::ostringstream text;
    text << "no wave of " << diameters << " nodal diameters below the cut-off of "
         << body.cutoff / (2. * pi) << " Hz";
    throw InputError(text.str());
  }

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
        // Both signs are one vibration where all sectors move alike.
        if (modes.number == 0 && wave.direction == WaveDirection::forward)
          continue;
        wave.shape         = solver.eigenvectors().col(k).head(n).normalized();
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

  WaveMeeting find_wave_meeting(const ReducedBody &body,
                                const BodyWave    &wave,
                                const unsigned int mesh_order,
                                const double       rate,
                                const double       sense)
  {
    constexpr unsigned int n_iterations = 100;
    constexpr double       agreed       = 1e-12;
    const std::size_t      harmonic     = find_harmonic(body, wave.diameters);
    const auto             at           = [&](const double other) {
      return *find_wave(find_waves(body, harmonic, other, sense), wave.direction, wave.order);
    };
    WaveMeeting meeting;
    meeting.mesh_order = mesh_order;
    meeting.wave       = wave;
    meeting.rate       = rate;
    // Frequencies change little with the rate: each round leaves the stiffening of the difference.
    for (unsigned int n = 0; n < n_iterations; ++n)
      {
        meeting.wave = at(meeting.rate);
        const double next =
          std::copysign(meeting.wave.frequency() / meeting.turns_order(body.n_sectors), rate);
        const bool done = std::abs(next - meeting.rate) < agreed * std::abs(next);
        meeting.rate    = next;
        if (!done)
          continue;
        meeting.stiffening =
          (at(next * (1. + slope_part)).frequency() - at(next * (1. - slope_part)).frequency()) /
          (2. * slope_part * meeting.wave.frequency());
        return meeting;
      }
    std::ostringstream text;
    text << "mesh order " << mesh_order << " and the wave of " << wave.diameters
         << " nodal diameters have no common speed near " << rate * 30. / pi << " rpm";
    throw NumericalError(text.str());
  }
} // namespace vfife
