// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_stable_step_h
#define vfife_element_stable_step_h

#include <vfife/element/hexahedron.h>

namespace vfife
{
  /**
   * Largest circular frequency [rad/s] of the free element with stiffness @p K [N/mm] and lumped
   * @p mass [t], exact. The largest frequency of an assembly is at most the largest one of its
   * elements (Rayleigh quotient; Irons 1971, Fried 1972), also under constraints, so 2 / omega of
   * the worst element is a stable step of central differences. Throws NumericalError unless the
   * masses are positive.
   */
  double compute_largest_frequency(const Matrix24 &K, const Eigen::Matrix<double, 8, 1> &mass);
} // namespace vfife

#endif
