// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/complex.h>
#include <vfife/base/errors.h>
#include <vfife/fem/cyclic/cyclic_statics.h>
#include <vfife/model/body_frame.h>

#include <algorithm>
#include <set>

// Unknowns of sector k are those of sector 0, turned by k sectors. Border 0 of a sector are the
// unknowns of its own points on the border to the sector before, border 1 those of the images on
// the border to the next one, which are border 0 of that.
namespace vfife
{
  CyclicStatics::CyclicStatics(const FemSpace       &whole,
                               const FemSpace::Part &part,
                               const FemOptions     &options,
                               const double          rate,
                               const Communicator   &communicator)
    : body_(whole.model(), part.body, options, rate)
    , phase_(body_.n_sectors())
    , copies_(body_.sector(), whole, part)
    , communicator_(communicator)
  {
    find_hub(whole.model(), part.body);
    FemConstraints::Options constraints;
    constraints.open     = true;
    constraints.rotation = hub_;
    sector_ = std::make_unique<FemSystem>(body_.sector(), constraints, body_.communicator());
    factorize();
    if (pinned_)
      find_pin();
  }

  void CyclicStatics::find_hub(const Model &model, const unsigned int body)
  {
    const Constraint *hub = nullptr;
    for (const Constraint &constraint : model.constraints)
      if (constraint.body == body && (constraint.kind == ConstraintKind::free_rotation ||
                                      constraint.kind == ConstraintKind::rigid_hub))
        {
          if (hub != nullptr || !body_.turns())
            throw InputError("body \"" + body_.body().name() + "\": constraint \"" +
                             constraint.name + "\" is not the only constraint of its rotation");
          hub = &constraint;
        }
    // The angle of a rigid hub is no unknown. Points that turn by themselves leave the turn of
    // h = 0, which is pinned where the whole body's is: at the hub's first point.
    if (hub != nullptr && hub->kind == ConstraintKind::free_rotation)
      {
        hub_    = HubRotation::free;
        pinned_ = true;
        pin_    = *std::min_element(hub->nodes.begin(), hub->nodes.end());
      }
  }

  std::vector<unsigned int> CyclicStatics::find_border() const
  {
    const FemConstraints     &constraints = sector_->constraints();
    std::vector<unsigned int> border[2];
    for (const auto &[image, original] : body_.sector().images())
      // A point that hangs moves with others of its border.
      for (const auto &[point, side] : {std::pair(original, 0), std::pair(image, 1)})
        {
          std::set<unsigned int> own;
          if (body_.sector().hanging().count(point) != 0)
            continue;
          for (unsigned int c = 0; c < 3; ++c)
            for (const auto &term : constraints.line(3 * std::size_t(point) + c))
              own.insert(term.first);
          border[side].insert(border[side].end(), own.begin(), own.end());
        }
    border[0].insert(border[0].end(), border[1].begin(), border[1].end());
    return border[0];
  }

  void CyclicStatics::factorize()
  {
    const SystemMatrices matrices(*sector_, body_.options().mass, body_.options().strain);
    const double         rate = body_.rate();
    condensed_ =
      std::make_unique<Condensation>(rate != 0 ? matrices.spinning_stiffness(body_.equilibrium(),
                                                                             constant_rate(rate))
                                               : matrices.stiffness(constant_rate(0.)),
                                     find_border());
    const Eigen::MatrixXd &S = condensed_->border_matrix();
    n_border_                = S.rows() / 2;
    if (pinned_)
      turn_stiffness_ = S.trace() / turn_of_border().squaredNorm();
    bool unstable = condensed_->n_negative() > 0 || condensed_->n_zero() > 0;
    for (unsigned int h = communicator_.rank(); 2 * h <= body_.n_sectors() && !unstable;
         h += communicator_.size())
      {
        harmonics_.push_back({h, HermitianFactor(harmonic_matrix(h))});
        unstable = !harmonics_.back().factor.is_positive();
      }
    // The matrix of the whole body has as many negative eigenvalues as its parts.
    if (communicator_.any(unstable))
      throw NumericalError("body \"" + body_.body().name() +
                           "\": no stable equilibrium (the speed is too high)");
  }

  Eigen::MatrixXcd CyclicStatics::harmonic_matrix(const unsigned int number) const
  {
    // The energy of the sectors' borders x_k, x_(k+1) = x_k exp(i h alpha).
    const Eigen::MatrixXd &S = condensed_->border_matrix();
    const unsigned int     n = n_border_;
    Eigen::MatrixXcd       A = (S.topLeftCorner(n, n) + S.bottomRightCorner(n, n)).cast<Complex>() +
                         phase_(number, 1) * S.topRightCorner(n, n).cast<Complex>() +
                         std::conj(phase_(number, 1)) * S.bottomLeftCorner(n, n).cast<Complex>();
    if (number == 0 && pinned_)
      {
        const Eigen::VectorXcd turn = turn_of_border().cast<Complex>();
        A += turn_stiffness_ * turn * turn.adjoint();
      }
    return A;
  }

  double CyclicStatics::weight(const unsigned int harmonic) const
  {
    const unsigned int n = body_.n_sectors();
    return (harmonic == 0 || 2 * harmonic == n ? 1. : 2.) / n;
  }

  Matrix3 CyclicStatics::turned(const unsigned int sector) const
  {
    return rotation_about(compute_sector_axis(body_.body()).direction,
                          sector * body_.sector().sector_angle());
  }

  Eigen::VectorXd CyclicStatics::turn_of_border() const
  {
    const OwnedVector turn   = sector_->restrict_field(body_.turn());
    const auto        border = find_border();
    Eigen::VectorXd   x(n_border_);
    for (unsigned int b = 0; b < n_border_; ++b)
      x[b] = turn[border[b]];
    return x;
  }

  void CyclicStatics::find_pin()
  {
    // What is factorized is K + s b b^T, b the turn of all borders, since K alone has next to no
    // stiffness against it. K u = f + lambda e with e . u = 0 at the pin: u = A f + lambda A e +
    // mu A b with A = (K + s b b^T)^-1 and mu = s b . u, which gives two equations for both.
    const unsigned int n_sectors = body_.n_sectors();
    const Body        &body      = body_.body();
    const Vector3      tangent =
      body.axis.direction.cross(body.placement(body.node_positions()[pin_]) - body.axis.point)
        .normalized();
    std::vector<double> force(3 * std::size_t(copies_.n_points()), 0.);
    Eigen::Map<Vector3>(force.data() + 3 * std::size_t(pin_)) = tangent;

    const Eigen::VectorXd turn   = turn_of_border();
    const auto            border = find_border();
    Eigen::MatrixXd       b      = Eigen::MatrixXd::Zero(sector_->constraints().n(), n_sectors);
    for (unsigned int i = 0; i < n_border_; ++i)
      b.row(border[i]).setConstant(turn[i]);
    const Eigen::MatrixXd     Ab      = solve_sectors(b);
    const std::vector<double> of_pin  = expand(solve_sectors(restrict_forces(force))),
                              of_turn = expand(Ab);
    pin_fields_.resize(force.size(), 2);
    pin_fields_ << Eigen::Map<const Eigen::VectorXd>(of_pin.data(), of_pin.size()),
      Eigen::Map<const Eigen::VectorXd>(of_turn.data(), of_turn.size());
    Eigen::Matrix2d system;
    system.row(0)   = tangent.transpose() * pin_fields_.middleRows<3>(3 * std::size_t(pin_));
    system(1, 0)    = system(0, 1);
    system(1, 1)    = b.cwiseProduct(Ab).sum() - n_sectors / turn_stiffness_;
    pin_compliance_ = system.inverse();
  }

  unsigned int CyclicStatics::n_unknowns() const
  {
    return body_.n_sectors() * (sector_->constraints().n() - n_border_) - (pinned_ ? 1 : 0);
  }

  double CyclicStatics::memory() const
  {
    double sum = condensed_->memory();
    for (const Harmonic &harmonic : harmonics_)
      sum += harmonic.factor.memory();
    return sum;
  }
} // namespace vfife
