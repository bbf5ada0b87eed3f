// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/equilibrium/relaxation.h>
#include <vfife/dynamics/equilibrium/standing_pattern.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/operator/mass_scaling.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/observers/pattern_writer.h>
#include <vfife/output/observers/probe_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/observers/rim_writer.h>
#include <vfife/output/observers/teeth_writer.h>
#include <vfife/output/pictures.h>
#include <vfife/study/run/contact_figures.h>
#include <vfife/study/run/dynamic_run.h>
#include <vfife/study/run/pair_start.h>
#include <vfife/study/run/run_checks.h>
#include <vfife/study/run/stepping.h>
#include <vfife/study/start_summary.h>

#include <cmath>
#include <optional>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Seconds by section. */
    NamedFigures list_times(const Table &report)
    {
      NamedFigures times;
      for (std::size_t i = 0; i < report.n_rows(); ++i)
        times.emplace_back(report.column("section").texts[i],
                           Figure{report.numbers("time")[i], "s"});
      return times;
    }

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

  void DynamicRun::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    gear_case_.declare(prm, file);
    dynamics_.declare(prm);
    output_.declare(prm);
  }

  void DynamicRun::check() const
  {
    gear_case_.check();
    dynamics_.check("Dynamics");
    if (dynamics_.start == Start::undeformed)
      throw InputError("Dynamics/start",
                       "a gear pair starts by \"static preload\" or \"ramp\"; \"undeformed\" is "
                       "for models of the section Model");
    output_.check("Output");
  }

  void
  DynamicRun::log_step(const Model &model, ExplicitSolver &solver, const double dt, Log &log) const
  {
    const LimitingElement &worst = solver.vfife_operator().limiting_element();
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
             " ns, ",
             std::lround(1. / (gear_case_.mesh_frequency() * dt)),
             " steps a tooth mesh");
    const VfifeOperator &vfife   = solver.vfife_operator();
    const auto           without = [&](const int n) { return 1e9 * vfife.stable_step_without(n); };
    log.line("without the 10 worst ", without(10), " ns, the 100 worst ", without(100), " ns");
    const auto penalties = solver.contact().penalties();
    for (std::size_t i = 0; i < penalties.size(); ++i)
      log.line(
        "contact penalty of the ", model.contacts[i].side, " side ", penalties[i], " N/mm^3");
    log.line(vfife.n_congruence_classes(),
             " classes of congruent elements on this rank, kernels for ",
             vfife.instruction_set());
  }

  double
  DynamicRun::expect_run_time(ExplicitSolver &solver, const State &state, const double dt) const
  {
    // Contact, update and measurement cost about a fifth of the element forces.
    const double steps = gear_case_.operation().meshes / (gear_case_.mesh_frequency() * dt);
    return 1.2 * steps * time_forces(solver.vfife_operator(), state);
  }

  void DynamicRun::report_contradictions(const Model              &model,
                                         ExplicitSolver           &solver,
                                         const double              dt,
                                         const double              run_time,
                                         std::vector<std::string> &found,
                                         Log                      &log) const
  {
    RunPlan plan{gear_case_, dynamics_, output_, model};
    plan.element_step  = dynamics_.safety * solver.element_step();
    plan.stable_step   = solver.stable_step();
    plan.step          = dt;
    plan.expected_time = run_time;
    found              = find_contradictions(plan);
    for (const std::string &sentence : found)
      log.line("check: ", sentence);
    if (found.empty())
      log.line("check: no contradictions");
  }

  void DynamicRun::inspect(Communicator &communicator, Log &log)
  {
    const auto start = WallClock::now();
    Model      model = gear_case_.make_model(dynamics_.start == Start::ramp, log);
    scale_masses(dynamics_, model, log);
    Timers         timers;
    ExplicitSolver solver(model, dynamics_, communicator, log, timers);
    const double   dt = gear_case_.choose_step(solver.stable_step(), output_.history_every);
    solver.set_step(dt);
    log_step(model, solver, dt, log);
    log.line("built in ", seconds_since(start), " s");

    State state;
    solver.start(state);
    const double steps    = gear_case_.operation().meshes / (gear_case_.mesh_frequency() * dt);
    const double run_time = expect_run_time(solver, state, dt);
    log.line("a run is ",
             std::llround(steps),
             " steps, about ",
             duration_text(run_time),
             " with ",
             communicator.size(),
             communicator.size() == 1 ? " rank" : " ranks",
             ", and the equilibrium before it");
    std::vector<std::string> found;
    report_contradictions(model, solver, dt, run_time, found, log);
  }

  namespace
  {
    std::string describe(const RelaxationReport &report)
    {
      std::ostringstream text;
      text << report.steps << " relaxation steps, residual " << report.residual;
      return text.str();
    }

    /** The pattern changes its own forces of inertia by (n Omega/omega_n)^2, n waves around a body
     * of frequency omega_n: a few per cent. */
    constexpr unsigned int pattern_rounds = 2;
  } // namespace

  void DynamicRun::log_preload(const Model &model, const Preload &preload, Log &log) const
  {
    const DeflectionParts &parts = preload.parts;
    log.line("transmission error under load ",
             parts.total / arcsecond,
             " arcsec: centrifugal shift ",
             parts.centrifugal / arcsecond,
             ", web windup ",
             parts.web_windup / arcsecond,
             ", rim tilt and shift ",
             parts.rim_tilt / arcsecond,
             ", teeth and rest ",
             parts.teeth / arcsecond);
    log_contact_figures(model, gear_case_.hertz_contact(), preload.penalty_lag, log);
    log.line("the gear swings at about ",
             preload.swing.frequency(),
             " Hz, ",
             gear_case_.mesh_frequency() / preload.swing.frequency(),
             " tooth meshes a period: stiffness ",
             1e-3 * preload.swing.stiffness,
             " N m/rad, inertia of the shape ",
             1e3 * preload.swing.inertia,
             " kg mm^2");
  }

  DynamicRun::Preload DynamicRun::preload(const Model        &model,
                                          ExplicitSolver     &solver,
                                          State              &state,
                                          const Communicator &communicator,
                                          Log                &log) const
  {
    const auto      start = WallClock::now();
    Relaxation      relaxation(model,
                          dynamics_.relaxation,
                          solver.vfife_operator(),
                          solver.contact(),
                          solver.walls(),
                          communicator,
                          log);
    DeflectionProbe probe(model, communicator);
    const double    torque = gear_case_.operation().torque;
    log.line("equilibrium before the start:");
    std::optional<PairStart> factors;
    if (dynamics_.start_solver == StartSolver::factorization)
      factors.emplace(
        model, dynamics_, relaxation, solver.contact().penalties(), communicator, log);
    const auto relax = [&](const char *name, const Relaxation::Loads &loads) {
      log.line("  ",
               name,
               ": ",
               factors ? factors->solve(state, loads) : describe(relaxation.solve(state, loads)));
    };

    Relaxation::Loads spinning;
    spinning.torque        = 0;
    spinning.contact       = false;
    spinning.hold_rotation = true;
    relax("spinning", spinning);
    probe.take_spun(state);

    // Teeth share the load the better, the larger it is: the swing sees the slope at full torque.
    Relaxation::Loads loads;
    loads.torque    = 0.9;
    loads.looseness = 10;
    relax("at 0.9 of the torque", loads);
    probe.take_partly_loaded(state, loads.torque * torque);
    relax("loaded", Relaxation::Loads());
    Preload result;
    result.parts       = probe.take_loaded(state);
    result.penalty_lag = compute_penalty_lag(solver.contact().energy(), torque);
    result.swing       = probe.compute_swing(state, result.parts, torque);
    StandingPattern pattern(model, communicator);
    if (dynamics_.start == Start::ramp)
      {
        // The flanks of the spun shapes just touch: under a thousandth of the torque.
        loads        = Relaxation::Loads();
        loads.torque = 1e-3;
        relax("touching", loads);
      }
    else
      for (unsigned int round = 0; round < pattern_rounds; ++round)
        {
          pattern.update(state);
          loads         = Relaxation::Loads();
          loads.pattern = &pattern;
          relax("standing in space", loads);
        }
    log.line("  took ", duration_text(seconds_since(start)));
    solver.set_rigid_velocities(state);
    pattern.add_velocities(state.velocity);

    log_preload(model, result, log);
    return result;
  }

  std::size_t DynamicRun::go_on(const std::string  &folder,
                                const EntryValues  &now,
                                const Communicator &communicator,
                                Log                &log)
  {
    checkpoint_ = find_checkpoint(folder, now, communicator, log);
    return checkpoint_->log_size;
  }

  void DynamicRun::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    const Communicator &communicator = folder.communicator();
    Model               model        = gear_case_.make_model(dynamics_.start == Start::ramp, log);
    scale_masses(dynamics_, model, log);
    Timers         timers;
    ExplicitSolver solver(model, dynamics_, communicator, log, timers);
    const double   dt = gear_case_.choose_step(solver.stable_step(), output_.history_every);
    solver.set_step(dt);
    log_step(model, solver, dt, log);

    const Transmission &t             = *model.transmission;
    const std::uint64_t history_steps = output_.compute_history_steps(&t, dt);
    const double        whole_time    = gear_case_.operation().meshes / t.mesh_frequency();
    const double        end_time =
      dynamics_.largest_steps > 0 ? std::min(whole_time, dynamics_.largest_steps * dt) : whole_time;
    const HertzContact hertz = gear_case_.hertz_contact();
    Stepping           stepping(folder, log, model, solver, output_, history_steps);
    RunSummary        &summary = stepping.summary();
    summary                    = start_summary("run", model, solver, dt, communicator);
    summary.figures            = list_figures(model, solver);
    const Table &history       = stepping.add<HistoryWriter>(model, history_steps).table();
    const Table &teeth         = stepping.add<TeethWriter>(model, history_steps, hertz).table();
    stepping.add<PatternWriter>(model,
                                std::max(0., end_time - 1. / t.mesh_frequency()),
                                history_steps);
    stepping.add<ProbeWriter>(history_steps);
    stepping.add<RimWriter>(model, history_steps);
    stepping.add_fields(output_.compute_field_steps(&t, dt), dynamics_);
    report_contradictions(model,
                          solver,
                          dt,
                          expect_run_time(solver, stepping.state(), dt),
                          summary.contradictions,
                          log);

    Preload         equilibrium;
    Stepping::Parts parts;
    parts.prepare = [&](State &state) {
      equilibrium = preload(model, solver, state, communicator, log);
    };
    parts.exchange = [&](ByteStream &stream) {
      stream.pass(equilibrium.parts, equilibrium.swing, equilibrium.penalty_lag);
    };
    parts.complete = [&] {
      complete_summary(model, history, equilibrium, summary, log);
      if (summary.status == "failed")
        return;
      add_contact_figures(model, hertz, equilibrium.penalty_lag, teeth, history.n_rows(), summary);
      summary.timers = list_times(timers.report(communicator));
      if (end_time < whole_time)
        log.line("ended after Dynamics/largest number of steps, ",
                 end_time * t.mesh_frequency(),
                 " of ",
                 gear_case_.operation().meshes,
                 " tooth meshes");
    };
    stepping.run(checkpoint_ ? &*checkpoint_ : nullptr, end_time, whole_time, parts);
    if (output_.pictures)
      draw_pictures(folder, log);
  }
} // namespace vfife
