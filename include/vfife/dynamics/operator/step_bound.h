// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_operator_step_bound_h
#define vfife_dynamics_operator_step_bound_h

#include <vfife/dynamics/dynamics_options.h>

namespace vfife
{
  class Communicator;
  class Log;
  class VfifeOperator;
  struct Model;

  /** Largest frequency of a whole model without constraints and contact. */
  struct AssembledFrequency
  {
    /** Bound of it, at most that of the worst element [rad/s]. */
    double frequency = 0;
    /** Largest Ritz value, below the largest omega^2 [1/s^2]. */
    double       ritz_value = 0;
    unsigned int iterations = 0;
  };

  /**
   * Bounds the largest omega^2 of K v = omega^2 M v about the undeformed bodies from above, K v as
   * difference of internal forces: k steps of Lanczos' method from a random vector leave the
   * largest Ritz value theta with theta < (1 - eps) omega^2 with a probability of at most
   * 1.648 sqrt(n) exp(-sqrt(eps) (2 k - 1)) for n unknowns (Kuczynski and Wozniakowski, SIAM J.
   * Matrix Anal. Appl. 13 (1992), theorem 4.2), so omega^2 <= theta/(1 - eps). Here eps is 1 %,
   * half a per cent of the step, and k makes the probability 1e-9. The vector depends on the
   * nodes' global numbers only. Collective.
   */
  AssembledFrequency bound_largest_frequency(const Model        &model,
                                             VfifeOperator      &vfife,
                                             const Communicator &communicator);

  /** Stable step of the elements by that bound [s]; says what has been found. Collective. */
  double find_element_step(const Model        &model,
                           StepBound           bound,
                           VfifeOperator      &vfife,
                           const Communicator &communicator,
                           Log                &log);
} // namespace vfife

#endif
