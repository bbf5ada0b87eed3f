// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What ExplicitSolver stops a run for.
#include <vfife/base/errors.h>
#include <vfife/base/log.h>
#include <vfife/dynamics/broken_element.h>
#include <vfife/dynamics/explicit_solver.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Part of the energy limit from which on there is a warning. */
    constexpr double energy_warning = 0.4;

    /** A load that is there at once leaves a residual of half its first step, which is large beside
     * what little energy has moved until then, but does not grow. Samples beyond the limit, and
     * growth of the residual since the first of them, that make a failure. */
    constexpr unsigned int least_samples = 3;
    constexpr double       growth        = 1.5;
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
      measured ? find_inverted_element(model_, observed_, communicator_) : "";
    if (!inverted.empty())
      throw NumericalError("an element is inverted" + where() + ": " + inverted);
    if (!measured)
      return;
    const double error = ledger_.error(), residual = std::abs(ledger_.residual());
    const auto   says = [&](const std::string &verb) {
      return "the energy error " + verb + " " + std::to_string(error) + where() + " (limit " +
             std::to_string(options_.energy_limit) + ", Dynamics/energy limit)";
    };
    if (!std::isfinite(error))
      throw NumericalError(says("is"));
    if (std::abs(error) < energy_warning * options_.energy_limit)
      samples_to_warn_of_ = 0;
    else if (++samples_to_warn_of_ == least_samples)
      log_.warning(says("has reached"));
    if (std::abs(error) < options_.energy_limit)
      samples_beyond_limit_ = 0;
    else if (++samples_beyond_limit_ == 1)
      residual_beyond_limit_ = residual;
    if (samples_beyond_limit_ >= least_samples && residual > growth * residual_beyond_limit_)
      throw NumericalError(says("is") + " and grows: the integration is unstable");
  }
} // namespace vfife
