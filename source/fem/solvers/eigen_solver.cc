// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "multigrid.h"

#include <vfife/base/errors.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/solvers/eigen_solver.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziConfigDefs.hpp>
#include <AnasaziEpetraAdapter.hpp>
#include <AnasaziLOBPCGSolMgr.hpp>
#include <Epetra_InvOperator.h>
#pragma GCC diagnostic pop

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vfife
{
  namespace
  {
    using Problem = Anasazi::BasicEigenproblem<double, Epetra_MultiVector, Epetra_Operator>;

    /** y = (K - shift M)^-1 M x. */
    class ShiftInvert : public Epetra_Operator
    {
    public:
      ShiftInvert(const Epetra_CrsMatrix &mass, const DirectSolver &factors)
        : mass_(mass)
        , factors_(factors)
      {
      }

      int Apply(const Epetra_MultiVector &x, Epetra_MultiVector &y) const override
      {
        Epetra_MultiVector right_side(x.Map(), x.NumVectors());
        mass_.Multiply(false, x, right_side);
        factors_.solve(right_side.Values(), x.NumVectors());
        y = right_side;
        return 0;
      }

      // What else the interface asks for; Anasazi calls Apply() only.
      int SetUseTranspose(bool) override
      {
        return 0;
      }
      int ApplyInverse(const Epetra_MultiVector &, Epetra_MultiVector &) const override
      {
        return -1;
      }
      double NormInf() const override
      {
        return 0;
      }
      const char *Label() const override
      {
        return "shift-invert";
      }
      bool UseTranspose() const override
      {
        return false;
      }
      bool HasNormInf() const override
      {
        return false;
      }
      const Epetra_Comm &Comm() const override
      {
        return mass_.Comm();
      }
      const Epetra_Map &OperatorDomainMap() const override
      {
        return mass_.RowMap();
      }
      const Epetra_Map &OperatorRangeMap() const override
      {
        return mass_.RowMap();
      }

    private:
      const Epetra_CrsMatrix &mass_;
      const DirectSolver     &factors_;
    };

    /** Start vectors that depend on the global number only: the same on any number of ranks. */
    Teuchos::RCP<Epetra_MultiVector>
    make_start(const Epetra_Map &map, const Unknowns &unknowns, const unsigned int n)
    {
      auto start = Teuchos::rcp(new Epetra_MultiVector(map, n));
      for (unsigned int k = 0; k < n; ++k)
        for (int i = 0; i < map.NumMyElements(); ++i)
          {
            // The finalizer of splitmix64 (Steele, Lea & Flood 2014) on number and column; its
            // upper 53 bits become a number in [-1, 1).
            const unsigned int global = map.GID(i);
            std::uint64_t      bits =
              (global + 1ull) * 0x9E3779B97F4A7C15ull + k * 0xBF58476D1CE4E5B9ull;
            bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ull;
            bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBull;
            bits ^= bits >> 31;
            (*start)[k][i] =
              unknowns.is_padding(global) ? 0. : static_cast<double>(bits >> 11) * 0x1p-52 - 1.;
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
          const double *x = (*solution.Evecs)[k];
          pairs.values.push_back(solution.Evals[k].realpart);
          pairs.vectors.emplace_back(x, x + solution.Evecs->MyLength());
        }
      return pairs;
    }

    /** Rayleigh and Ritz: the eigenpairs in the space of the vectors, of an operator that is
     * symmetric in the inner product of M. */
    void make_symmetric(const Epetra_CrsMatrix &mass,
                        const ShiftInvert      &inverse,
                        const Assembly         &assembly,
                        EigenPairs             &pairs)
    {
      // A = x^T M (K - s M)^-1 M x and B = x^T M x; both are sums over the ranks.
      const Epetra_MultiVector x = make_multi_vector(mass.RowMap(), pairs.vectors);
      Epetra_MultiVector       Mx(x), Ax(x);
      mass.Multiply(false, x, Mx);
      inverse.Apply(x, Ax);
      const int           n = x.NumVectors();
      std::vector<double> sums(2 * n * n, 0.);
      for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
          for (int row = 0; row < x.MyLength(); ++row)
            {
              sums[i * n + k] += Mx[i][row] * Ax[k][row];
              sums[n * n + i * n + k] += Mx[i][row] * x[k][row];
            }
      assembly.communicator().sum(sums);
      Eigen::MatrixXd A = Eigen::Map<Eigen::MatrixXd>(sums.data(), n, n),
                      B = Eigen::Map<Eigen::MatrixXd>(sums.data() + n * n, n, n);
      A                 = 0.5 * (A + A.transpose().eval());
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(A, B);
      if (small.info() != Eigen::Success)
        throw NumericalError("the eigenvalue solver found modes that depend on each other");
      for (int k = 0; k < n; ++k)
        {
          pairs.values[k] = small.eigenvalues()[k];
          std::fill(pairs.vectors[k].begin(), pairs.vectors[k].end(), 0.);
          for (int i = 0; i < n; ++i)
            for (int row = 0; row < x.MyLength(); ++row)
              pairs.vectors[k][row] += x[i][row] * small.eigenvectors()(i, k);
        }
    }

    /** Sorts by value and scales to x^T M x = 1. */
    void normalize(const Epetra_CrsMatrix &mass, const Assembly &assembly, EigenPairs &pairs)
    {
      std::vector<std::size_t> order(pairs.values.size());
      std::iota(order.begin(), order.end(), std::size_t(0));
      std::stable_sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
        return pairs.values[a] < pairs.values[b];
      });
      EigenPairs               sorted;
      const Epetra_MultiVector x = make_multi_vector(mass.RowMap(), pairs.vectors);
      Epetra_MultiVector       Mx(x);
      mass.Multiply(false, x, Mx);
      for (const std::size_t k : order)
        {
          double       square = 0;
          OwnedVector &v      = pairs.vectors[k];
          for (std::size_t i = 0; i < v.size(); ++i)
            square += v[i] * Mx[k][i];
          const double factor = 1. / std::sqrt(assembly.communicator().sum(square));
          for (double &value : v)
            value *= factor;
          sorted.values.push_back(pairs.values[k]);
          sorted.vectors.push_back(std::move(v));
        }
      sorted.n_iterations = pairs.n_iterations;
      pairs               = std::move(sorted);
    }
  } // namespace

  EigenPairs solve_shift_invert(const Assembly     &assembly,
                                const SparseValues &mass,
                                const DirectSolver &factors,
                                const double        shift,
                                const unsigned int  n,
                                const double        tolerance)
  {
    // The largest mu = 1/(lambda - shift) of (K - shift M)^-1 M are the lowest lambda above the
    // shift, far apart from each other: few Krylov vectors are needed.
    // Two vectors a block: both members of a double mode enter the Krylov space from the start.
    constexpr unsigned int block = 2;
    const Epetra_Map       map   = make_map(assembly.pattern(), assembly.communicator());
    const auto             M     = make_epetra_matrix(map, assembly.pattern(), mass);

    const auto inverse = Teuchos::rcp(new ShiftInvert(*M, factors));
    auto       problem = Teuchos::rcp(new Problem(inverse,
                                            Teuchos::rcp<Epetra_Operator>(M.get(), false),
                                            make_start(map, assembly.unknowns(), block)));
    // Round-off makes complex pairs of exactly double values; where such a pair meets the end of
    // the kept space, Anasazi's restart for symmetric operators writes beyond its memory. The other
    // one keeps pairs together, real and imaginary part spanning the same space.
    problem->setHermitian(false);
    problem->setNEV(n);
    problem->setProblem();
    Teuchos::ParameterList list = make_list("LM", block, tolerance);
    list.set("Num Blocks", static_cast<int>(n + 10));
    list.set("Maximum Restarts", 200);
    Anasazi::BlockKrylovSchurSolMgr<double, Epetra_MultiVector, Epetra_Operator> solver(problem,
                                                                                        list);
    solver.solve();
    EigenPairs pairs = take_pairs(*problem, n, solver.getNumIters());
    make_symmetric(*M, *inverse, assembly, pairs);
    // The operator's eigenvalues are mu = 1/(lambda - shift).
    for (double &value : pairs.values)
      value = shift + 1. / value;
    normalize(*M, assembly, pairs);
    return pairs;
  }

  EigenPairs solve_lobpcg(const Assembly                 &assembly,
                          const SparseValues             &stiffness,
                          const SparseValues             &mass,
                          const std::vector<OwnedVector> &near_kernel,
                          const double                    shift,
                          const unsigned int              n,
                          const double                    tolerance)
  {
    const Epetra_Map map     = make_map(assembly.pattern(), assembly.communicator());
    SparseValues     shifted = stiffness;
    for (std::size_t i = 0; i < shifted.size(); ++i)
      shifted[i] -= shift * mass[i];
    const auto K = make_epetra_matrix(map, assembly.pattern(), shifted);
    const auto M = make_epetra_matrix(map, assembly.pattern(), mass);
    Multigrid  multigrid(*K, near_kernel);
    // Anasazi applies the inverse of a preconditioner by Apply().
    auto inverse = Teuchos::rcp(new Epetra_InvOperator(multigrid.operators.get()));

    // Some vectors beyond those asked for: how fast the last one converges depends on the gap
    // behind the block.
    const unsigned int block = n + 4;
    auto problem = Teuchos::rcp(new Problem(Teuchos::rcp<Epetra_Operator>(K.get(), false),
                                            Teuchos::rcp<Epetra_Operator>(M.get(), false),
                                            make_start(map, assembly.unknowns(), block)));
    problem->setPrec(inverse);
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
    Anasazi::LOBPCGSolMgr<double, Epetra_MultiVector, Epetra_Operator> solver(problem, list);
    solver.solve();
    EigenPairs pairs = take_pairs(*problem, n, solver.getNumIters());
    for (double &value : pairs.values)
      value += shift;
    normalize(*M, assembly, pairs);
    return pairs;
  }

  std::vector<double> compute_residuals(const Assembly     &assembly,
                                        const SparseValues &stiffness,
                                        const SparseValues &mass,
                                        const EigenPairs   &pairs,
                                        const double        scale)
  {
    const Epetra_Map         map = make_map(assembly.pattern(), assembly.communicator());
    const auto               K   = make_epetra_matrix(map, assembly.pattern(), stiffness);
    const auto               M   = make_epetra_matrix(map, assembly.pattern(), mass);
    const Epetra_MultiVector x   = make_multi_vector(map, pairs.vectors);
    Epetra_MultiVector       Kx(x), Mx(x);
    K->Multiply(false, x, Kx);
    M->Multiply(false, x, Mx);
    std::vector<double> residuals;
    for (std::size_t k = 0; k < pairs.values.size(); ++k)
      {
        // |K x - lambda M x|^2 and |M x|^2
        double rest = 0, size = 0;
        for (int i = 0; i < x.MyLength(); ++i)
          {
            const double r = Kx[k][i] - pairs.values[k] * Mx[k][i];
            rest += r * r;
            size += Mx[k][i] * Mx[k][i];
          }
        const double sums[2] = {assembly.communicator().sum(rest),
                                assembly.communicator().sum(size)};
        // Over lambda, and of rigid motions, whose lambda is round-off, over the shift.
        residuals.push_back(std::sqrt(sums[0] / sums[1]) /
                            std::max(std::abs(pairs.values[k]), std::abs(scale)));
      }
    return residuals;
  }

  double compute_orthogonality_defect(const Assembly                 &assembly,
                                      const SparseValues             &mass,
                                      const std::vector<OwnedVector> &vectors)
  {
    const Epetra_Map         map = make_map(assembly.pattern(), assembly.communicator());
    const auto               M   = make_epetra_matrix(map, assembly.pattern(), mass);
    const Epetra_MultiVector x   = make_multi_vector(map, vectors);
    Epetra_MultiVector       Mx(x);
    M->Multiply(false, x, Mx);
    std::vector<double> products;
    for (std::size_t i = 0; i < vectors.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        products.push_back(std::inner_product(vectors[j].begin(), vectors[j].end(), Mx[i], 0.));
    assembly.communicator().sum(products);
    double      defect = 0;
    std::size_t k      = 0;
    for (std::size_t i = 0; i < vectors.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j, ++k)
        defect = std::max(defect, std::abs(products[k] - (i == j ? 1. : 0.)));
    return defect;
  }
} // namespace vfife
