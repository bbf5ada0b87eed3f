// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "matrix_stream.h"

#include <vfife/base/errors.h>
#include <vfife/reduced/modal_motion.h>
#include <vfife/reduced/reduced_body.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>
#include <complex>
#include <sstream>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::VectorXcd;

  void ModalForces::add(const double factor, const ModalForces &other)
  {
    for (std::size_t i = 0; i < modes.size(); ++i)
      modes[i] += factor * other.modes[i];
    moment += factor * other.moment;
  }

  ModalMotion::ModalMotion(const ReducedBody  &body,
                           const double        rate,
                           const ModalDamping &damping,
                           const double        step)
    : body_(body)
    , damping_(damping)
    , harmonics_(body.harmonics.size())
    , turn_scale_(body.turns ? std::sqrt(body.turn_inertia) : 0.)
  {
    for (std::size_t i = 0; i < harmonics_.size(); ++i)
      {
        harmonics_[i].position = harmonics_[i].velocity =
          VectorXcd::Zero(body.harmonics[i].n_modes());
        if (i < damping_.more.size())
          harmonics_[i].damping = damping_.more[i];
        if (i < damping_.circulation.size())
          harmonics_[i].circulation = damping_.circulation[i];
      }
    change(rate, step);
  }

  void ModalMotion::change(const double rate, const double step)
  {
    rate_                = rate;
    const double further = rate * rate - body_.rate * body_.rate;
    for (std::size_t i = 0; i < harmonics_.size(); ++i)
      {
        const ReducedBody::Harmonic &modes    = body_.harmonics[i];
        Harmonic                    &harmonic = harmonics_[i];
        harmonic.stiffness = modes.eigenvalues.cast<std::complex<double>>().asDiagonal();
        harmonic.stiffness += further * modes.spin_stiffness;
        const Eigen::LLT<MatrixXcd> factor(harmonic.stiffness);
        if (factor.info() != Eigen::Success)
          {
            std::ostringstream text;
            text << "a reduced body is not stable at " << rate * 30. / pi << " rpm: its modes with "
                 << modes.number << " nodal diameters were found at " << body_.rate * 30. / pi
                 << " rpm";
            throw NumericalError(text.str());
          }
        if (!has_turn(i))
          {
            find_propagator(harmonic, 2. * rate * modes.coriolis, step);
            continue;
          }
        // The rigid turn is one more coordinate of h = 0, scaled like the modes.
        const Eigen::Index n         = modes.n_modes();
        MatrixXcd          coupling  = MatrixXcd::Zero(n + 1, n + 1);
        coupling.topLeftCorner(n, n) = 2. * rate * modes.coriolis;
        const Eigen::VectorXd turning =
          n > 0 ? Eigen::VectorXd(2. * rate / turn_scale_ * body_.turn_coriolis)
                : Eigen::VectorXd(0);
        coupling.col(n).head(n) = -turning.cast<std::complex<double>>();
        coupling.row(n).head(n) = turning.transpose().cast<std::complex<double>>();
        find_propagator(harmonic, coupling, step);
        turn_gain_ = harmonic.gain(n, n).real() / body_.turn_inertia;
        harmonic.gain.conservativeResize(n, n);
      }
  }

  bool ModalMotion::has_turn(const std::size_t i) const
  {
    return turn_scale_ > 0 && body_.harmonics[i].number == 0;
  }

  void ModalMotion::find_propagator(Harmonic        &harmonic,
                                    const MatrixXcd &coupling,
                                    const double     step) const
  {
    // (c, c')' = A (c, c') + B g: exp(h [A B; 0 0]) = [exp(h A)  integral of exp(s A) B; 0 1].
    // With c'/w in the place of c', w the highest frequency, A is balanced and its exponential
    // exact to round-off.
    const Eigen::Index n = coupling.rows(), n_modes = harmonic.stiffness.rows();
    const double w = n_modes > 0 ? std::sqrt(harmonic.stiffness.cwiseAbs().maxCoeff()) : 1. / step;
    MatrixXcd    all                  = MatrixXcd::Zero(3 * n, 3 * n);
    all.block(0, n, n, n)             = w * MatrixXcd::Identity(n, n);
    all.block(n, 0, n_modes, n_modes) = -harmonic.stiffness / w;
    all.block(n, n, n, n)             = -coupling;
    for (Eigen::Index k = 0; k < n; ++k)
      all(n + k, n + k) -= k < n_modes ? damping_.modes : damping_.turn;
    if (harmonic.damping.size() > 0)
      all.block(n, n, n_modes, n_modes) -= harmonic.damping;
    if (harmonic.circulation.size() > 0)
      all.block(n, 0, n_modes, n_modes) -= rate_ / w * harmonic.circulation;
    all.block(n, 2 * n, n, n) = MatrixXcd::Identity(n, n) / w;
    MatrixXcd moved           = MatrixXcd(step * all).exp();
    moved.middleRows(n, n) *= w;
    moved.middleCols(n, n) /= w;
    harmonic.propagator = moved.topLeftCorner(2 * n, 2 * n);
    harmonic.forced     = moved.topRightCorner(2 * n, n);
    harmonic.gain       = .5 * harmonic.forced.topRows(n);
  }

  ModalForces ModalMotion::no_forces() const
  {
    ModalForces forces;
    for (const Harmonic &harmonic : harmonics_)
      forces.modes.push_back(VectorXcd::Zero(harmonic.position.size()));
    return forces;
  }

  VectorXcd ModalMotion::force_of(const std::size_t i, const ModalForces &forces) const
  {
    if (!has_turn(i))
      return forces.modes[i];
    VectorXcd force(forces.modes[i].size() + 1);
    force << forces.modes[i], forces.moment / turn_scale_;
    return force;
  }

  VectorXcd ModalMotion::end_of_step(const std::size_t i, const ModalForces &forces) const
  {
    const Harmonic    &harmonic = harmonics_[i];
    const Eigen::Index n = harmonic.position.size(), size = harmonic.forced.cols();
    VectorXcd          state(2 * size);
    state.head(n)          = harmonic.position;
    state.segment(size, n) = harmonic.velocity;
    if (has_turn(i))
      {
        state[n]        = turn_scale_ * turn_;
        state[size + n] = turn_scale_ * turn_rate_;
      }
    return harmonic.propagator * state + harmonic.forced * force_of(i, forces);
  }

  VectorXcd ModalMotion::expect(const std::size_t i, const ModalForces &forces) const
  {
    return end_of_step(i, forces).head(harmonics_[i].position.size());
  }

  double ModalMotion::expect_turn(const ModalForces &forces) const
  {
    for (std::size_t i = 0; i < harmonics_.size(); ++i)
      if (has_turn(i))
        return end_of_step(i, forces)[harmonics_[i].position.size()].real() / turn_scale_;
    return turn_;
  }

  MatrixXcd ModalMotion::standing_flexibility(const std::size_t i, const double sector_rate) const
  {
    // c ~ exp(i w t), w = h sector_rate: the body's inertia and Coriolis forces act on what stands.
    const ReducedBody::Harmonic &modes = body_.harmonics[i];
    const MatrixXcd &K = harmonics_[i].stiffness, one = MatrixXcd::Identity(K.rows(), K.cols());
    const double     w = 2 * modes.number == body_.n_sectors ? 0. : modes.number * sector_rate;
    const Eigen::LLT<MatrixXcd> standing(
      MatrixXcd(K - w * w * one + std::complex<double>(0., 2. * rate_ * w) * modes.coriolis));
    return standing.info() == Eigen::Success ? standing.solve(one) : MatrixXcd(K.llt().solve(one));
  }

  void ModalMotion::advance(const ModalForces &forces)
  {
    for (std::size_t i = 0; i < harmonics_.size(); ++i)
      {
        Harmonic          &harmonic = harmonics_[i];
        const VectorXcd    state    = end_of_step(i, forces);
        const Eigen::Index n = harmonic.position.size(), size = harmonic.forced.cols();
        harmonic.position = state.head(n);
        harmonic.velocity = state.segment(size, n);
        if (has_turn(i))
          {
            turn_      = state[n].real() / turn_scale_;
            turn_rate_ = state[size + n].real() / turn_scale_;
          }
      }
  }

  void ModalMotion::stand(const ModalForces &forces, const double turn, const double sector_rate)
  {
    turn_      = turn;
    turn_rate_ = 0;
    // Sector k has what sector 0 had when it was there.
    for (std::size_t i = 0; i < harmonics_.size(); ++i)
      {
        Harmonic &harmonic = harmonics_[i];
        harmonic.position  = standing_flexibility(i, sector_rate) * forces.modes[i];
        harmonic.velocity =
          std::complex<double>(0., body_.harmonics[i].number * sector_rate) * harmonic.position;
        if (2 * body_.harmonics[i].number == body_.n_sectors)
          harmonic.velocity.setZero(); // its phase is real
      }
  }

  double ModalMotion::kinetic() const
  {
    double sum = 0;
    for (const Harmonic &harmonic : harmonics_)
      sum += .5 * harmonic.velocity.squaredNorm();
    return sum;
  }

  double ModalMotion::strain() const
  {
    double sum = 0;
    for (const Harmonic &harmonic : harmonics_)
      sum += .5 * harmonic.position.dot(harmonic.stiffness * harmonic.position).real();
    return sum;
  }

  std::pair<double, double> ModalMotion::losses() const
  {
    double modes = 2. * damping_.modes * kinetic();
    for (const Harmonic &harmonic : harmonics_)
      {
        if (harmonic.damping.size() > 0)
          modes += harmonic.velocity.dot(harmonic.damping * harmonic.velocity).real();
        // Of the energies in the turning axes.
        if (harmonic.circulation.size() > 0)
          modes += rate_ * harmonic.velocity.dot(harmonic.circulation * harmonic.position).real();
      }
    return {modes, damping_.turn * body_.turn_inertia * turn_rate_ * turn_rate_};
  }

  double ModalMotion::added_inertia() const
  {
    for (std::size_t i = 0; i < harmonics_.size(); ++i)
      if (has_turn(i) && harmonics_[i].position.size() > 0)
        return 2. * body_.turn_coriolis.dot(harmonics_[i].position.real());
    return 0.;
  }

  void ModalMotion::serialize(ByteStream &stream)
  {
    for (Harmonic &harmonic : harmonics_)
      {
        const Eigen::Index n = harmonic.position.size();
        pass_matrix(harmonic.position, stream);
        pass_matrix(harmonic.velocity, stream);
        stream.require(harmonic.position.size() == n && harmonic.velocity.size() == n,
                       "the motion of other modes");
      }
    stream.pass(turn_, turn_rate_);
  }
} // namespace vfife
