// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_matrix_stream_h
#define vfife_reduced_matrix_stream_h

#include <vfife/base/text/byte_stream.h>

namespace vfife
{
  /** Passes a matrix or vector with its size. */
  template <typename Matrix>
  void pass_matrix(Matrix &matrix, ByteStream &stream)
  {
    std::size_t                          n_rows = matrix.rows(), n_columns = matrix.cols();
    std::vector<typename Matrix::Scalar> values(matrix.data(), matrix.data() + matrix.size());
    stream.pass(n_rows, n_columns, values);
    stream.require(values.size() == n_rows * n_columns, "a matrix without all its entries");
    if (stream.reads())
      matrix = Eigen::Map<const Matrix>(values.data(), n_rows, n_columns);
  }
} // namespace vfife

#endif
