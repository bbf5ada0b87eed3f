// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Forces and displacements of all sectors, with the factors of CyclicStatics.
#include <vfife/base/complex.h>
#include <vfife/base/errors.h>
#include <vfife/fem/cyclic/cyclic_statics.h>

#include <algorithm>
#include <set>

namespace vfife
{
  void CyclicStatics::add_sector(const unsigned int         k,
                                 const std::vector<double> &u,
                                 std::vector<double>       &all) const
  {
    const Matrix3 turn = turned(k);
    for (const unsigned int p : copies_.own_points())
      Eigen::Map<Vector3>(all.data() + 3 * std::size_t(copies_.copy(p, k))) =
        turn * Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(p));
  }

  std::vector<double> CyclicStatics::spun() const
  {
    std::vector<double> u(3 * std::size_t(copies_.n_points()));
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      add_sector(k, body_.equilibrium(), u);
    return u;
  }

  Eigen::MatrixXd CyclicStatics::solve_borders(const Eigen::MatrixXd &loads) const
  {
    // A load on border 1 acts on border 0 of the next sector: g_h = sum over k of exp(-i h k alpha)
    // (g_0 + exp(-i h alpha) g_1), and x_k = sum over h of w Re(x_h exp(i h k alpha)).
    const unsigned int n = n_border_, n_sectors = loads.cols();
    Eigen::MatrixXd    x = Eigen::MatrixXd::Zero(n, n_sectors);
    // All harmonics at once, in real arithmetic.
    const Eigen::Index n_harmonics = harmonics_.size();
    Eigen::MatrixXd    cosines(n_sectors, n_harmonics), sines(n_sectors, n_harmonics);
    for (Eigen::Index i = 0; i < n_harmonics; ++i)
      for (unsigned int k = 0; k < n_sectors; ++k)
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
    Eigen::MatrixXd both(2 * n, n_sectors);
    for (unsigned int k = 0; k < n_sectors; ++k)
      both.col(k) << x.col(k), x.col((k + 1) % n_sectors);
    return both;
  }

  Eigen::MatrixXd CyclicStatics::restrict_forces(const std::vector<double> &forces) const
  {
    // Forces of each sector in the axes of sector 0; none on the images of the next one's.
    std::vector<double> at_points(3 * std::size_t(body_.sector().n_points()), 0.);
    Eigen::MatrixXd     x(sector_->constraints().n(), body_.n_sectors());
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      {
        const Matrix3 back = turned(k).transpose();
        for (const unsigned int p : copies_.own_points())
          Eigen::Map<Vector3>(at_points.data() + 3 * std::size_t(p)) =
            back * Eigen::Map<const Vector3>(forces.data() + 3 * std::size_t(copies_.copy(p, k)));
        const OwnedVector loads = sector_->restrict_forces(at_points);
        x.col(k)                = Eigen::Map<const Eigen::VectorXd>(loads.data(), loads.size());
      }
    return x;
  }

  std::vector<double> CyclicStatics::expand(const Eigen::MatrixXd &x) const
  {
    std::vector<double> u(3 * std::size_t(copies_.n_points()));
    for (unsigned int k = 0; k < body_.n_sectors(); ++k)
      add_sector(k, sector_->expand(OwnedVector(x.col(k).data(), x.col(k).data() + x.rows())), u);
    return u;
  }

  Eigen::MatrixXd CyclicStatics::solve_sectors(Eigen::MatrixXd x) const
  {
    // Down to the borders, around the body, and back.
    condensed_->solve(x, [this](const Eigen::MatrixXd &loads) { return solve_borders(loads); });
    return x;
  }

  std::vector<double> CyclicStatics::solve(const std::vector<double> &forces) const
  {
    std::vector<double> u = expand(solve_sectors(restrict_forces(forces)));
    if (pinned_)
      Eigen::Map<Eigen::VectorXd>(u.data(), u.size()) -=
        pin_fields_ *
        (pin_compliance_ * (pin_fields_.transpose() *
                            Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size())));
    return u;
  }

  void CyclicStatics::watch(std::vector<Watched> points)
  {
    // 1. The points as copies of those of sector 0.
    watched_ = std::move(points);
    std::map<Copy, const Watched *> originals;
    std::set<unsigned int>          sectors;
    for (const Watched &watched : watched_)
      {
        const unsigned int sector = copies_.sector_of(watched.point);
        for (const auto &weight : watched.weights)
          if (copies_.sector_of(weight.first) != sector)
            throw InputError("body \"" + body_.body().name() +
                             "\": a contact surface crosses the border of two sectors");
        originals.emplace(copy_of(watched), &watched);
        sectors.insert(sector);
      }
    // Flexibilities of more points and sectors serve fewer of them.
    std::vector<Copy> locals;
    for (const auto &original : originals)
      locals.push_back(original.first);
    std::set<unsigned int> distances;
    for (const unsigned int from : sectors)
      for (const unsigned int to : sectors)
        distances.insert((to + body_.n_sectors() - from) % body_.n_sectors());
    if (std::includes(locals_.begin(), locals_.end(), locals.begin(), locals.end()) &&
        std::all_of(distances.begin(), distances.end(), [this](const unsigned int d) {
          return flexibility_.count(d) != 0;
        }))
      return;
    locals_ = std::move(locals);
    flexibility_.clear();
    if (watched_.empty())
      return;

    // 2. Unit forces at these points: what the sector does with its borders held, and the loads on
    // them. The transpose of these is what the points do as the borders move.
    const unsigned int  m = 3 * locals_.size();
    Eigen::MatrixXd     x(sector_->constraints().n(), m), loads;
    std::vector<double> unit(3 * std::size_t(body_.sector().n_points()), 0.);
    for (unsigned int i = 0; i < m; ++i)
      {
        const auto set = [&](const double force) {
          for (const auto &[point, weight] : originals.at(locals_[i / 3])->weights)
            unit[3 * std::size_t(copies_.original_of(point)) + i % 3] = force * weight;
        };
        set(1.);
        const OwnedVector force = sector_->restrict_forces(unit);
        x.col(i)                = Eigen::Map<const Eigen::VectorXd>(force.data(), force.size());
        set(0.);
      }
    const Eigen::MatrixXd forces = x;
    condensed_->solve(x, [&loads](const Eigen::MatrixXd &on_borders) -> Eigen::MatrixXd {
      loads = on_borders;
      return Eigen::MatrixXd::Zero(on_borders.rows(), on_borders.cols());
    });

    // 3. Around the body, for all pairs of sectors that are asked for.
    for (const unsigned int d : distances)
      flexibility_[d] = Eigen::MatrixXd::Zero(m, m);
    const unsigned int n = n_border_;
    for (const Harmonic &harmonic : harmonics_)
      {
        const unsigned int     h = harmonic.number;
        const Eigen::MatrixXcd A =
          weight(h) *
          harmonic.factor.project(loads.topRows(n).cast<Complex>() +
                                  std::conj(phase_(h, 1)) * loads.bottomRows(n).cast<Complex>());
        for (auto &[d, flexibility] : flexibility_)
          flexibility += phase_(h, d).real() * A.real() - phase_(h, d).imag() * A.imag();
      }
    for (auto &[d, flexibility] : flexibility_)
      communicator_.sum(flexibility.data(), flexibility.size());
    flexibility_.at(0) += forces.transpose() * x;
  }

  Eigen::VectorXd CyclicStatics::column(const std::size_t  watched,
                                        const unsigned int component) const
  {
    const unsigned int n_sectors = body_.n_sectors();
    const auto         local     = [&](const Watched &point) {
      return 3 *
             (std::lower_bound(locals_.begin(), locals_.end(), copy_of(point)) - locals_.begin());
    };
    // The force in the axes of its sector, each displacement in those of its own.
    const unsigned int at = watched_[watched].point, from = copies_.sector_of(at);
    const Vector3      force = turned(from).transpose().col(component);
    Eigen::Vector2d    held  = Eigen::Vector2d::Zero();
    if (pinned_)
      held = pin_compliance_ * pin_field_of(watched_[watched]).row(component).transpose();
    Eigen::VectorXd u(3 * watched_.size());
    for (std::size_t i = 0; i < watched_.size(); ++i)
      {
        const unsigned int     to = copies_.sector_of(watched_[i].point);
        const Eigen::MatrixXd &A  = flexibility_.at((to + n_sectors - from) % n_sectors);
        u.segment<3>(3 * i) =
          turned(to) * A.block<3, 3>(local(watched_[i]), local(watched_[watched])) * force;
        if (pinned_)
          u.segment<3>(3 * i) -= pin_field_of(watched_[i]) * held;
      }
    return u;
  }

  CyclicStatics::Copy CyclicStatics::copy_of(const Watched &watched) const
  {
    return {copies_.original_of(watched.point), watched.kind};
  }

  Eigen::MatrixXd CyclicStatics::pin_field_of(const Watched &watched) const
  {
    Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(3, pin_fields_.cols());
    for (const auto &[point, weight] : watched.weights)
      mean += weight * pin_fields_.middleRows<3>(3 * std::size_t(point));
    return mean;
  }
} // namespace vfife
