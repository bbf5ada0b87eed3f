// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "mumps_instance.h"

#include <vfife/fem/solvers/condensation.h>

namespace vfife
{
  Condensation::Condensation(const FemMatrix &matrix, const std::vector<unsigned int> &border)
    : border_(border)
    , schur_(border.begin(), border.end())
    , S_(Eigen::MatrixXd::Zero(border.size(), border.size()))
  {
    const SparsePattern &pattern = matrix.pattern();
    const int            n       = border_.size();
    if (n == pattern.n)
      {
        // Nothing to eliminate: S is the matrix itself.
        std::vector<int> place(n);
        for (int b = 0; b < n; ++b)
          place[border_[b]] = b;
        for (int i = 0; i < n; ++i)
          for (std::size_t k = pattern.begin[i]; k < pattern.begin[i + 1]; ++k)
            S_(place[i], place[pattern.columns[k]]) = matrix.values()[k];
        return;
      }
    for (int &unknown : schur_)
      ++unknown;
    instance_                      = std::make_unique<MumpsInstance>(matrix);
    instance_->control(19)         = 1; // S is left, as one dense matrix
    instance_->mumps.size_schur    = n;
    instance_->mumps.listvar_schur = schur_.data();
    instance_->mumps.schur         = S_.data();
    instance_->factorize();
    // Of a symmetric matrix one triangle is returned, row by row the lower one.
    S_.triangularView<Eigen::StrictlyLower>() = S_.transpose();
  }

  Condensation::~Condensation() = default;

  void Condensation::solve(Eigen::MatrixXd &x, const SolveBorder &solve_border) const
  {
    const std::size_t n = border_.size();
    Eigen::MatrixXd   on_border(n, x.cols());
    if (!instance_)
      {
        for (std::size_t b = 0; b < n; ++b)
          on_border.row(b) = x.row(border_[b]);
        const Eigen::MatrixXd u = solve_border(on_border);
        for (std::size_t b = 0; b < n; ++b)
          x.row(border_[b]) = u.row(b);
        return;
      }
    DMUMPS_STRUC_C &mumps = instance_->mumps;
    mumps.rhs             = x.data();
    mumps.nrhs            = x.cols();
    mumps.lrhs            = x.rows();
    mumps.redrhs          = on_border.data();
    mumps.lredrhs         = n;
    // Down to the border, with what MUMPS keeps of the interior, and back.
    instance_->control(26) = 1;
    instance_->solve();
    on_border              = solve_border(on_border);
    mumps.redrhs           = on_border.data();
    instance_->control(26) = 2;
    instance_->solve();
  }

  unsigned int Condensation::n_negative() const
  {
    return instance_ ? instance_->info(12) : 0;
  }

  unsigned int Condensation::n_zero() const
  {
    return instance_ ? instance_->info(28) : 0;
  }

  double Condensation::memory() const
  {
    return (instance_ ? instance_->info(22) : 0) + 8e-6 * S_.size();
  }
} // namespace vfife
