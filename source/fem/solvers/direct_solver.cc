// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "mumps_instance.h"

#include <vfife/base/process/communicator.h>
#include <vfife/fem/solvers/direct_solver.h>

#include <numeric>

namespace vfife
{
  DirectSolver::DirectSolver(const FemMatrix &matrix)
    : communicator_(matrix.communicator())
    , counts_(communicator_.all_gather(matrix.pattern().n_rows()))
    , instance_(std::make_unique<MumpsInstance>(matrix))
  {
    instance_->factorize();
  }

  DirectSolver::~DirectSolver() = default;

  void DirectSolver::solve(double *x, const unsigned int n_right_sides) const
  {
    DMUMPS_STRUC_C  &mumps = instance_->mumps;
    const int        n     = mumps.n;
    const int        n_own = counts_[communicator_.rank()];
    std::vector<int> starts(counts_.size(), 0);
    std::partial_sum(counts_.begin(), counts_.end() - 1, starts.begin() + 1);

    // MUMPS takes right sides on the root and leaves the solutions there.
    std::vector<double> all(communicator_.is_root() ? std::size_t(n) * n_right_sides : 0);
    for (unsigned int k = 0; k < n_right_sides; ++k)
      MPI_Gatherv(x + std::size_t(k) * n_own,
                  n_own,
                  MPI_DOUBLE,
                  all.data() + (communicator_.is_root() ? std::size_t(k) * n : 0),
                  counts_.data(),
                  starts.data(),
                  MPI_DOUBLE,
                  0,
                  communicator_.mpi());
    mumps.rhs  = all.data();
    mumps.nrhs = n_right_sides;
    mumps.lrhs = n;
    instance_->solve();
    for (unsigned int k = 0; k < n_right_sides; ++k)
      MPI_Scatterv(all.data() + (communicator_.is_root() ? std::size_t(k) * n : 0),
                   counts_.data(),
                   starts.data(),
                   MPI_DOUBLE,
                   x + std::size_t(k) * n_own,
                   n_own,
                   MPI_DOUBLE,
                   0,
                   communicator_.mpi());
  }

  unsigned int DirectSolver::n_negative() const
  {
    return instance_->info(12);
  }

  unsigned int DirectSolver::n_zero() const
  {
    return instance_->info(28);
  }

  double DirectSolver::memory() const
  {
    return instance_->info(22);
  }
} // namespace vfife
