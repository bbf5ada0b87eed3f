// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_condensation_h
#define vfife_fem_solvers_condensation_h

#include <vfife/fem/system/fem_matrix.h>

#include <Eigen/Core>

#include <functional>
#include <memory>

namespace vfife
{
  struct MumpsInstance;

  /**
   * A symmetric sparse matrix whose interior unknowns are eliminated by MUMPS, so that a dense
   * matrix S = K_bb - K_bi K_ii^-1 K_ib of its border is left. On one rank; throws NumericalError
   * with MUMPS' code when it fails.
   */
  class Condensation
  {
  public:
    /** @p border: unknowns that are left, in the order of S. */
    Condensation(const FemMatrix &matrix, const std::vector<unsigned int> &border);
    ~Condensation();
    Condensation(const Condensation &)            = delete;
    Condensation &operator=(const Condensation &) = delete;

    const Eigen::MatrixXd &border_matrix() const
    {
      return S_;
    }

    /** Makes displacements of the border of the loads on it, condensed: a column each. */
    using SolveBorder = std::function<Eigen::MatrixXd(const Eigen::MatrixXd &loads)>;

    /** Displacements of all unknowns under loads on them, a column each, in place; those of the
     * border are what @p solve_border says. */
    void solve(Eigen::MatrixXd &x, const SolveBorder &solve_border) const;

    /** Negative eigenvalues of K_ii. */
    unsigned int n_negative() const;
    /** Pivots of K_ii that are zero to round-off. */
    unsigned int n_zero() const;
    /** Of the factors and of S [MB]. */
    double memory() const;

  private:
    std::vector<unsigned int>      border_;
    std::vector<int>               schur_; ///< as MUMPS numbers them
    Eigen::MatrixXd                S_;
    std::unique_ptr<MumpsInstance> instance_; ///< none where all is border
  };
} // namespace vfife

#endif
