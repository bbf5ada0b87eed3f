// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_fem_matrix_h
#define vfife_fem_system_fem_matrix_h

#include <cstddef>
#include <memory>
#include <vector>

namespace vfife
{
  class Communicator;

  /** One vector of the unknowns that this rank owns. */
  using OwnedVector = std::vector<double>;

  /** a + factor * b. */
  std::vector<double>
  add_scaled(std::vector<double> a, double factor, const std::vector<double> &b);

  /** The rows of this rank of a square sparse matrix; columns ascending. */
  struct SparsePattern
  {
    const Communicator      *communicator;
    int                      n         = 0; ///< of the whole matrix
    int                      first_row = 0;
    std::vector<std::size_t> begin;   ///< of each own row, and one past the last
    std::vector<int>         columns; ///< global

    int n_rows() const
    {
      return static_cast<int>(begin.size()) - 1;
    }
    /** Place of an entry of the pattern among the columns; @p row is an own one, global. */
    std::size_t find(unsigned int row, unsigned int column) const;
  };

  /** The rows of this rank of a square sparse matrix. Matrices of one system share their pattern.
   */
  class FemMatrix
  {
  public:
    /** Zeros. */
    explicit FemMatrix(std::shared_ptr<const SparsePattern> pattern)
      : pattern_(std::move(pattern))
      , values_(pattern_->columns.size(), 0.)
    {
    }

    const SparsePattern &pattern() const
    {
      return *pattern_;
    }
    const Communicator &communicator() const
    {
      return *pattern_->communicator;
    }

    /** In the order of the pattern's columns. */
    const std::vector<double> &values() const
    {
      return values_;
    }
    std::vector<double> &values()
    {
      return values_;
    }
    double &at(const unsigned int row, const unsigned int column)
    {
      return values_[pattern_->find(row, column)];
    }

    /** Diagonal entries of own rows. */
    OwnedVector diagonal() const;

    FemMatrix &operator*=(double factor);

  private:
    std::shared_ptr<const SparsePattern> pattern_;
    std::vector<double>                  values_;
  };

  /** A + factor * B, of one pattern. */
  FemMatrix add_scaled(FemMatrix A, double factor, const FemMatrix &B);
} // namespace vfife

#endif
