// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/fem/solvers/columns.h>

#include <algorithm>

namespace vfife
{
  Columns::Columns(const Communicator &communicator, const std::size_t n_rows, const std::size_t n)
    : communicator_(&communicator)
    , n_rows_(n_rows)
    , memory_(std::make_shared<std::vector<double>>(n_rows * n, 0.))
  {
    for (std::size_t k = 0; k < n; ++k)
      starts_.push_back(memory_->data() + k * n_rows);
  }

  Columns::Columns(const Communicator &communicator, const std::vector<OwnedVector> &vectors)
    : Columns(communicator, vectors.front().size(), vectors.size())
  {
    for (std::size_t k = 0; k < vectors.size(); ++k)
      std::copy(vectors[k].begin(), vectors[k].end(), starts_[k]);
  }

  Columns Columns::view(const std::vector<int> &index) const
  {
    Columns part(*this);
    part.starts_.clear();
    for (const int k : index)
      part.starts_.push_back(starts_[k]);
    return part;
  }

  Eigen::Map<const Eigen::MatrixXd> Columns::matrix(Eigen::MatrixXd &copy) const
  {
    const Columns &x         = *this;
    bool           is_behind = true;
    for (std::size_t k = 1; k < n(); ++k)
      is_behind = is_behind && starts_[k] == starts_[k - 1] + n_rows_;
    if (!is_behind)
      {
        copy.resize(n_rows_, n());
        for (std::size_t k = 0; k < n(); ++k)
          copy.col(k) = x[k];
      }
    return {is_behind ? starts_.front() : copy.data(),
            static_cast<Eigen::Index>(n_rows_),
            static_cast<Eigen::Index>(n())};
  }

  Eigen::MatrixXd Columns::products(const Columns &y) const
  {
    Eigen::MatrixXd copy_of_x, copy_of_y;
    Eigen::MatrixXd sums = matrix(copy_of_x).transpose() * y.matrix(copy_of_y);
    communicator_->sum(sums.data(), sums.size());
    return sums;
  }

  std::vector<double> Columns::dot(const Columns &y) const
  {
    const Columns      &x = *this;
    std::vector<double> sums;
    for (std::size_t k = 0; k < n(); ++k)
      sums.push_back(x[k].dot(y[k]));
    communicator_->sum(sums);
    return sums;
  }
} // namespace vfife
