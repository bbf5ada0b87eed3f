// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "mumps_instance.h"

#include <vfife/base/errors.h>

namespace vfife
{
  namespace
  {
    std::string explain(const int error, const int detail)
    {
      std::string text = "the direct solver failed (MUMPS INFOG(1) = " + std::to_string(error) +
                         ", INFOG(2) = " + std::to_string(detail) + ")";
      if (error == -13)
        text += ": not enough memory for the factors";
      else if (error == -10)
        text += ": the matrix is singular";
      return text;
    }
  } // namespace

  MumpsInstance::MumpsInstance(const FemMatrix &matrix)
  {
    const SparsePattern       &pattern = matrix.pattern();
    const std::vector<double> &all     = matrix.values();
    for (int i = 0; i < pattern.n_rows(); ++i)
      for (std::size_t k = pattern.begin[i]; k < pattern.begin[i + 1]; ++k)
        // The lower triangle, numbered from 1.
        if (pattern.columns[k] <= pattern.first_row + i && all[k] != 0)
          {
            rows.push_back(pattern.first_row + i + 1);
            columns.push_back(pattern.columns[k] + 1);
            values.push_back(all[k]);
          }
    // L D L^T and no Cholesky factors: the number of negative pivots is that of the eigenvalues
    // below a shift (Sylvester), and a matrix that is not positive definite is told by them.
    // par = 1: the root works as well; sym = 2: symmetric, not necessarily positive definite.
    mumps.comm_fortran = MPI_Comm_c2f(matrix.communicator().mpi());
    mumps.par          = 1;
    mumps.sym          = 2;
    run(-1);
    control(1)    = -1; // errors are reported by exceptions, nothing is printed
    control(2)    = -1;
    control(3)    = -1;
    control(4)    = 0;
    control(7)    = 5; // METIS
    control(13)   = 1; // the root is factorized on one rank, so that its inertia is counted
    control(14)   = 30;
    control(18)   = 3; // entries are distributed
    control(24)   = 1; // zero pivots are counted
    mumps.n       = pattern.n;
    mumps.nnz_loc = rows.size();
    mumps.irn_loc = rows.data();
    mumps.jcn_loc = columns.data();
    mumps.a_loc   = values.data();
  }

  MumpsInstance::~MumpsInstance()
  {
    run(-2);
  }

  void MumpsInstance::factorize()
  {
    run(4);
    // Delayed pivots need more room than the analysis foresees.
    for (unsigned int again = 0; again < 4 && (info(1) == -8 || info(1) == -9); ++again)
      {
        control(14) *= 2;
        run(2);
      }
    if (info(1) < 0)
      throw NumericalError(explain(info(1), info(2)));
    // The factors do not refer to the entries any more.
    std::vector<int>().swap(rows);
    std::vector<int>().swap(columns);
    std::vector<double>().swap(values);
  }

  void MumpsInstance::solve()
  {
    run(3);
    if (info(1) < 0)
      throw NumericalError(explain(info(1), info(2)));
  }
} // namespace vfife
