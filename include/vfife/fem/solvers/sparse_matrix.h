// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_sparse_matrix_h
#define vfife_fem_solvers_sparse_matrix_h

#include <vfife/fem/solvers/columns.h>

#include <memory>

namespace dealii::Utilities::MPI
{
  class Partitioner;
}

namespace vfife
{
  /**
   * Products of an assembled matrix with distributed vectors. Each row is summed in the order of
   * its columns. All functions are collective.
   */
  class SparseMatrix : public ColumnOperator
  {
  public:
    /** Copies the values other than zero. */
    explicit SparseMatrix(const FemMatrix &matrix);

    void        apply(const Columns &x, Columns &y) const override;
    OwnedVector apply(const OwnedVector &x) const;

    /** x_i^T A y_j, a row for each x. */
    Eigen::MatrixXd project(const std::vector<OwnedVector> &x,
                            const std::vector<OwnedVector> &y) const;

  private:
    void multiply(const double *x, double *y) const;

    const Communicator      *communicator_;
    std::vector<std::size_t> begin_;   ///< of each own row, and one past the last
    std::vector<int>         columns_; ///< own rows from 0, columns of other ranks behind them
    std::vector<double>      values_;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  };
} // namespace vfife

#endif
