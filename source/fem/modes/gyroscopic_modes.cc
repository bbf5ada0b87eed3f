// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/types.h>
#include <vfife/fem/modes/gyroscopic_modes.h>
#include <vfife/fem/modes/mass_basis.h>
#include <vfife/fem/modes/modal_solver.h>
#include <vfife/fem/solvers/direct_solver.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** Residuals below this are good enough, and how often the basis grows to reach it. */
    constexpr double       small_residual = 1e-5;
    constexpr unsigned int most_rounds    = 12;

    /** A wave in the coordinates of a basis. */
    struct SmallWave
    {
      double           rate;
      Eigen::VectorXcd shape;
    };

    class GyroscopicProblem
    {
    public:
      GyroscopicProblem(const GyroscopicSystem         &system,
                        const std::vector<OwnedVector> &modes,
                        const std::vector<OwnedVector> &rigid)
        : system_(system)
        , K_(system.stiffness)
        , M_(system.mass)
        , C_(system.coriolis)
        , basis_(M_)
        , rigid_(M_)
      {
        for (const OwnedVector &motion : rigid)
          {
            rigid_.add(motion);
            basis_.add(motion);
          }
        for (const OwnedVector &mode : modes)
          basis_.add(mode);
        // What a wave begins to take up when Coriolis forces set in.
        for (const OwnedVector &mode : modes)
          add_answer(C_.apply(mode));
      }

      std::vector<GyroscopicMode> solve(const unsigned int n)
      {
        for (unsigned int round = 0;; ++round)
          {
            std::vector<GyroscopicMode> waves;
            const std::size_t           before = basis_.vectors().size();
            for (const SmallWave &wave : find_small_waves(n))
              waves.push_back(expand(wave, round < most_rounds));
            if (basis_.vectors().size() == before)
              return waves;
          }
      }

    private:
      /** Adds the static answer to forces to the basis. */
      void add_answer(OwnedVector forces)
      {
        system_.factors.solve(forces.data(), 1);
        basis_.add(std::move(forces));
      }

      std::vector<SmallWave> find_small_waves(const unsigned int n) const
      {
        // States (q, q'/scale): all blocks are then of the size of the largest frequency.
        const std::vector<OwnedVector> &b    = basis_.vectors();
        const int                       size = b.size();
        const Eigen::MatrixXd           k = K_.project(b, b), c = C_.project(b, b);
        const double                    scale  = std::sqrt(k.diagonal().cwiseAbs().maxCoeff());
        Eigen::MatrixXd                 linear = Eigen::MatrixXd::Zero(2 * size, 2 * size);
        // q'' = -k q - 2 c q' with M = 1 in this basis; k is made symmetric and c skew exactly.
        linear.topRightCorner(size, size)    = scale * Eigen::MatrixXd::Identity(size, size);
        linear.bottomLeftCorner(size, size)  = -.5 / scale * (k + k.transpose());
        linear.bottomRightCorner(size, size) = c.transpose() - c;
        const Eigen::EigenSolver<Eigen::MatrixXd> solver(linear);
        const Eigen::MatrixXd                     rigid = M_.project(rigid_.vectors(), b);

        // Eigenvalues come in pairs i omega, -i omega of one wave, and with a growing motion comes
        // its decaying mirror image: only the growing one is looked for. A wave at its critical
        // speed stands still, and round-off may make it grow by this much.
        const double           round_off = 1e-5 * std::abs(system_.rate);
        std::vector<SmallWave> waves;
        for (int j = 0; j < 2 * size; ++j)
          {
            const Complex value = solver.eigenvalues()[j];
            if (value.imag() < 0 || (value.imag() == 0 && value.real() <= 0))
              continue;
            Eigen::VectorXcd shape = solver.eigenvectors().col(j).head(size).normalized();
            if ((rigid * shape).squaredNorm() > .5)
              continue;
            if (value.real() > 1e-6 * std::abs(value) + round_off)
              throw NumericalError(
                "the body is not stable at this speed: with Coriolis forces a motion grows");
            waves.push_back({std::abs(value), std::move(shape)});
          }
        std::sort(waves.begin(), waves.end(), [](const SmallWave &a, const SmallWave &b) {
          return a.rate < b.rate;
        });
        waves.resize(std::min<std::size_t>(waves.size(), n));
        return waves;
      }

      /** Back to all unknowns; the residual is that of the full problem, so it shows what the
       * basis misses, which is added to it if @p grow. */
      GyroscopicMode expand(const SmallWave &small, const bool grow)
      {
        GyroscopicMode wave;
        wave.rate            = small.rate;
        wave.real            = basis_.combine(small.shape.real());
        wave.imaginary       = basis_.combine(small.shape.imag());
        const OwnedVector Kr = K_.apply(wave.real), Ki = K_.apply(wave.imaginary),
                          Mr = M_.apply(wave.real), Mi = M_.apply(wave.imaginary),
                          Cr = C_.apply(wave.real), Ci = C_.apply(wave.imaginary);
        // (K - w^2 M + 2 i w C)(r + i s): real part K r - w^2 M r - 2 w C s, imaginary part K s -
        // w^2 M s + 2 w C r.
        const double w = wave.rate;
        OwnedVector  rest_real(Kr), rest_imaginary(Ki);
        for (std::size_t i = 0; i < Kr.size(); ++i)
          {
            rest_real[i] += -w * w * Mr[i] - 2. * w * Ci[i];
            rest_imaginary[i] += -w * w * Mi[i] + 2. * w * Cr[i];
          }
        // a . b + c . d on all ranks
        const auto dots = [this](const OwnedVector &a,
                                 const OwnedVector &b,
                                 const OwnedVector &c,
                                 const OwnedVector &d) {
          return system_.mass.communicator().sum(
            std::inner_product(a.begin(), a.end(), b.begin(), 0.) +
            std::inner_product(c.begin(), c.end(), d.begin(), 0.));
        };
        const auto square = [&](const OwnedVector &a, const OwnedVector &b) {
          return dots(a, a, b, b);
        };
        const double kinetic  = w * w * dots(wave.real, Mr, wave.imaginary, Mi);
        const double elastic  = dots(wave.real, Kr, wave.imaginary, Ki);
        wave.kinetic_share    = kinetic / (kinetic + elastic);
        const double in_space = w + std::abs(system_.rate);
        wave.residual         = std::sqrt(square(rest_real, rest_imaginary) / square(Mr, Mi)) /
                        std::max(in_space * in_space, std::abs(system_.shift));
        if (grow && wave.residual > small_residual)
          {
            add_answer(std::move(rest_real));
            add_answer(std::move(rest_imaginary));
          }
        return wave;
      }

      const GyroscopicSystem system_;
      SparseMatrix           K_, M_, C_;
      MassBasis              basis_, rigid_;
    };
  } // namespace

  std::vector<GyroscopicMode> find_gyroscopic_modes(const GyroscopicSystem         &system,
                                                    const std::vector<OwnedVector> &modes,
                                                    const std::vector<OwnedVector> &rigid,
                                                    const unsigned int              n)
  {
    std::vector<GyroscopicMode> waves = GyroscopicProblem(system, modes, rigid).solve(n);
    for (const GyroscopicMode &wave : waves)
      check_residual(wave.residual, wave.rate / (2. * pi));
    return waves;
  }
} // namespace vfife
