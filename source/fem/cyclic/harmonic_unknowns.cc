// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/cyclic/harmonic_unknowns.h>

#include <algorithm>
#include <map>

namespace vfife
{
  using Eigen::Index;
  using Eigen::MatrixXcd;
  using Eigen::MatrixXd;

  HarmonicUnknowns::HarmonicUnknowns(const CyclicSector &sector, const unsigned int number)
    : sector_(sector)
    , number_(number)
    , n_parts_(number > 0 && 2 * number < sector.body().n_sectors() ? 2 : 1)
    , roots_(sector.body().n_sectors())
  {
    const SectorUnknowns &unknowns = sector.unknowns();
    const unsigned int    n        = sector.system().constraints().n();
    std::vector<bool>     is_own(n, true);
    for (const unsigned int unknown : unknowns.borders[1])
      is_own[unknown] = false;
    // A hub's angle is the same in all sectors: waves have none.
    if (number > 0)
      for (const unsigned int unknown : unknowns.hubs)
        is_own[unknown] = false;
    for (unsigned int unknown = 0; unknown < n; ++unknown)
      if (is_own[unknown])
        own_.push_back(unknown);
    n_kept_ =
      unknowns.borders[0].size() + unknowns.seats.size() + (number == 0 ? unknowns.hubs.size() : 0);
    find_rings();
  }

  void HarmonicUnknowns::find_rings()
  {
    if (number_ > 1)
      return;
    const FemSpace               &space = sector_.system().space();
    const BearingRings            rings(space, HousingLaw::joins_seats, number_);
    const double                  rate = sector_.body().rate();
    const auto                    kept = sector_.unknowns().kept();
    std::map<unsigned int, Index> place;
    for (std::size_t k = 0; k < kept.size(); ++k)
      place[kept[k]] = k;
    ring_stiffness_ = rings.stiffness(constant_rate(rate));
    // In h = 1 rings move by Re(W z) = B_1 Re(z) + B_2 Im(z), and the mean of the energy over a
    // turn is half of that of W z (BearingRings, One sector).
    if (n_parts_ == 2)
      ring_stiffness_ *= .5;
    ring_motion_ = MatrixXcd::Zero(ring_stiffness_.rows(), kept.size());
    for (std::size_t r = 0; r < rings.list().size(); ++r)
      {
        const BearingRing &ring = rings.list()[r];
        for (std::size_t i = 0; i < ring.points.size(); ++i)
          {
            const bool         is_real = ring.points[i] < space.n_points();
            const unsigned int point   = ring.points[i] - (is_real ? 0 : space.n_points());
            for (unsigned int c = 0; c < 3; ++c)
              for (const auto &[unknown, coefficient] :
                   sector_.system().constraints().line(3 * std::size_t(point) + c))
                ring_motion_.col(place.at(unknown)).segment<6>(6 * r) +=
                  (is_real ? Complex(coefficient) : Complex(0., -coefficient)) *
                  ring.motion.col(3 * i + c).cast<Complex>();
          }
      }
  }

  MatrixXcd HarmonicUnknowns::join_parts(const MatrixXd &parts) const
  {
    if (n_parts_ == 1)
      return parts.cast<Complex>();
    MatrixXcd phasors(parts.rows(), parts.cols() / 2);
    for (Index k = 0; k < phasors.cols(); ++k)
      {
        phasors.col(k).real() = parts.col(2 * k);
        phasors.col(k).imag() = parts.col(2 * k + 1);
      }
    return phasors;
  }

  MatrixXd HarmonicUnknowns::split_parts(const MatrixXcd &phasors) const
  {
    MatrixXd parts(phasors.rows(), n_parts_ * phasors.cols());
    for (Index k = 0; k < phasors.cols(); ++k)
      {
        parts.col(n_parts_ * k) = phasors.col(k).real();
        if (n_parts_ == 2)
          parts.col(2 * k + 1) = phasors.col(k).imag();
      }
    return parts;
  }

  MatrixXd HarmonicUnknowns::expand(const Columns &x) const
  {
    const auto &[first, second] = sector_.unknowns().borders;
    const Index n               = own_.size();
    MatrixXd    u = MatrixXd::Zero(sector_.system().constraints().n(), n_parts_ * x.n());
    for (std::size_t k = 0; k < x.n(); ++k)
      {
        const Index column = n_parts_ * k;
        for (unsigned int part = 0; part < n_parts_; ++part)
          for (Index i = 0; i < n; ++i)
            u(own_[i], column + part) = x[k][part * n + i];
        for (std::size_t b = 0; b < first.size(); ++b)
          {
            const Complex z(u(first[b], column), n_parts_ == 2 ? u(first[b], column + 1) : 0.);
            u(second[b], column) = (phase(1) * z).real();
            if (n_parts_ == 2)
              u(second[b], column + 1) = (phase(1) * z).imag();
          }
      }
    return u;
  }

  void HarmonicUnknowns::take(const MatrixXd &u, Columns &x) const
  {
    const Index n = own_.size();
    for (std::size_t k = 0; k < x.n(); ++k)
      for (unsigned int part = 0; part < n_parts_; ++part)
        for (Index i = 0; i < n; ++i)
          x[k][part * n + i] = u(own_[i], n_parts_ * k + part);
  }

  void HarmonicUnknowns::fold(const MatrixXd &forces, Columns &x) const
  {
    const auto &[first, second] = sector_.unknowns().borders;
    MatrixXd all                = forces;
    for (std::size_t k = 0; k < x.n(); ++k)
      for (std::size_t b = 0; b < first.size(); ++b)
        {
          const Index   column = n_parts_ * k;
          const Complex f =
            std::conj(phase(1)) *
            Complex(all(second[b], column), n_parts_ == 2 ? all(second[b], column + 1) : 0.);
          all(first[b], column) += f.real();
          if (n_parts_ == 2)
            all(first[b], column + 1) += f.imag();
        }
    take(all, x);
  }

  MatrixXcd HarmonicUnknowns::make_matrix(const MatrixXd &S) const
  {
    // The energy of a sector whose second border moves by the phase times the first.
    const Index     n = sector_.unknowns().borders[0].size(), m = n_kept_ - n;
    const MatrixXcd border = (S.topLeftCorner(n, n) + S.block(n, n, n, n)).cast<Complex>() +
                             phase(1) * S.block(0, n, n, n).cast<Complex>() +
                             std::conj(phase(1)) * S.block(n, 0, n, n).cast<Complex>();
    MatrixXcd A(n_kept_, n_kept_);
    A.topLeftCorner(n, n) = border;
    A.bottomLeftCorner(m, n) =
      S.block(2 * n, 0, m, n).cast<Complex>() + phase(1) * S.block(2 * n, n, m, n).cast<Complex>();
    A.topRightCorner(n, m)    = A.bottomLeftCorner(m, n).adjoint();
    A.bottomRightCorner(m, m) = S.block(2 * n, 2 * n, m, m).cast<Complex>();
    if (ring_stiffness_.size() > 0)
      {
        const MatrixXcd W = fold_kept(ring_motion_.adjoint());
        A += W * ring_stiffness_.cast<Complex>() * W.adjoint();
      }
    return A;
  }

  MatrixXcd HarmonicUnknowns::fold_kept(const MatrixXcd &forces) const
  {
    const Index n = sector_.unknowns().borders[0].size(), m = n_kept_ - n;
    MatrixXcd   x(n_kept_, forces.cols());
    x.topRows(n)    = forces.topRows(n) + std::conj(phase(1)) * forces.middleRows(n, n);
    x.bottomRows(m) = forces.middleRows(2 * n, m);
    return x;
  }

  MatrixXcd HarmonicUnknowns::expand_kept(const MatrixXcd &x) const
  {
    const Index n = sector_.unknowns().borders[0].size(), m = n_kept_ - n;
    MatrixXcd   u          = MatrixXcd::Zero(sector_.part_loads().rows(), x.cols());
    u.topRows(n)           = x.topRows(n);
    u.middleRows(n, n)     = phase(1) * x.topRows(n);
    u.middleRows(2 * n, m) = x.bottomRows(m);
    return u;
  }

  void HarmonicUnknowns::add_ring_forces(const MatrixXd &u, MatrixXd &forces) const
  {
    if (ring_stiffness_.size() == 0)
      return;
    const auto kept = sector_.unknowns().kept();
    MatrixXd   on_kept(kept.size(), u.cols());
    for (std::size_t k = 0; k < kept.size(); ++k)
      on_kept.row(k) = u.row(kept[k]);
    const MatrixXd exerted =
      split_parts(ring_motion_.adjoint() *
                  (ring_stiffness_.cast<Complex>() * (ring_motion_ * join_parts(on_kept))));
    for (std::size_t k = 0; k < kept.size(); ++k)
      forces.row(kept[k]) += exerted.row(k);
  }
} // namespace vfife
