// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/types.h>
#include <vfife/study/waves/wave_fits.h>

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::VectorXcd;

  ResonanceFit fit_resonance(const std::vector<double>  &speeds,
                             const std::vector<Complex> &amplitudes,
                             const std::vector<Complex> &others)
  {
    const Eigen::Index n = speeds.size(), m = others.size();
    if (n < 3 + (m > 0 ? 1 + m : 0) || amplitudes.size() != speeds.size())
      throw NumericalError(
        "a resonance curve requires at least three speeds, and 4 + m alongside m others");
    // Speeds from their middle in parts of their range: the columns are of one size.
    const auto [least, largest] = std::minmax_element(speeds.begin(), speeds.end());
    const double middle = .5 * (*least + *largest), range = *largest - *least;
    MatrixXcd    matrix(n, n > 3 ? 3 + m : 2);
    VectorXcd    right(n);
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const double x = (speeds[k] - middle) / range;
        matrix(k, 0)   = amplitudes[k];
        matrix(k, 1)   = 1.;
        if (n > 3)
          matrix(k, 2) = x;
        for (Eigen::Index q = 0; q < m; ++q)
          matrix(k, 3 + q) = range / (speeds[k] - others[q]);
        right[k] = x * amplitudes[k];
      }
    const VectorXcd found = matrix.colPivHouseholderQr().solve(right);
    ResonanceFit    fit;
    fit.background = n > 3 ? found[2] : Complex(0.);
    fit.pole       = middle + range * found[0];
    // c = a - b p - sum of d: each d/(x - q) (x - p) is d + d (q - p)/(x - q).
    fit.residue = range * (found[1] + fit.background * found[0]);
    for (Eigen::Index q = 0; q < m; ++q)
      {
        const Complex residue = range * range * found[3 + q] / (others[q] - fit.pole);
        fit.others.emplace_back(residue, others[q]);
        fit.residue -= residue;
      }
    fit.peak      = fit.pole.real();
    fit.width     = 2. * std::abs(fit.pole.imag());
    fit.amplitude = std::abs(fit.residue / fit.pole.imag());
    double left = 0, all = 0;
    for (Eigen::Index k = 0; k < n; ++k)
      {
        left += std::norm(amplitudes[k] - fit.value(speeds[k]));
        all += std::norm(amplitudes[k]);
      }
    fit.residual = std::sqrt(left / all);
    return fit;
  }

  Complex ResonanceFit::value(const double speed) const
  {
    Complex sum = residue / (speed - pole) + background;
    for (const auto &[of_other, other] : others)
      sum += of_other / (speed - other);
    return sum;
  }

  std::pair<Complex, Complex> fit_line(const std::vector<Complex> &x, const std::vector<Complex> &y)
  {
    if (x.size() < 2 || x.size() != y.size())
      throw NumericalError("a line needs at least two points");
    Complex mean_x = 0, mean_y = 0, product = 0;
    double  square = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
      {
        mean_x += x[k] / double(x.size());
        mean_y += y[k] / double(x.size());
      }
    for (std::size_t k = 0; k < x.size(); ++k)
      {
        product += std::conj(x[k] - mean_x) * (y[k] - mean_y);
        square += std::norm(x[k] - mean_x);
      }
    const Complex a = product / square;
    return {a, mean_y - a * mean_x};
  }

  BuildUpFit fit_build_up(const std::vector<Complex> &samples, const double interval)
  {
    const Eigen::Index n = samples.size();
    if (n < 8)
      throw NumericalError("a build-up needs at least eight samples");
    const Eigen::Map<const VectorXcd> w(samples.data(), n);

    // w_(k+2) = s w_(k+1) + p w_k + q; a single motion leaves it open what the other one is.
    MatrixXcd recurrence(n - 2, 3);
    recurrence << w.segment(1, n - 2), w.head(n - 2), VectorXcd::Ones(n - 2);
    const Eigen::CompleteOrthogonalDecomposition<MatrixXcd> solver(recurrence);
    const VectorXcd                                         found = solver.solve(w.tail(n - 2));
    const Complex                root = std::sqrt(.25 * found[0] * found[0] + found[1]);
    const std::array<Complex, 2> factors{{.5 * found[0] + root, .5 * found[0] - root}};

    // How much of each there is.
    MatrixXcd motions(n, 3);
    for (Eigen::Index k = 0; k < n; ++k)
      motions.row(k) << std::pow(factors[0], double(k)), std::pow(factors[1], double(k)), 1.;
    const VectorXcd parts = motions.completeOrthogonalDecomposition().solve(w);
    const auto      size  = [&](const int m) { return std::abs(parts[m]) * motions.col(m).norm(); };
    const int       m     = size(0) > size(1) ? 0 : 1;

    BuildUpFit fit;
    fit.decay    = -std::log(std::abs(factors[m])) / interval;
    fit.beat     = std::arg(factors[m]) / interval;
    fit.start    = parts[m];
    fit.end      = parts[2];
    fit.residual = (w - motions * parts).norm() / w.norm();
    return fit;
  }

  Complex BuildUpFit::value(const double time) const
  {
    return end + start * std::exp(Complex(-decay, beat) * time);
  }
} // namespace vfife
