// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/study/run/stepped_solver.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Wall time of one evaluation of the internal forces [s], which is most of a step. */
    double time_forces(VfifeOperator &vfife, const State &state)
    {
      constexpr unsigned int n      = 10;
      NodeField              forces = vfife.make_field();
      vfife.compute_internal_forces(state.position, forces); // warms the caches
      const auto start = WallClock::now();
      for (unsigned int i = 0; i < n; ++i)
        vfife.compute_internal_forces(state.position, forces);
      return seconds_since(start) / n;
    }
  } // namespace

  SteppedSolver::SteppedSolver(const Model           &model,
                               const DynamicsOptions &options,
                               const Communicator    &communicator,
                               Log                   &log,
                               const ChooseStep      &choose_step)
    : solver(model, options, communicator, log, timers)
    , dt(choose_step(solver.stable_step()))
  {
    // With it the contact finds its penalties.
    solver.set_step(dt);
  }

  void SteppedSolver::log_step(const Model &model, Log &log)
  {
    const VfifeOperator   &vfife = solver.vfife_operator();
    const LimitingElement &worst = vfife.limiting_element();
    log.line("stable step of the elements ",
             1e9 * worst.stable_step(),
             " ns, limited by element ",
             worst.element,
             " of the ",
             worst.body,
             " at (",
             worst.centroid.transpose(),
             ") mm of its body frame; step ",
             1e9 * dt,
             " ns");
    if (model.transmission)
      log.line(std::lround(1. / (model.transmission->largest_mesh_frequency() * dt)),
               " steps a tooth mesh",
               model.transmission->has_constant_rate() ? "" : " at the largest speed");
    // What the mesh would allow without its worst elements: whether a few of them cost all the
    // time.
    const auto without = [&](const int n) { return 1e9 * vfife.stable_step_without(n); };
    log.line("without the 10 worst ", without(10), " ns, the 100 worst ", without(100), " ns");
    // In the order of the model's pairs.
    const auto penalties = solver.contact().penalties();
    for (std::size_t i = 0; i < penalties.size(); ++i)
      log.line(
        "contact penalty of the ", model.contacts[i].side, " side ", penalties[i], " N/mm^3");
    for (const std::string &sentence : solver.contact().describe_coarse_slaves())
      log.line(sentence);
    for (const std::string &sentence : solver.contact().describe_rattling(dt))
      log.warning(sentence);
    log.line(vfife.n_congruence_classes(),
             " classes of congruent elements on this rank, kernels for ",
             vfife.instruction_set());
  }

  double SteppedSolver::expect_run_time(const State &state, const double n_steps)
  {
    // Contact, update and measurement cost about a fifth of the element forces.
    return 1.2 * n_steps * time_forces(solver.vfife_operator(), state);
  }
} // namespace vfife
