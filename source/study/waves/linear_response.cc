// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/study/waves/linear_response.h>
#include <vfife/study/waves/static_passage.h>

#include <Eigen/LU>

#include <cmath>

namespace vfife
{
  using Complex = std::complex<double>;
  using Eigen::MatrixXcd;
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
        VectorXcd force = per_moment(k);
        if (body.harmonics[k].number == 0)
          force -= driven_sense * body.harmonics[k].torque;
        compliance_ -= force.dot(answer(k, 0, 0., force)).real();
      }
  }

  VectorXcd LinearResponse::per_moment(const std::size_t harmonic) const
  {
    return passage_.force(harmonic, 0) / passage_.moment();
  }

  VectorXcd LinearResponse::answer(const std::size_t harmonic,
                                   const int         p,
                                   const double      rate,
                                   const VectorXcd  &force) const
  {
    const ReducedBody::Harmonic &modes = body_.harmonics[harmonic];
    const double omega  = (int(modes.number) + p * int(body_.n_sectors)) * sense_ * rate;
    MatrixXcd    matrix = (rate * rate - body_.rate * body_.rate) * modes.spin_stiffness;
    matrix += modes.eigenvalues.cast<Complex>().asDiagonal();
    matrix += Complex(0., 2. * rate * omega) * modes.coriolis;
    matrix.diagonal().array() += Complex(-omega * omega, damping_.modes * omega);
    return matrix.partialPivLu().solve(force);
  }

  Complex LinearResponse::flank_turn(const int p, const double rate, const bool by_moment) const
  {
    Complex sum = 0;
    for (std::size_t k = 0; k < body_.harmonics.size(); ++k)
      {
        const VectorXcd load = per_moment(k);
        const auto      turn = [&](const int q) {
          return load.dot(answer(k, q, rate, by_moment ? load : passage_.force(k, q)));
        };
        sum += .5 * (turn(p) + std::conj(turn(-p)));
      }
    return sum;
  }

  Complex LinearResponse::find_moment(const int p, const double rate) const
  {
    // The spring is as long as at rest where the flank is where it would be there.
    const double  omega = p * int(body_.n_sectors) * sense_ * rate;
    const Complex turn = 1. / (body_.turn_inertia * Complex(-omega * omega, damping_.turn * omega));
    return (passage_.turn(p) + flank_turn(p, 0., false) - flank_turn(p, rate, false)) /
           (compliance_ + turn + flank_turn(p, rate, true));
  }

  VectorXcd
  LinearResponse::coordinates(const std::size_t harmonic, const int p, const double rate) const
  {
    const Complex moment = p > 0 ? find_moment(p, rate) : std::conj(find_moment(-p, rate));
    return answer(harmonic, p, rate, passage_.force(harmonic, p) + moment * per_moment(harmonic));
  }
} // namespace vfife
