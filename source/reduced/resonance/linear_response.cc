// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/reduced/resonance/linear_response.h>
#include <vfife/reduced/resonance/static_passage.h>

#include <Eigen/LU>

#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::MatrixXd;
  using Eigen::VectorXcd;

  namespace
  {
    /** By LAPACK, which is many times faster than Eigen. */
    std::vector<Complex> find_eigenvalues(MatrixXcd matrix)
    {
      using Integer          = dealii::types::blas_int;
      const Integer        n = matrix.rows(), one = 1;
      Integer              n_work = -1, info = 0; // asks for the size
      std::vector<Complex> eigenvalues(n), work(1);
      std::vector<double>  real_work(2 * std::size_t(n));
      for (unsigned int call = 0; call < 2; ++call)
        {
          dealii::geev("N",
                       "N",
                       &n,
                       matrix.data(),
                       &n,
                       eigenvalues.data(),
                       nullptr,
                       &one,
                       nullptr,
                       &one,
                       work.data(),
                       &n_work,
                       real_work.data(),
                       &info);
          if (info != 0)
            throw NumericalError("the rates of resonances were not found (LAPACK info = " +
                                 std::to_string(info) + ")");
          n_work = static_cast<Integer>(work[0].real());
          work.resize(n_work);
        }
      return eigenvalues;
    }
  } // namespace

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

  std::vector<Complex> LinearResponse::resonance_rates(const int p) const
  {
    // The matrices of answer() at the frequency p z rate are quadratic in the rate, with q = p z +
    // h for coordinates c and, for their conjugates, q = p z - h. Both, and the turn theta, feel
    // the moment M = -(theta + Re sum b^H c)/compliance: (A_0 + rate A_1 + rate^2 A_2) x = 0.
    struct Part
    {
      std::size_t harmonic;
      int         sign;
    };
    std::vector<Part> parts;
    Eigen::Index      n = 1;
    for (std::size_t k = 0; k < body_.harmonics.size(); ++k)
      for (const int sign : {1, -1})
        // Coordinates without diameters are real.
        if (sign == 1 || body_.harmonics[k].number > 0)
          {
            parts.push_back({k, sign});
            n += body_.harmonics[k].n_modes();
          }
    const double z  = p * double(body_.n_sectors);
    MatrixXcd    A0 = MatrixXcd::Zero(n, n), A2 = MatrixXcd::Zero(n, n);
    VectorXcd    A1(n), load(n);
    Eigen::Index first = 0;
    for (const Part &part : parts)
      {
        const ReducedBody::Harmonic &modes = body_.harmonics[part.harmonic];
        const Eigen::Index           m     = modes.n_modes();
        const double                 q     = z + part.sign * double(modes.number);
        const auto                   of    = [&](const MatrixXcd &matrix) -> MatrixXcd {
          return part.sign > 0 ? matrix : matrix.conjugate();
        };
        A0.block(first, first, m, m) = -body_.rate * body_.rate * of(modes.spin_stiffness);
        A0.block(first, first, m, m) += modes.eigenvalues.cast<Complex>().asDiagonal();
        A1.segment(first, m).setConstant(imaginary_unit * damping_.modes * sense_ * q);
        A2.block(first, first, m, m) =
          of(modes.spin_stiffness) + 2. * imaginary_unit * sense_ * q * of(modes.coriolis);
        A2.block(first, first, m, m).diagonal().array() -= q * q;
        load.segment(first, m) =
          (modes.number == 0 ? 1. : std::sqrt(.5)) * of(per_moment_[part.harmonic]);
        first += m;
      }
    A1[first]        = imaginary_unit * damping_.turn * sense_ * z;
    A2(first, first) = -z * z;
    load[first]      = 1. / std::sqrt(body_.turn_inertia);
    A0 += load * load.adjoint() / compliance_;

    // Eigenvalues of the companion matrix, of rates over one of their size.
    const Eigen::PartialPivLU<MatrixXcd> inertia(A2);
    const MatrixXcd                      stiffness = inertia.solve(A0),
                    damping                        = inertia.solve(MatrixXcd(A1.asDiagonal()));
    const double size      = std::sqrt(stiffness.diagonal().cwiseAbs().maxCoeff());
    MatrixXcd    companion = MatrixXcd::Zero(2 * n, 2 * n);
    companion.topRightCorner(n, n).setIdentity();
    companion.bottomLeftCorner(n, n)  = -stiffness / (size * size);
    companion.bottomRightCorner(n, n) = -damping / size;
    std::vector<Complex> rates        = find_eigenvalues(std::move(companion));
    for (Complex &rate : rates)
      rate *= size;
    return rates;
  }
} // namespace vfife
