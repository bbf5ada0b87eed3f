// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/model/options/bodies_at_start.h>
#include <vfife/output/files/summary.h>
#include <vfife/study/run/stepped_solver.h>

#include <algorithm>
#include <cmath>
#include <sstream>

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

    /** Parts of a run that are no parts of a step. */
    bool is_of_steps(const std::string &section)
    {
      return section != "other" && section != "total";
    }

    void log_times(const Table &times, const double n_steps, Log &log)
    {
      std::ostringstream text;
      set_figure_digits(text, 3);
      for (std::size_t i = 0; i < times.n_rows(); ++i)
        if (const std::string &section = times.column("section").texts[i]; is_of_steps(section))
          text << (text.tellp() > 0 ? ", " : "") << section << ' '
               << 1e3 * times.numbers("time")[i] / n_steps;
      log.line("Timers, a step [ms]: ", text.str());
    }

    void log_traffic(const Table &traffic, Log &log)
    {
      std::ostringstream text;
      set_figure_digits(text, 3);
      for (std::size_t i = 0; i < traffic.n_rows(); ++i)
        {
          const auto number = [&](const char *column) { return traffic.numbers(column)[i]; };
          text << (i > 0 ? "; " : "") << traffic.column("section").texts[i] << ' '
               << number("messages") << " messages of " << 1e-3 * number("bytes of messages")
               << " kB (most of a rank " << number("most messages of a rank") << ", "
               << 1e-3 * number("most bytes of messages of a rank") << " kB), "
               << number("reductions") << " reductions of " << 1e-3 * number("bytes of reductions")
               << " kB";
        }
      log.line("Timers, data sent per rank and step: ", text.str());
    }
  } // namespace

  SteppedSolver::SteppedSolver(const Model           &model,
                               const DynamicsOptions &options,
                               const Communicator    &communicator,
                               Log                   &log,
                               const ChooseStep      &choose_step)
    : timers(&communicator.traffic())
    , solver(model, options, communicator, log, timers)
    , dt(choose_step(solver.stable_step()))
  {
    // Pairs of gears are made to fit.
    if (model.transmissions.empty())
      check_start(model, log);
    solver.set_step(dt);
  }

  void SteppedSolver::log_step(const Model &model, Log &log)
  {
    const VfifeOperator   &vfife = solver.vfife_operator();
    const LimitingElement &worst = vfife.limiting_element();
    log.line("the stable step of the elements is ",
             1e9 * worst.stable_step(),
             " ns, limited by element ",
             worst.element,
             " of the ",
             worst.body,
             " at (",
             worst.centroid.transpose(),
             ") mm of its body frame; the step is ",
             1e9 * dt,
             " ns");
    for (const Transmission &t : model.transmissions)
      log.line(std::lround(1. / (t.largest_mesh_frequency() * dt)),
               " steps per mesh cycle",
               t.has_constant_rate() ? "" : " at the largest speed");
    // What the mesh would allow without its worst elements: whether a few of them cost all the
    // time.
    const auto without = [&](const int n) { return 1e9 * vfife.stable_step_without(n); };
    log.line("without the 10 worst elements it is ",
             without(10),
             " ns, without the 100 worst ",
             without(100),
             " ns");
    // In the order of the model's pairs.
    const auto penalties = solver.contact().penalties();
    for (std::size_t i = 0; i < penalties.size(); ++i)
      log.line("contact penalty of the ",
               model.contacts[i].side,
               " side ",
               penalties[i],
               " N/mm^3",
               model.contacts[i].stiffness.empty() ? "" : ", mean of its points");
    for (const std::string &sentence : solver.walls().describe_penalties())
      log.line(sentence);
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

  void
  SteppedSolver::add_times(const Communicator &communicator, RunSummary &summary, Log &log) const
  {
    const Table times = timers.report(communicator);
    for (std::size_t i = 0; i < times.n_rows(); ++i)
      summary.timers.emplace_back(times.column("section").texts[i],
                                  Figure{times.numbers("time")[i], "s"});

    // The steps of this part of the run, each with one update.
    double      n_steps  = 0;
    const auto &sections = times.column("section").texts;
    if (const auto update = std::find(sections.begin(), sections.end(), "nodal update");
        update != sections.end())
      n_steps = times.numbers("calls")[update - sections.begin()];
    if (!(n_steps > 0))
      return;
    log_times(times, n_steps, log);
    if (communicator.size() == 1)
      return;
    const Table traffic = timers.report_traffic(communicator, n_steps);
    log_traffic(traffic, log);
    for (std::size_t i = 0; i < traffic.n_rows(); ++i)
      {
        NamedFigures figures;
        for (const Table::Column &column : traffic.columns())
          if (!column.is_text)
            figures.emplace_back(column.name, Figure{column.numbers[i], column.unit});
        summary.traffic.emplace_back(traffic.column("section").texts[i], figures);
      }
  }
} // namespace vfife
