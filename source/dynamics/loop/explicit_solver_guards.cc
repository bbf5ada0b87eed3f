// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What ExplicitSolver stops a run for.
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/operator/broken_element.h>

#include <cmath>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Part of the energy limit from which on there is a warning. */
    constexpr double energy_warning = 0.4;
  } // namespace

  void ExplicitSolver::check(const State &state, const bool measured)
  {
    const auto where = [&] {
      return " at time " + std::to_string(1e3 * state.time) + " ms, step " +
             std::to_string(state.step);
    };
    double kinetic = 0;
    for (const auto &s : sums_)
      kinetic += s.update.kinetic;
    if (!std::isfinite(kinetic))
      throw NumericalError("the motion is no longer finite" + where() + ": " +
                           find_broken_element(model_, observed_, state) +
                           "; a smaller Dynamics/safety or a softer contact may help");
    if (contact_.is_too_deep())
      throw NumericalError("runaway penetration" + where() + ": " +
                           contact_.describe_deepest_point());
    const std::string inverted =
      measured ? find_inverted_element(model_, observed_, measures_, communicator_) : "";
    if (!inverted.empty())
      throw NumericalError("an element is inverted" + where() + ": " + inverted);
    if (!measured)
      return;
    const double error = ledger_.error(), residual = ledger_.residual();
    const auto   says = [&](const std::string &verb) {
      return "the energy error " + verb + " " + std::to_string(error) + where() + " (limit " +
             std::to_string(options_.energy_limit) + ", Dynamics/energy limit)";
    };
    if (!std::isfinite(error))
      throw NumericalError(says("is"));
    if (warning_watch_.exceeds(error, residual, energy_warning * options_.energy_limit) &&
        !std::exchange(energy_warned_, true))
      log_.warning(says("has reached"));
    if (failure_watch_.exceeds(error, residual, options_.energy_limit))
      throw NumericalError(says("is") + " and grows: the integration is unstable");
  }
} // namespace vfife
