// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/solvers/direct_solver.h>

#include <dmumps_c.h>

#include <numeric>

namespace vfife
{
  struct DirectSolver::Instance
  {
    DMUMPS_STRUC_C   mumps = {};
    std::vector<int> rows, columns;
    SparseValues     values;

    /** An entry of ICNTL as the manual numbers it. */
    MUMPS_INT &control(const unsigned int i)
    {
      return mumps.icntl[i - 1];
    }

    /** MUMPS' jobs: -1 begins, 4 analyses and factorizes, 2 factorizes, 3 solves, -2 ends. */
    void run(const int job)
    {
      mumps.job = job;
      dmumps_c(&mumps);
    }

    int error() const
    {
      return mumps.infog[0];
    }
  };

  namespace
  {
    std::string explain(const int error, const int detail)
    {
      std::string text = "the direct solver failed (MUMPS INFOG(1) = " + std::to_string(error) +
                         ", INFOG(2) = " + std::to_string(detail) + ")";
      if (error == -13)
        text += ": there is not enough memory for the factors";
      else if (error == -10)
        text += ": the matrix is singular";
      return text;
    }
  } // namespace

  DirectSolver::DirectSolver(const SparsePattern &pattern,
                             const SparseValues  &values,
                             const Communicator  &communicator)
    : communicator_(communicator)
    , counts_(communicator.all_gather(pattern.n_rows()))
    , instance_(std::make_unique<Instance>())
  {
    Instance &it = *instance_;
    for (int i = 0; i < pattern.n_rows(); ++i)
      for (std::size_t k = pattern.begin[i]; k < pattern.begin[i + 1]; ++k)
        // The lower triangle, numbered from 1.
        if (pattern.columns[k] <= pattern.first_row + i && values[k] != 0)
          {
            it.rows.push_back(pattern.first_row + i + 1);
            it.columns.push_back(pattern.columns[k] + 1);
            it.values.push_back(values[k]);
          }
    // L D L^T and no Cholesky factors: the number of negative pivots is that of the eigenvalues
    // below a shift (Sylvester), and a matrix that is not positive definite is told by them.
    // par = 1: the root works as well; sym = 2: symmetric, not necessarily positive definite.
    it.mumps.comm_fortran = MPI_Comm_c2f(communicator.mpi());
    it.mumps.par          = 1;
    it.mumps.sym          = 2;
    it.run(-1);
    it.control(1)    = -1; // errors are reported by exceptions, nothing is printed
    it.control(2)    = -1;
    it.control(3)    = -1;
    it.control(4)    = 0;
    it.control(7)    = 5; // METIS
    it.control(13)   = 1; // the root is factorized on one rank, so that its inertia is counted
    it.control(14)   = 30;
    it.control(18)   = 3; // entries are distributed
    it.control(24)   = 1; // zero pivots are counted
    it.mumps.n       = pattern.n;
    it.mumps.nnz_loc = it.rows.size();
    it.mumps.irn_loc = it.rows.data();
    it.mumps.jcn_loc = it.columns.data();
    it.mumps.a_loc   = it.values.data();
    it.run(4);
    // Delayed pivots need more room than the analysis foresees.
    for (unsigned int again = 0; again < 4 && (it.error() == -8 || it.error() == -9); ++again)
      {
        it.control(14) *= 2;
        it.run(2);
      }
    if (it.error() < 0)
      {
        const std::string message = explain(it.error(), it.mumps.infog[1]);
        it.run(-2);
        throw NumericalError(message);
      }
    // The factors do not refer to the entries any more.
    std::vector<int>().swap(it.rows);
    std::vector<int>().swap(it.columns);
    SparseValues().swap(it.values);
  }

  DirectSolver::~DirectSolver()
  {
    if (instance_->error() >= 0)
      instance_->run(-2);
  }

  void DirectSolver::solve(double *x, const unsigned int n_right_sides) const
  {
    Instance        &it    = *instance_;
    const int        n     = it.mumps.n;
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
    it.mumps.rhs  = all.data();
    it.mumps.nrhs = n_right_sides;
    it.mumps.lrhs = n;
    it.run(3);
    if (it.error() < 0)
      throw NumericalError(explain(it.error(), it.mumps.infog[1]));
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
    return instance_->mumps.infog[12 - 1];
  }

  unsigned int DirectSolver::n_zero() const
  {
    return instance_->mumps.infog[28 - 1];
  }

  double DirectSolver::memory() const
  {
    return instance_->mumps.infog[22 - 1];
  }
} // namespace vfife
