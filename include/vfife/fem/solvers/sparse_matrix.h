// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_sparse_matrix_h
#define vfife_fem_solvers_sparse_matrix_h

#include <vfife/fem/system/assembly.h>

#include <memory>

namespace vfife
{
  /** Products of an assembled matrix with distributed vectors. All functions are collective. */
  class SparseMatrix
  {
  public:
    SparseMatrix(const Assembly &assembly, const SparseValues &values);
    SparseMatrix(SparseMatrix &&) noexcept;
    ~SparseMatrix();

    OwnedVector apply(const OwnedVector &x) const;

    /** x_i^T A y_j, a row for each x. */
    Eigen::MatrixXd project(const std::vector<OwnedVector> &x,
                            const std::vector<OwnedVector> &y) const;

  private:
    struct Matrix;

    const Communicator     *communicator_;
    std::unique_ptr<Matrix> matrix_;
  };
} // namespace vfife

#endif
