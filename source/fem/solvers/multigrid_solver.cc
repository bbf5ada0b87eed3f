// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/solvers/multigrid_solver.h>

#include <deal.II/base/config.h>

#include <sstream>

// The only source that sees Trilinos by deal.II, whose headers include Epetra and, up to Trilinos
// 16, ML. VFIFE_WITHOUT_MULTIGRID: the option VFIFE_MULTIGRID of CMake is off.
#if !defined(VFIFE_WITHOUT_MULTIGRID) && defined(DEAL_II_WITH_TRILINOS) &&                         \
  __has_include(<ml_MultiLevelPreconditioner.h>)

#  pragma GCC diagnostic push
#  pragma GCC diagnostic ignored "-Wall"
#  pragma GCC diagnostic ignored "-Wextra"
#  include <Teuchos_ParameterList.hpp>
#  include <deal.II/dofs/dof_accessor.h>
#  include <deal.II/dofs/dof_tools.h>
#  include <deal.II/lac/affine_constraints.h>
#  include <deal.II/lac/full_matrix.h>
#  include <deal.II/lac/solver_cg.h>
#  include <deal.II/lac/trilinos_precondition.h>
#  include <deal.II/lac/trilinos_sparse_matrix.h>
#  include <deal.II/lac/trilinos_sparsity_pattern.h>
#  include <deal.II/lac/trilinos_vector.h>
#  include <deal.II/lac/vector.h>
#  include <ml_MultiLevelPreconditioner.h>
#  pragma GCC diagnostic pop

#  include <algorithm>

namespace vfife
{
  namespace
  {
    namespace Wrappers = dealii::TrilinosWrappers;

    dealii::IndexSet make_own_rows(const SparsePattern &pattern)
    {
      dealii::IndexSet rows(pattern.n);
      rows.add_range(pattern.first_row, pattern.first_row + pattern.n_rows());
      return rows;
    }

    /** Applies an operator of deal.II's wrappers to one vector after the other. */
    template <typename Operator>
    class WrappedOperator : public ColumnOperator
    {
    public:
      explicit WrappedOperator(const Operator &A)
        : A_(A)
      {
      }

      void apply(const Columns &x, Columns &y) const override
      {
        dealii::Vector<double> in(x.n_rows()), out(x.n_rows()); // own rows
        for (std::size_t k = 0; k < x.n(); ++k)
          {
            std::copy_n(x[k].data(), x.n_rows(), in.begin());
            A_.vmult(out, in);
            std::copy_n(out.begin(), x.n_rows(), y[k].data());
          }
      }

    private:
      const Operator &A_;
    };
  } // namespace

  struct MultigridSolver::Operators
  {
    Operators(const FemMatrix &values, const std::vector<OwnedVector> &near_kernel)
      : communicator(values.communicator())
      , rows(make_own_rows(values.pattern()))
      , A(rows, communicator.mpi())
    {
      const SparsePattern                         &pattern = values.pattern();
      std::vector<dealii::types::global_dof_index> columns;
      for (int i = 0; i < pattern.n_rows(); ++i)
        {
          const std::size_t begin = pattern.begin[i], end = pattern.begin[i + 1];
          columns.assign(pattern.columns.begin() + begin, pattern.columns.begin() + end);
          // Without zeros, which multigrid would take for couplings.
          A.set(pattern.first_row + i, end - begin, columns.data(), &values.values()[begin], true);
        }
      A.compress(dealii::VectorOperation::insert);
      prepare(near_kernel);
    }

    Operators(const dealii::DoFHandler<3>             &dofs,
              const dealii::AffineConstraints<double> &lines,
              const CellMatrix                        &cell_matrix,
              const std::vector<OwnedVector>          &near_kernel,
              const Communicator                      &ranks)
      : communicator(ranks)
      , rows(dofs.locally_owned_dofs())
    {
      Wrappers::SparsityPattern pattern(rows,
                                        rows,
                                        dealii::DoFTools::extract_locally_relevant_dofs(dofs),
                                        communicator.mpi());
      dealii::DoFTools::make_sparsity_pattern(dofs, pattern, lines, false, communicator.rank());
      pattern.compress();
      A.reinit(pattern);
      std::vector<dealii::types::global_dof_index> of_cell(dofs.get_fe().n_dofs_per_cell());
      for (const auto &cell : dofs.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(of_cell);
            lines.distribute_local_to_global(cell_matrix(cell), of_cell, A);
          }
      A.compress(dealii::VectorOperation::add);
      prepare(near_kernel);
    }

    void prepare(const std::vector<OwnedVector> &near_kernel)
    {
      matrix = std::make_unique<WrappedOperator<Wrappers::SparseMatrix>>(A);
      cycle  = std::make_unique<WrappedOperator<Wrappers::PreconditionAMG>>(multigrid);
      for (const OwnedVector &motion : near_kernel)
        kernel.insert(kernel.end(), motion.begin(), motion.end());
      Teuchos::ParameterList list;
      ML_Epetra::SetDefaults("SA", list);
      list.set("ML output", 0);
      // Padded unknowns: the three of a point go to one aggregate. Couplings below the threshold do
      // not join points.
      list.set("PDE equations", 3);
      list.set("aggregation: threshold", 1e-3);
      // A polynomial of degree three on the upper nine tenths of the spectrum, symmetric as
      // conjugate gradients ask for.
      list.set("smoother: type", "Chebyshev");
      list.set("smoother: sweeps", 3);
      list.set("smoother: Chebyshev alpha", 10.);
      list.set("coarse: type", "Amesos-KLU");
      list.set("coarse: max size", 1000);
      // The coarse spaces hold what is given here, and nothing else.
      list.set("null space: type", "pre-computed");
      list.set("null space: dimension", static_cast<int>(near_kernel.size()));
      list.set("null space: vectors", kernel.data());
      list.set("null space: add default vectors", false);
      multigrid.initialize(A, list);
    }

    const Communicator             &communicator;
    const dealii::IndexSet          rows; ///< of this rank
    Wrappers::SparseMatrix          A;
    std::vector<double>             kernel; ///< multigrid only points to it
    Wrappers::PreconditionAMG       multigrid;
    std::unique_ptr<ColumnOperator> matrix, cycle;
  };

  OwnedVector MultigridSolver::solve(const OwnedVector &right_side, const double tolerance)
  {
    const Operators      &o = *operators_;
    Wrappers::MPI::Vector b(o.rows, o.communicator.mpi()), x(b), residual(b);
    std::copy(right_side.begin(), right_side.end(), b.begin());
    const double size = b.l2_norm();

    dealii::SolverControl control(1000, tolerance * size, false, false);
    try
      {
        dealii::SolverCG<Wrappers::MPI::Vector>(control).solve(o.A, x, b, o.multigrid);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        // The residual decides.
      }
    n_iterations_ = control.last_step();

    // The recursive residual of the iteration may drift from the true one.
    const double rest = o.A.residual(residual, x, b);
    check_conjugate_gradients(size > 0 ? rest / size : 0., n_iterations_, tolerance);
    return OwnedVector(x.begin(), x.end());
  }

#else

namespace vfife
{
  struct MultigridSolver::Operators
  {
    Operators(const FemMatrix &, const std::vector<OwnedVector> &)
    {
      throw InputError(
        "Fem/linear solver, Fem/eigenvalue solver: expected \"direct\", \"shift-invert\", got "
        "\"multigrid\" or \"lobpcg\". deal.II of this build has no algebraic multigrid "
        "(PreconditionAMG by Epetra and ML of Trilinos). Choose \"direct\" and "
        "\"shift-invert\", or build vfife with such a deal.II.");
    }

    Operators(const dealii::DoFHandler<3> &,
              const dealii::AffineConstraints<double> &,
              const CellMatrix &,
              const std::vector<OwnedVector> &,
              const Communicator &)
    {
      throw InputError("Fem/distributed",
                       "expected no, got yes. deal.II of this build has no algebraic multigrid "
                       "(PreconditionAMG by Epetra and ML of Trilinos). Set no, or build vfife "
                       "with such a deal.II.");
    }

    std::unique_ptr<ColumnOperator> matrix, cycle;
  };

  OwnedVector MultigridSolver::solve(const OwnedVector &right_side, const double)
  {
    return right_side;
  }

#endif

  MultigridSolver::MultigridSolver(const FemMatrix                &matrix,
                                   const std::vector<OwnedVector> &near_kernel)
    : operators_(std::make_unique<Operators>(matrix, near_kernel))
  {
  }

  MultigridSolver::MultigridSolver(const dealii::DoFHandler<3>             &dofs,
                                   const dealii::AffineConstraints<double> &lines,
                                   const CellMatrix                        &cell_matrix,
                                   const std::vector<OwnedVector>          &near_kernel,
                                   const Communicator                      &communicator)
    : operators_(std::make_unique<Operators>(dofs, lines, cell_matrix, near_kernel, communicator))
  {
  }

  MultigridSolver::~MultigridSolver() = default;

  void check_conjugate_gradients(const double       residual,
                                 const unsigned int n_iterations,
                                 const double       tolerance)
  {
    // Ten times: the residual that drifts a little is no failure.
    if (residual <= 10. * tolerance)
      return;
    std::ostringstream text;
    text << "conjugate gradients stopped after " << n_iterations << " iterations at a residual of "
         << residual << " of the load instead of " << tolerance;
    throw NumericalError(text.str());
  }

  const ColumnOperator &MultigridSolver::matrix() const
  {
    return *operators_->matrix;
  }

  const ColumnOperator &MultigridSolver::cycle() const
  {
    return *operators_->cycle;
  }
} // namespace vfife
