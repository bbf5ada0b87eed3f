// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/fem_matrix.h>

#include <algorithm>

namespace vfife
{
  std::vector<double>
  add_scaled(std::vector<double> a, const double factor, const std::vector<double> &b)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] += factor * b[i];
    return a;
  }

  std::size_t SparsePattern::find(const unsigned int row, const unsigned int column) const
  {
    const auto from = columns.begin() + begin[row - first_row];
    const auto to   = columns.begin() + begin[row - first_row + 1];
    return std::lower_bound(from, to, static_cast<int>(column)) - columns.begin();
  }

  OwnedVector FemMatrix::diagonal() const
  {
    OwnedVector d(pattern_->n_rows());
    for (int i = 0; i < pattern_->n_rows(); ++i)
      d[i] = values_[pattern_->find(pattern_->first_row + i, pattern_->first_row + i)];
    return d;
  }

  FemMatrix &FemMatrix::operator*=(const double factor)
  {
    for (double &value : values_)
      value *= factor;
    return *this;
  }

  FemMatrix add_scaled(FemMatrix A, const double factor, const FemMatrix &B)
  {
    A.values() = add_scaled(std::move(A.values()), factor, B.values());
    return A;
  }
} // namespace vfife
