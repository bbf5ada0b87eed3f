// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/reduced/resonance/linear_response.h>
#include <vfife/reduced/resonance/static_passage.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::MatrixXd;
  using Eigen::VectorXcd;

  LinearResponse::LinearResponse(const ReducedBody   &body,
                                 const StaticPassage &passage,
                                 const ModalDamping  &damping,
                                 const double         sense,
                                 const double         driven_sense)
    : body_(body)
    , passage_(passage)
    , damping_(damping)
    , sense_(sense)
    , compliance_(1. / passage.stiffness())
  {
    // Of the turn of the hub under a torque that the contact balances: the modes' part.
    for (std::size_t k = 0; k < body.harmonics.size(); ++k)
      {
        per_moment_.push_back(passage.force(k, 0) / passage.moment());
        VectorXcd force = per_moment_[k];
        if (body.harmonics[k].number == 0)
          force -= driven_sense * body.harmonics[k].torque;
        compliance_ -= force.dot(answer(k, 0., 0., force)).real();
      }
  }

  Complex LinearResponse::mesh_frequency(const int p, const Complex &rate) const
  {
    return double(p * int(body_.n_sectors)) * sense_ * rate;
  }

  VectorXcd LinearResponse::answer(const std::size_t harmonic,
                                   const Complex    &frequency,
                                   const Complex    &rate,
                                   const VectorXcd  &force) const
  {
    const ReducedBody::Harmonic &modes = body_.harmonics[harmonic];
    const Complex                omega = frequency + double(modes.number) * sense_ * rate;
    MatrixXcd matrix = (rate * rate - body_.rate * body_.rate) * modes.spin_stiffness;
    matrix += modes.eigenvalues.cast<Complex>().asDiagonal();
    matrix += 2. * imaginary_unit * rate * omega * modes.coriolis;
    matrix.diagonal().array() += -omega * omega + imaginary_unit * damping_.modes * omega;
    return matrix.partialPivLu().solve(force);
  }

  Complex LinearResponse::flank_turn(const Complex &frequency,
                                     const Complex &rate,
                                     const ForceOf &force) const
  {
    // conj(f(conj(x))) is analytic in x where f is.
    Complex sum = 0;
    for (std::size_t k = 0; k < body_.harmonics.size(); ++k)
      {
        const auto turn = [&](const Complex &at, const Complex &turning, const int sign) {
          return per_moment_[k].dot(answer(k, at, turning, force(k, sign)));
        };
        sum += .5 * (turn(frequency, rate, 1) +
                     std::conj(turn(-std::conj(frequency), std::conj(rate), -1)));
      }
    return sum;
  }

  Complex LinearResponse::turn_compliance(const Complex &frequency) const
  {
    return 1. / (body_.turn_inertia *
                 (-frequency * frequency + imaginary_unit * damping_.turn * frequency));
  }

  Complex LinearResponse::turn(const int p, const Complex &rate, const Complex &moment) const
  {
    return moment * turn_compliance(mesh_frequency(p, rate));
  }

  Complex LinearResponse::loop_compliance(const Complex &frequency, const Complex &rate) const
  {
    return compliance_ + turn_compliance(frequency) +
           flank_turn(frequency, rate, [this](const std::size_t k, int) { return per_moment_[k]; });
  }

  Complex LinearResponse::moment(const int p, const Complex &rate) const
  {
    if (p < 0)
      return std::conj(moment(-p, std::conj(rate)));
    // The spring is as long as at rest where the flank is where it would be there.
    const auto force = [&](const std::size_t k, const int sign) {
      return passage_.force(k, sign * p);
    };
    return (passage_.turn(p) + flank_turn(0., 0., force) -
            flank_turn(mesh_frequency(p, rate), rate, force)) /
           loop_compliance(mesh_frequency(p, rate), rate);
  }

  VectorXcd LinearResponse::coordinates(const std::size_t harmonic,
                                        const int         p,
                                        const Complex    &rate,
                                        const Complex    &moment) const
  {
    return answer(harmonic,
                  mesh_frequency(p, rate),
                  rate,
                  passage_.force(harmonic, p) + moment * per_moment_[harmonic]);
  }

  std::vector<Complex> LinearResponse::free_vibrations(const double rate) const
  {
    // In axes that stand in space a harmonic's coordinates are c exp(-i h phi) = q, and with v the
    // same of c': q' = v - i h phi' q, v' = -K q - (zeta + 2 rate G + i h phi') v + b M, and M =
    // -(theta + Re sum b^H q)/compliance. Complex numbers are two real ones; of h = 0 one.
    const auto parts_of = [](const ReducedBody::Harmonic &modes) {
      return (modes.number == 0 ? 1 : 2) * Eigen::Index(modes.n_modes());
    };
    const auto real_form = [](const MatrixXcd &matrix, const unsigned int number) -> MatrixXd {
      if (number == 0)
        return matrix.real();
      MatrixXd form(2 * matrix.rows(), 2 * matrix.cols());
      form << matrix.real(), -matrix.imag(), matrix.imag(), matrix.real();
      return form;
    };
    Eigen::Index n = 1;
    double       w = 1; // of any size where no harmonic has modes below the cut-off
    for (const ReducedBody::Harmonic &modes : body_.harmonics)
      {
        n += parts_of(modes);
        if (modes.n_modes() > 0)
          w = std::max(w, std::sqrt(modes.eigenvalues.maxCoeff()));
      }
    // Times w and velocities over w: numbers of one size. The turn is the last coordinate.
    MatrixXd        system = MatrixXd::Zero(2 * n, 2 * n);
    Eigen::VectorXd load(n);
    Eigen::Index    first = 0;
    for (std::size_t k = 0; k < body_.harmonics.size(); ++k)
      {
        const ReducedBody::Harmonic &modes = body_.harmonics[k];
        const Eigen::Index           m = modes.n_modes(), parts = parts_of(modes);
        const Complex shift     = imaginary_unit * double(modes.number) * sense_ * rate / w;
        MatrixXcd     stiffness = (rate * rate - body_.rate * body_.rate) * modes.spin_stiffness;
        stiffness += modes.eigenvalues.cast<Complex>().asDiagonal();
        MatrixXcd damping = 2. * rate / w * modes.coriolis;
        damping.diagonal().array() += damping_.modes / w + shift;
        system.block(first, first, parts, parts) =
          -real_form(shift * MatrixXcd::Identity(m, m), modes.number);
        system.block(first, n + first, parts, parts).setIdentity();
        system.block(n + first, first, parts, parts) =
          -real_form(stiffness / (w * w), modes.number);
        system.block(n + first, n + first, parts, parts) = -real_form(damping, modes.number);
        const VectorXcd &b                               = per_moment_[k];
        load.segment(first, m)                           = b.real();
        if (parts > m)
          load.segment(first + m, m) = b.imag();
        first += parts;
      }
    load[n - 1]                  = 1. / std::sqrt(body_.turn_inertia);
    system(n - 1, 2 * n - 1)     = 1.;
    system(2 * n - 1, 2 * n - 1) = -damping_.turn / w;
    system.bottomLeftCorner(n, n) -= load * load.transpose() / (compliance_ * w * w);
    const Eigen::EigenSolver<MatrixXd> solver(system, false);
    std::vector<Complex>               exponents;
    for (Eigen::Index k = 0; k < 2 * n; ++k)
      exponents.push_back(w * solver.eigenvalues()[k]);
    return exponents;
  }
} // namespace vfife
