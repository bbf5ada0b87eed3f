// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/fem/solvers/sparse_matrix.h>

#include <deal.II/base/partitioner.h>

#include <algorithm>

namespace vfife
{
  SparseMatrix::SparseMatrix(const FemMatrix &matrix)
    : communicator_(&matrix.communicator())
  {
    // The pattern is that of all matrices of a system: each has zeros of its own.
    const SparsePattern       &pattern = matrix.pattern();
    const std::vector<double> &values  = matrix.values();
    const std::size_t n_kept = values.size() - std::count(values.begin(), values.end(), 0.);
    columns_.reserve(n_kept);
    values_.reserve(n_kept);
    begin_.push_back(0);
    for (int i = 0; i < pattern.n_rows(); ++i)
      {
        for (std::size_t k = pattern.begin[i]; k < pattern.begin[i + 1]; ++k)
          if (values[k] != 0)
            {
              columns_.push_back(pattern.columns[k]);
              values_.push_back(values[k]);
            }
        begin_.push_back(columns_.size());
      }

    dealii::IndexSet own(pattern.n), others(pattern.n);
    own.add_range(pattern.first_row, pattern.first_row + pattern.n_rows());
    std::vector<int> halo; // columns of other ranks
    std::copy_if(columns_.begin(), columns_.end(), std::back_inserter(halo), [&](const int column) {
      return !own.is_element(column);
    });
    std::sort(halo.begin(), halo.end());
    others.add_indices(halo.begin(), std::unique(halo.begin(), halo.end()));
    partitioner_ =
      std::make_shared<const dealii::Utilities::MPI::Partitioner>(own,
                                                                  others,
                                                                  communicator_->mpi());
    for (int &column : columns_)
      column = partitioner_->global_to_local(column);
  }

  void SparseMatrix::multiply(const double *x, double *y) const
  {
    const std::size_t   n_rows = begin_.size() - 1;
    std::vector<double> all; // own values, those of other ranks behind them
    if (communicator_->size() > 1)
      {
        all.assign(x, x + n_rows);
        all.resize(n_rows + partitioner_->n_ghost_indices());
        std::vector<double>             sent(partitioner_->n_import_indices());
        std::vector<MPI_Request>        requests;
        const dealii::ArrayView<double> others(all.data() + n_rows, all.size() - n_rows);
        partitioner_->export_to_ghosted_array_start(0,
                                                    dealii::ArrayView<const double>(x, n_rows),
                                                    dealii::make_array_view(sent),
                                                    others,
                                                    requests);
        partitioner_->export_to_ghosted_array_finish(others, requests);
        x = all.data();
      }
    for (std::size_t i = 0; i < n_rows; ++i)
      {
        double sum = 0;
        for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
          sum += values_[k] * x[columns_[k]];
        y[i] = sum;
      }
  }

  void SparseMatrix::apply(const Columns &x, Columns &y) const
  {
    for (std::size_t k = 0; k < x.n(); ++k)
      multiply(x[k].data(), y[k].data());
  }

  OwnedVector SparseMatrix::apply(const OwnedVector &x) const
  {
    OwnedVector y(x.size());
    multiply(x.data(), y.data());
    return y;
  }

  Eigen::MatrixXd SparseMatrix::project(const std::vector<OwnedVector> &x,
                                        const std::vector<OwnedVector> &y) const
  {
    // Column by column, as Eigen stores them; one reduction for all.
    using Vector = Eigen::Map<const Eigen::VectorXd>;
    std::vector<double> products;
    for (const OwnedVector &column : y)
      {
        const OwnedVector image = apply(column);
        for (const OwnedVector &row : x)
          products.push_back(
            Vector(row.data(), row.size()).dot(Vector(image.data(), image.size())));
      }
    communicator_->sum(products);
    return Eigen::Map<Eigen::MatrixXd>(products.data(), x.size(), y.size());
  }
} // namespace vfife
