// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/solvers/column_traits.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/solvers/eigen_solver.h>
#include <vfife/fem/solvers/multigrid_solver.h>
#include <vfife/fem/solvers/sparse_matrix.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziLOBPCGSolMgr.hpp>
#pragma GCC diagnostic pop

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vfife
{
  namespace
  {
    using Problem = Anasazi::BasicEigenproblem<double, Columns, ColumnOperator>;

    /** y = (K - shift M)^-1 M x. */
    class ShiftInvert : public ColumnOperator
    {
    public:
      ShiftInvert(const SparseMatrix &mass, const DirectSolver &factors)
        : mass_(mass)
        , factors_(factors)
      {
      }

      void apply(const Columns &x, Columns &y) const override
      {
        // One behind the other in memory, as the columns of y need not be.
        Columns right_sides(x.communicator(), x.n_rows(), x.n());
        mass_.apply(x, right_sides);
        factors_.solve(right_sides[0].data(), x.n());
        for (std::size_t k = 0; k < x.n(); ++k)
          y[k] = right_sides[k];
      }

    private:
      const SparseMatrix &mass_;
      const DirectSolver &factors_;
    };

    MassOperator make_operator(const SparseMatrix &M, const FemMatrix &mass)
    {
      return {M,
              mass.diagonal(),
              static_cast<unsigned int>(mass.pattern().first_row),
              mass.communicator()};
    }

    /** A x. */
    Columns apply(const ColumnOperator &A, const Columns &x)
    {
      Columns y(x.communicator(), x.n_rows(), x.n());
      A.apply(x, y);
      return y;
    }

    /** Start vectors that depend on the global number only: the same on any number of ranks. Zero
     * where unknowns have no mass: they are padding. */
    Teuchos::RCP<Columns> make_start(const MassOperator &mass, const unsigned int n)
    {
      const std::size_t n_rows = mass.diagonal.size();
      const auto        start  = Teuchos::rcp(new Columns(mass.communicator, n_rows, n));
      for (unsigned int k = 0; k < n; ++k)
        for (std::size_t i = 0; i < n_rows; ++i)
          {
            // The finalizer of splitmix64 (Steele, Lea & Flood 2014) on number and column; its
            // upper 53 bits become a number in [-1, 1).
            const unsigned int global = mass.first_row + i;
            std::uint64_t      bits =
              (global + 1ull) * 0x9E3779B97F4A7C15ull + k * 0xBF58476D1CE4E5B9ull;
            bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ull;
            bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBull;
            bits ^= bits >> 31;
            (*start)[k][i] =
              mass.diagonal[i] > 0 ? static_cast<double>(bits >> 11) * 0x1p-52 - 1. : 0.;
          }
      return start;
    }

    Teuchos::ParameterList
    make_list(const std::string &which, const unsigned int block, const double tolerance)
    {
      Teuchos::ParameterList list;
      list.set("Verbosity", static_cast<int>(Anasazi::Errors));
      list.set("Which", which);
      list.set("Block Size", static_cast<int>(block));
      list.set("Convergence Tolerance", tolerance);
      return list;
    }

    /** The first @p n pairs that Anasazi has found; throws NumericalError if there are fewer. */
    EigenPairs take_pairs(const Problem &problem, const unsigned int n, const int n_iterations)
    {
      const auto &solution = problem.getSolution();
      EigenPairs  pairs;
      pairs.n_iterations = n_iterations;
      if (solution.numVecs < static_cast<int>(n))
        throw NumericalError("the eigenvalue solver found " + std::to_string(solution.numVecs) +
                             " of " + std::to_string(n) + " modes in " +
                             std::to_string(n_iterations) + " iterations");
      for (unsigned int k = 0; k < n; ++k)
        {
          const auto x = (*solution.Evecs)[k];
          pairs.values.push_back(solution.Evals[k].realpart);
          pairs.vectors.emplace_back(x.data(), x.data() + x.size());
        }
      return pairs;
    }

    /** Rayleigh and Ritz: the eigenpairs in the space of the vectors, of an operator that is
     * symmetric in the inner product of M. */
    void make_symmetric(const ColumnOperator &mass,
                        const ColumnOperator &inverse,
                        const Communicator   &communicator,
                        EigenPairs           &pairs)
    {
      const Columns         x(communicator, pairs.vectors);
      const Columns         Mx = vfife::apply(mass, x);
      const Eigen::MatrixXd A  = Mx.products(vfife::apply(inverse, x));
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(.5 *
                                                                              (A + A.transpose()),
                                                                            Mx.products(x));
      if (small.info() != Eigen::Success)
        throw NumericalError("the eigenvalue solver found linearly dependent modes");
      Eigen::MatrixXd       copy;
      const Eigen::MatrixXd ritz = x.matrix(copy) * small.eigenvectors();
      for (std::size_t k = 0; k < x.n(); ++k)
        {
          pairs.values[k] = small.eigenvalues()[k];
          pairs.vectors[k].assign(ritz.col(k).data(), ritz.col(k).data() + x.n_rows());
        }
    }

    /** Sorts by value and scales to x^T M x = 1. */
    void normalize(const ColumnOperator &mass, const Communicator &communicator, EigenPairs &pairs)
    {
      std::vector<std::size_t> order(pairs.values.size());
      std::iota(order.begin(), order.end(), std::size_t(0));
      std::stable_sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
        return pairs.values[a] < pairs.values[b];
      });
      EigenPairs                sorted;
      const Columns             x(communicator, pairs.vectors);
      const std::vector<double> squares = x.dot(vfife::apply(mass, x));
      for (const std::size_t k : order)
        {
          for (double &value : pairs.vectors[k])
            value /= std::sqrt(squares[k]);
          sorted.values.push_back(pairs.values[k]);
          sorted.vectors.push_back(std::move(pairs.vectors[k]));
        }
      sorted.n_iterations = pairs.n_iterations;
      pairs               = std::move(sorted);
    }
  } // namespace

  EigenPairs solve_shift_invert(const FemMatrix    &mass,
                                const DirectSolver &factors,
                                const double        shift,
                                const unsigned int  n,
                                const double        tolerance)
  {
    const SparseMatrix M(mass);
    return solve_shift_invert(make_operator(M, mass), ShiftInvert(M, factors), shift, n, tolerance);
  }

  EigenPairs solve_shift_invert(const MassOperator   &mass,
                                const ColumnOperator &inverse,
                                const double          shift,
                                const unsigned int    n,
                                const double          tolerance)
  {
    // The largest mu = 1/(lambda - shift) of (K - shift M)^-1 M are the lowest lambda above the
    // shift, far apart from each other: few Krylov vectors are needed.
    // Two vectors a block: both members of a double mode enter the Krylov space from the start.
    constexpr unsigned int block   = 2;
    const auto             problem = Teuchos::rcp(new Problem(Teuchos::rcpFromRef(inverse),
                                                  Teuchos::rcpFromRef(mass.apply),
                                                  make_start(mass, block)));
    // Round-off makes complex pairs of exactly double values; where such a pair meets the end of
    // the kept space, Anasazi's restart for symmetric operators writes beyond its memory. The other
    // one keeps pairs together, real and imaginary part spanning the same space.
    problem->setHermitian(false);
    problem->setNEV(n);
    problem->setProblem();
    Teuchos::ParameterList list = make_list("LM", block, tolerance);
    list.set("Num Blocks", static_cast<int>(n + 10));
    list.set("Maximum Restarts", 200);
    Anasazi::BlockKrylovSchurSolMgr<double, Columns, ColumnOperator> solver(problem, list);
    solver.solve();
    EigenPairs pairs = take_pairs(*problem, n, solver.getNumIters());
    make_symmetric(mass.apply, inverse, mass.communicator, pairs);
    // The operator's eigenvalues are mu = 1/(lambda - shift).
    for (double &value : pairs.values)
      value = shift + 1. / value;
    normalize(mass.apply, mass.communicator, pairs);
    return pairs;
  }

  EigenPairs solve_lobpcg(const FemMatrix                &stiffness,
                          const FemMatrix                &mass,
                          const std::vector<OwnedVector> &near_kernel,
                          const double                    shift,
                          const unsigned int              n,
                          const double                    tolerance)
  {
    const MultigridSolver multigrid(add_scaled(stiffness, -shift, mass), near_kernel);
    const SparseMatrix    M(mass);
    return solve_lobpcg(
      make_operator(M, mass), multigrid.matrix(), multigrid.cycle(), shift, n, tolerance);
  }

  EigenPairs solve_lobpcg(const MassOperator   &mass,
                          const ColumnOperator &A,
                          const ColumnOperator &inverse,
                          const double          shift,
                          const unsigned int    n,
                          const double          tolerance)
  {
    // Some vectors beyond those asked for: how fast the last one converges depends on the gap
    // behind the block.
    const unsigned int block   = n + 4;
    const auto         problem = Teuchos::rcp(new Problem(Teuchos::rcpFromRef(A),
                                                  Teuchos::rcpFromRef(mass.apply),
                                                  make_start(mass, block)));
    problem->setPrec(Teuchos::rcpFromRef(inverse));
    // Here K - shift M and M are both symmetric, and all steps are Rayleigh and Ritz.
    problem->setHermitian(true);
    problem->setNEV(n);
    problem->setProblem();
    Teuchos::ParameterList list = make_list("SR", block, tolerance);
    list.set("Maximum Iterations", 500);
    // Converged pairs are locked; full orthogonalization is slower, but does not break down
    // near convergence.
    list.set("Full Ortho", true);
    list.set("Use Locking", true);
    Anasazi::LOBPCGSolMgr<double, Columns, ColumnOperator> solver(problem, list);
    solver.solve();
    EigenPairs pairs = take_pairs(*problem, n, solver.getNumIters());
    for (double &value : pairs.values)
      value += shift;
    normalize(mass.apply, mass.communicator, pairs);
    return pairs;
  }

  std::vector<double> compute_residuals(const FemMatrix  &stiffness,
                                        const FemMatrix  &mass,
                                        const EigenPairs &pairs,
                                        const double      scale)
  {
    return compute_residuals(
      SparseMatrix(stiffness), SparseMatrix(mass), mass.communicator(), pairs, scale);
  }

  std::vector<double> compute_residuals(const ColumnOperator &stiffness,
                                        const ColumnOperator &mass,
                                        const Communicator   &communicator,
                                        const EigenPairs     &pairs,
                                        const double          scale)
  {
    const Columns x(communicator, pairs.vectors);
    Columns       r  = apply(stiffness, x);
    const Columns Mx = apply(mass, x);
    for (std::size_t k = 0; k < x.n(); ++k)
      r[k] -= pairs.values[k] * Mx[k];
    const std::vector<double> rests = r.dot(r), sizes = Mx.dot(Mx);
    std::vector<double>       residuals;
    for (std::size_t k = 0; k < x.n(); ++k)
      // Over lambda, and of rigid motions, whose lambda is round-off, over the shift.
      residuals.push_back(std::sqrt(rests[k] / sizes[k]) /
                          std::max(std::abs(pairs.values[k]), std::abs(scale)));
    return residuals;
  }

  double compute_orthogonality_defect(const FemMatrix                &mass,
                                      const std::vector<OwnedVector> &vectors)
  {
    return compute_orthogonality_defect(SparseMatrix(mass), mass.communicator(), vectors);
  }

  double compute_orthogonality_defect(const ColumnOperator           &mass,
                                      const Communicator             &communicator,
                                      const std::vector<OwnedVector> &vectors)
  {
    const Columns x(communicator, vectors);
    return (x.products(apply(mass, x)) - Eigen::MatrixXd::Identity(x.n(), x.n()))
      .cwiseAbs()
      .maxCoeff();
  }
} // namespace vfife
