// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_direct_solver_h
#define vfife_fem_solvers_direct_solver_h

#include <vfife/fem/system/fem_matrix.h>

#include <memory>

namespace vfife
{
  struct MumpsInstance;

  /**
   * L D L^T of a symmetric sparse matrix by MUMPS on all ranks. All functions are collective;
   * throws NumericalError with MUMPS' code when it fails.
   */
  class DirectSolver
  {
  public:
    explicit DirectSolver(const FemMatrix &matrix);
    ~DirectSolver();
    DirectSolver(const DirectSolver &)            = delete;
    DirectSolver &operator=(const DirectSolver &) = delete;

    /** Solves for @p n_right_sides owned vectors, one after the other in @p x, in place. */
    void solve(double *x, unsigned int n_right_sides) const;

    /** Negative entries of D: by Sylvester's law of inertia the number of negative eigenvalues. */
    unsigned int n_negative() const;

    /** Pivots that are zero to round-off. */
    unsigned int n_zero() const;

    /** Memory of the factors on all ranks [MB]. */
    double memory() const;

  private:
    const Communicator            &communicator_;
    std::vector<int>               counts_; ///< rows of each rank
    std::unique_ptr<MumpsInstance> instance_;
  };
} // namespace vfife

#endif
