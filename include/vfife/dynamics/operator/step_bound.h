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
    /** sqrt(quotient + deviation), at most that of the worst element [rad/s]. An estimate, no
     * bound: the safety of the step covers the rest. */
    double frequency = 0;
    /** Rayleigh quotient omega^2 of the last vector, below the largest one [1/s^2]. */
    double quotient = 0;
    /** Within this distance of the quotient there is an eigenvalue [1/s^2]. */
    double       deviation  = 0;
    unsigned int iterations = 0;
  };

  /**
   * Power iteration v <- M^-1 K v about the undeformed bodies, K v as difference of internal
   * forces, until the deviation is 1 % of the quotient, 400 times at most. Starts from numbers that
   * depend on the nodes' global numbers only. Collective.
   */
  AssembledFrequency iterate_largest_frequency(const Model        &model,
                                               VfifeOperator      &vfife,
                                               const Communicator &communicator);

  /** Stable step of the elements by that bound [s]; says what a power iteration found. Collective.
   */
  double find_element_step(const Model        &model,
                           StepBound           bound,
                           VfifeOperator      &vfife,
                           const Communicator &communicator,
                           Log                &log);
} // namespace vfife

#endif
