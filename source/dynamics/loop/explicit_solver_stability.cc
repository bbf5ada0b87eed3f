// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of ExplicitSolver that knows of steps beyond that of the worst element.
#include <vfife/base/errors.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/watch/guards.h>

namespace vfife
{
  bool ExplicitSolver::may_be_unstable() const
  {
    return dt_ > safe_step_ * (1. + 1e-9);
  }

  double ExplicitSolver::alternating_share() const
  {
    return alternating_share_;
  }

  unsigned int ExplicitSolver::n_substeps() const
  {
    return n_substeps_;
  }

  void ExplicitSolver::divide_step(State &state, const unsigned int n)
  {
    const double earlier = dt_;
    n_substeps_          = n;
    dt_                  = state.dt / n;
    compute_forces(state, false);
    for (const std::uint32_t i : state.partition->nodes())
      state.velocity.add(i, 0.5 * (earlier - dt_) * state.position.number(i) * forces_.value(i));
  }

  void ExplicitSolver::check_stability(const State &state, const ElementMeasures &measures)
  {
    // Where nothing moves, round-off alternates.
    const double elastic = measures.strain_energy + contact_.energy() + walls_.energy();
    alternating_share_ = alternating_energy_ > energy_.round_off(observed_.step - beginning_->step)
                           ? alternating_energy_ / elastic
                           : 0;
    if (stability_watch_.exceeds(alternating_share_, alternating_energy_, 1.))
      throw NumericalError(
        "time step unstable " + describe_instant(state) +
        ": a motion that alternates from step to step grows. Reduce Dynamics/time step factor");
  }
} // namespace vfife
