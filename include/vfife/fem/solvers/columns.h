// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_columns_h
#define vfife_fem_solvers_columns_h

#include <vfife/fem/system/fem_matrix.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace vfife
{
  /**
   * The rows that this rank owns of several vectors. Copies and views share the memory of the
   * vectors; the communicator must outlive them.
   */
  class Columns
  {
  public:
    /** @p n vectors of zeros, one behind the other in memory. */
    Columns(const Communicator &communicator, std::size_t n_rows, std::size_t n);

    /** Copies @p vectors, at least one, all of the same length. */
    Columns(const Communicator &communicator, const std::vector<OwnedVector> &vectors);

    /** The vectors @p index, in any order and also several times, in the same memory. */
    Columns view(const std::vector<int> &index) const;

    const Communicator &communicator() const
    {
      return *communicator_;
    }
    std::size_t n_rows() const
    {
      return n_rows_;
    }
    std::size_t n() const
    {
      return starts_.size();
    }

    Eigen::Map<Eigen::VectorXd> operator[](const std::size_t k)
    {
      return {starts_[k], static_cast<Eigen::Index>(n_rows_)};
    }
    Eigen::Map<const Eigen::VectorXd> operator[](const std::size_t k) const
    {
      return {starts_[k], static_cast<Eigen::Index>(n_rows_)};
    }

    /** All vectors as a matrix: their memory where they are one behind the other, else @p copy. */
    Eigen::Map<const Eigen::MatrixXd> matrix(Eigen::MatrixXd &copy) const;

    /** x_i . y_k, a row for each vector x of this object. One reduction; collective. */
    Eigen::MatrixXd products(const Columns &y) const;

    /** x_k . y_k for as many vectors as this object has. One reduction; collective. */
    std::vector<double> dot(const Columns &y) const;

  private:
    const Communicator                  *communicator_;
    std::size_t                          n_rows_;
    std::shared_ptr<std::vector<double>> memory_;
    std::vector<double *>                starts_; ///< of the vectors
  };

  /** A linear operator on vectors that are distributed by rows. */
  class ColumnOperator
  {
  public:
    virtual ~ColumnOperator() = default;

    /** y_k = A x_k for each vector; @p y shares no memory with @p x. Collective. */
    virtual void apply(const Columns &x, Columns &y) const = 0;
  };
} // namespace vfife

#endif
