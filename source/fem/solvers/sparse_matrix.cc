// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "epetra_matrix.h"

#include <vfife/fem/solvers/sparse_matrix.h>

#include <numeric>

namespace vfife
{
  struct SparseMatrix::Matrix
  {
    Epetra_Map                        map;
    std::unique_ptr<Epetra_CrsMatrix> values;
  };

  SparseMatrix::SparseMatrix(const Assembly &assembly, const SparseValues &values)
    : communicator_(&assembly.communicator())
    , matrix_(std::make_unique<Matrix>(
        Matrix{make_map(assembly.pattern(), assembly.communicator()), nullptr}))
  {
    matrix_->values = make_epetra_matrix(matrix_->map, assembly.pattern(), values);
  }

  SparseMatrix::SparseMatrix(SparseMatrix &&) noexcept = default;
  SparseMatrix::~SparseMatrix()                        = default;

  OwnedVector SparseMatrix::apply(const OwnedVector &x) const
  {
    const Epetra_MultiVector in = make_multi_vector(matrix_->map, {x});
    Epetra_MultiVector       out(matrix_->map, 1);
    matrix_->values->Multiply(false, in, out);
    return OwnedVector(out[0], out[0] + x.size());
  }

  Eigen::MatrixXd SparseMatrix::project(const std::vector<OwnedVector> &x,
                                        const std::vector<OwnedVector> &y) const
  {
    // Column by column, as Eigen stores them; one reduction for all.
    std::vector<double> products;
    for (const OwnedVector &column : y)
      {
        const OwnedVector image = apply(column);
        for (const OwnedVector &row : x)
          products.push_back(std::inner_product(row.begin(), row.end(), image.begin(), 0.));
      }
    communicator_->sum(products);
    return Eigen::Map<Eigen::MatrixXd>(products.data(), x.size(), y.size());
  }
} // namespace vfife
