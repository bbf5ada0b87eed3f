// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/fem/cyclic/border_harmonics.h>

namespace vfife
{
  BorderHarmonics::BorderHarmonics(const Eigen::MatrixXd          &S,
                                   const unsigned int              n_sectors,
                                   const std::vector<BorderBrace> &braces,
                                   const Communicator             &communicator)
    : n_border_(S.rows() / 2)
    , n_sectors_(n_sectors)
    , phase_(n_sectors)
    , communicator_(communicator)
  {
    for (unsigned int h = communicator.rank(); 2 * h <= n_sectors && positive_;
         h += communicator.size())
      {
        harmonics_.push_back({h, HermitianFactor(make_matrix(S, h, braces))});
        positive_ = harmonics_.back().factor.is_positive();
      }
  }

  Eigen::MatrixXcd BorderHarmonics::make_matrix(const Eigen::MatrixXd          &S,
                                                const unsigned int              number,
                                                const std::vector<BorderBrace> &braces) const
  {
    // The energy of the sectors' borders x_k, x_(k+1) = x_k exp(i h alpha).
    const unsigned int n = n_border_;
    Eigen::MatrixXcd   A = (S.topLeftCorner(n, n) + S.bottomRightCorner(n, n)).cast<Complex>() +
                         phase_(number, 1) * S.topRightCorner(n, n).cast<Complex>() +
                         std::conj(phase_(number, 1)) * S.bottomLeftCorner(n, n).cast<Complex>();
    for (const BorderBrace &brace : braces)
      if (brace.harmonic == number)
        A += brace.stiffness * brace.motion * brace.motion.adjoint();
    return A;
  }

  double BorderHarmonics::weight(const unsigned int harmonic) const
  {
    return (harmonic == 0 || 2 * harmonic == n_sectors_ ? 1. : 2.) / n_sectors_;
  }

  Eigen::MatrixXd BorderHarmonics::solve(const Eigen::MatrixXd &loads) const
  {
    // A load on border 1 acts on border 0 of the next sector: g_h = sum over k of exp(-i h k alpha)
    // (g_0 + exp(-i h alpha) g_1), and x_k = sum over h of w Re(x_h exp(i h k alpha)).
    const unsigned int n = n_border_;
    Eigen::MatrixXd    x = Eigen::MatrixXd::Zero(n, n_sectors_);
    // All harmonics at once, in real arithmetic.
    const Eigen::Index n_harmonics = harmonics_.size();
    Eigen::MatrixXd    cosines(n_sectors_, n_harmonics), sines(n_sectors_, n_harmonics);
    for (Eigen::Index i = 0; i < n_harmonics; ++i)
      for (unsigned int k = 0; k < n_sectors_; ++k)
        {
          const Complex phase = phase_(harmonics_[i].number, k);
          cosines(k, i)       = phase.real();
          sines(k, i)         = phase.imag();
        }
    const Eigen::MatrixXd with_cosine = loads * cosines, with_sine = loads * sines;
    Eigen::MatrixXd       real(n, n_harmonics), imaginary(n, n_harmonics);
    for (Eigen::Index i = 0; i < n_harmonics; ++i)
      {
        const Harmonic        &harmonic = harmonics_[i];
        const Eigen::VectorXcd all      = with_cosine.col(i) - Complex(0., 1.) * with_sine.col(i);
        const Eigen::VectorXcd on_border =
          all.head(n) + std::conj(phase_(harmonic.number, 1)) * all.tail(n);
        const Eigen::VectorXcd answer = weight(harmonic.number) * harmonic.factor.solve(on_border);
        real.col(i)                   = answer.real();
        imaginary.col(i)              = answer.imag();
      }
    x += real * cosines.transpose() - imaginary * sines.transpose();
    communicator_.sum(x.data(), x.size());
    Eigen::MatrixXd both(2 * n, n_sectors_);
    for (unsigned int k = 0; k < n_sectors_; ++k)
      both.col(k) << x.col(k), x.col((k + 1) % n_sectors_);
    return both;
  }

  std::map<unsigned int, Eigen::MatrixXd>
  BorderHarmonics::find_flexibility(const Eigen::MatrixXd        &loads,
                                    const std::set<unsigned int> &distances) const
  {
    std::map<unsigned int, Eigen::MatrixXd> sums;
    for (const unsigned int d : distances)
      sums[d] = Eigen::MatrixXd::Zero(loads.cols(), loads.cols());
    const unsigned int n = n_border_;
    for (const Harmonic &harmonic : harmonics_)
      {
        const unsigned int     h = harmonic.number;
        const Eigen::MatrixXcd A =
          weight(h) *
          harmonic.factor.project(loads.topRows(n).cast<Complex>() +
                                  std::conj(phase_(h, 1)) * loads.bottomRows(n).cast<Complex>());
        for (auto &[d, flexibility] : sums)
          flexibility += phase_(h, d).real() * A.real() - phase_(h, d).imag() * A.imag();
      }
    for (auto &[d, flexibility] : sums)
      communicator_.sum(flexibility.data(), flexibility.size());
    return sums;
  }

  double BorderHarmonics::memory() const
  {
    double sum = 0;
    for (const Harmonic &harmonic : harmonics_)
      sum += harmonic.factor.memory();
    return sum;
  }
} // namespace vfife
