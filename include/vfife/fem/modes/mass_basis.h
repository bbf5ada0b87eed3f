// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_mass_basis_h
#define vfife_fem_modes_mass_basis_h

#include <vfife/fem/solvers/sparse_matrix.h>

#include <vector>

namespace vfife
{
  /** Vectors that are orthonormal in the product x^T M y of a mass matrix, which must outlive this.
   * All functions are collective. */
  class MassBasis
  {
  public:
    explicit MassBasis(const SparseMatrix &mass)
      : mass_(mass)
    {
    }

    /** Adds the part of @p vector that is orthogonal to the basis, scaled to length one; nothing,
     * and returns false, where that part is below 1e-8 of the vector. */
    bool add(OwnedVector vector);

    const std::vector<OwnedVector> &vectors() const
    {
      return vectors_;
    }

    /** Sum of the first vectors of the basis with coefficients. */
    OwnedVector combine(const Eigen::VectorXd &coefficients) const;

    /** Part of the square of the length of @p vector that lies in the span of the basis [-]. */
    double share(const OwnedVector &vector) const;

  private:
    double length(const OwnedVector &vector) const;

    const SparseMatrix      &mass_;
    std::vector<OwnedVector> vectors_;
  };
} // namespace vfife

#endif
