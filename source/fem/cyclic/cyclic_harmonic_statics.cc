// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "phasor_rows.h"

#include <vfife/base/errors.h>
#include <vfife/fem/cyclic/cyclic_harmonic.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/solvers/sparse_matrix.h>
#include <vfife/fem/system/turn_pins.h>

#include <algorithm>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** Right sides solved for at once: enough for the solver's dense blocks. */
    constexpr unsigned int block = 64;
  } // namespace

  void CyclicHarmonic::factorize()
  {
    if (factors_)
      return;
    FemMatrix K = K_;
    if (pinned_)
      {
        // The pinned hub loses an unknown: its matrix is made anew.
        const SystemMatrices pinned(*pinned_, body_.options().mass, body_.options().strain);
        K = body_.rate() != 0
              ? pinned.spinning_stiffness(body_.equilibrium(), constant_rate(body_.rate()))
              : pinned.stiffness(constant_rate(0.));
        // In bearings alone the turn is pinned at a ring.
        if (!has_turning_hub(body_.sector().model(), body_.sector().parts()[0].body))
          K = add_turn_pins(*pinned_, {body_.sector().parts()[0].body}, std::move(K));
        const OwnedVector momentum = pinned.apply_mass(body_.turn());
        momentum_ = Eigen::Map<const Eigen::VectorXd>(momentum.data(), momentum.size());
      }
    factors_ = std::make_unique<DirectSolver>(K);
    memory_  = std::max(memory_, factors_->memory());
    // Shifts and tilts may be faster than their bearings allow: two of each, in two copies.
    const unsigned int n_whirls = body_.whirls(number_) ? 4 : 0;
    if (factors_->n_negative() > n_whirls || factors_->n_zero() > 0)
      throw NumericalError("body \"" + body_.body().name() + "\" is not stable with " +
                           std::to_string(number_) + " nodal diameters: the speed is too high");
  }

  void CyclicHarmonic::solve(Eigen::MatrixXd &q, const Eigen::VectorXd &moments) const
  {
    // With P = 1 - M r r^T/(r^T M r), r the turn: P f has no moment, so that the pin carries
    // nothing, and P^T u no part of the turn (which turn_in() tells).
    if (pinned_)
      q -= momentum_ * (body_.n_sectors() / body_.turn_inertia() * moments).transpose();
    factors_->solve(q.data(), q.cols());
  }

  Eigen::VectorXd CyclicHarmonic::turn_in(const Eigen::MatrixXd &q) const
  {
    return pinned_ ? Eigen::VectorXd(body_.n_sectors() / body_.turn_inertia() *
                                     (q.transpose() * momentum_))
                   : Eigen::VectorXd::Zero(q.cols());
  }

  Eigen::MatrixXcd CyclicHarmonic::answers(const std::vector<SectorRow> &forces,
                                           const std::vector<SectorRow> &rows)
  {
    factorize();
    const PhasorRows reads = make_phasor_rows(static_system(), number_, rows);
    const Eigen::SparseMatrix<double, Eigen::RowMajor> along =
      make_phasor_rows(static_system(), number_, forces).real();
    const Eigen::SparseMatrix<double> loads = along.transpose();
    const Eigen::VectorXd             turn = read_turn(rows), moments = read_turn(forces);
    Eigen::MatrixXcd                  answers(rows.size(), forces.size());
    for (std::size_t first = 0; first < forces.size(); first += block)
      {
        const std::size_t n = std::min<std::size_t>(block, forces.size() - first);
        Eigen::MatrixXd   q = loads.middleCols(first, n);
        solve(q, moments.segment(first, n));
        answers.middleCols(first, n) = reads * q.cast<Complex>();
        if (pinned_)
          answers.middleCols(first, n) -= (turn * turn_in(q).transpose()).cast<Complex>();
      }
    return answers;
  }

  Eigen::VectorXd CyclicHarmonic::read_turn(const std::vector<SectorRow> &rows) const
  {
    Eigen::VectorXd values(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      values[i] = read_row(rows[i], body_.turn());
    return values;
  }

  Eigen::VectorXd CyclicHarmonic::answer(const std::vector<double>    &forces,
                                         const std::vector<SectorRow> &rows)
  {
    factorize();
    const OwnedVector load = static_system().restrict_forces(forces);
    Eigen::MatrixXd   q    = Eigen::Map<const Eigen::VectorXd>(load.data(), load.size());
    const double      moment =
      std::inner_product(forces.begin(), forces.end(), body_.turn().begin(), 0.);
    solve(q, Eigen::VectorXd::Constant(1, moment));
    return (make_phasor_rows(static_system(), number_, rows) * q.cast<Complex>()).real() -
           read_turn(rows) * turn_in(q);
  }

  Eigen::VectorXd CyclicHarmonic::modal_forces(const CyclicModes         &modes,
                                               const std::vector<double> &forces) const
  {
    const OwnedVector load = system_.restrict_forces(forces);
    return body_.n_sectors() * product(modes, load);
  }

  Eigen::VectorXd CyclicHarmonic::euler_forces(const CyclicModes &modes) const
  {
    if (body_.turns())
      return Eigen::VectorXd::Zero(modes.vectors.size());
    return -1. * body_.n_sectors() * product(modes, matrices_.apply_mass(body_.rigid_turn()));
  }

  Eigen::VectorXd CyclicHarmonic::euler_answer(const std::vector<SectorRow> &rows)
  {
    if (body_.turns())
      return Eigen::VectorXd::Zero(rows.size());
    factorize();
    const OwnedVector inertia = matrices_.apply_mass(body_.rigid_turn());
    Eigen::MatrixXd   q       = -Eigen::Map<const Eigen::VectorXd>(inertia.data(), inertia.size());
    solve(q, Eigen::VectorXd::Zero(1));
    return (make_phasor_rows(system_, number_, rows) * q.cast<Complex>()).real();
  }

  Eigen::VectorXd CyclicHarmonic::turn_coriolis(const CyclicModes &modes) const
  {
    // r^T G z = -(G r)^T z
    const OwnedVector Gr = SparseMatrix(coriolis()).apply(system_.restrict_field(body_.turn()));
    return -1. * body_.n_sectors() * product(modes, Gr);
  }

  Eigen::VectorXd CyclicHarmonic::product(const CyclicModes &modes, const OwnedVector &load) const
  {
    Eigen::VectorXd products(modes.vectors.size());
    for (std::size_t k = 0; k < modes.vectors.size(); ++k)
      products[k] = system_.dot(modes.vectors[k], load);
    return modes.combination.real().transpose() * products;
  }
} // namespace vfife
