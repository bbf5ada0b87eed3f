// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_sweep_error_estimate_h
#define vfife_study_sweep_error_estimate_h

#include <vfife/base/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vfife
{
  /** How the error of a figure was found. */
  enum class ErrorMethod
  {
    not_known, ///< less than two values, or none of the finest
    spread,    ///< largest less smallest value
    richardson ///< distance to the limit of the last three values, with a safety factor
  };

  /** How far the last value of a sequence may be from its limit. */
  struct ErrorEstimate
  {
    double      error  = not_known; ///< not negative
    double      order  = not_known; ///< of Richardson's limit
    ErrorMethod method = ErrorMethod::not_known;
    std::size_t n_used = 0; ///< values that are numbers
    std::size_t n_all  = 0;

    /** "Richardson, order 1.8", "spread of 2 of 3 values". */
    std::string describe() const;
  };

  /**
   * Error of the last one of values that were computed with ever finer numerical parameters; those
   * that are not finite are missing and are left out.
   *
   * With f = f_0 + C h^p through the last three values the error is 1.25 |C| h^p of the last one,
   * where the three are monotone and p is between 0.5 and 2.1. Otherwise there is no order, and the
   * error is the spread, largest less smallest, of all values. Bounds of p and safety factor: L.
   * Eca, M. Hoekstra, A procedure for the estimation of the numerical uncertainty of CFD
   * calculations based on grid refinement studies, J. Comput. Phys. 262 (2014) 104-130. Their
   * factor 3 for sequences without an order is not applied: the spread is a range, not a bound.
   *
   * @param sizes relative sizes h that fall, one for each value; or none, where they are not known:
   * then it is the spread.
   */
  ErrorEstimate estimate_error(const std::vector<double> &values, const std::vector<double> &sizes);
} // namespace vfife

#endif
