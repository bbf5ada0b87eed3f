// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/modes/mass_basis.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** A vector whose new part is smaller than this depends on those before it: what is left of it
     * is round-off. */
    constexpr double least_new_part = 1e-8;

    void scale(OwnedVector &vector, const double factor)
    {
      for (double &value : vector)
        value *= factor;
    }
  } // namespace

  double MassBasis::length(const OwnedVector &vector) const
  {
    return std::sqrt(std::max(0., mass_.project({vector}, {vector})(0, 0)));
  }

  bool MassBasis::add(OwnedVector vector)
  {
    const double whole = length(vector);
    if (!(whole > 0))
      return false;
    scale(vector, 1. / whole);
    // Gram-Schmidt twice: the second time takes what round-off of the first has left.
    for (unsigned int pass = 0; pass < 2 && !vectors_.empty(); ++pass)
      {
        const Eigen::VectorXd along = mass_.project(vectors_, {vector}).col(0);
        for (std::size_t k = 0; k < vectors_.size(); ++k)
          for (std::size_t i = 0; i < vector.size(); ++i)
            vector[i] -= along[k] * vectors_[k][i];
      }
    const double rest = length(vector);
    if (!(rest > least_new_part))
      return false;
    scale(vector, 1. / rest);
    vectors_.push_back(std::move(vector));
    return true;
  }

  OwnedVector MassBasis::combine(const Eigen::VectorXd &coefficients) const
  {
    OwnedVector sum(vectors_.front().size(), 0.);
    for (Eigen::Index k = 0; k < coefficients.size(); ++k)
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += coefficients[k] * vectors_[k][i];
    return sum;
  }

  double MassBasis::share(const OwnedVector &vector) const
  {
    if (vectors_.empty())
      return 0.;
    const double whole = length(vector);
    return mass_.project(vectors_, {vector}).squaredNorm() / (whole * whole);
  }
} // namespace vfife
