// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/communicator.h>
#include <vfife/base/errors.h>
#include <vfife/base/log.h>
#include <vfife/base/revision.h>
#include <vfife/dynamics/explicit_solver.h>
#include <vfife/dynamics/relaxation.h>
#include <vfife/output/checkpoint.h>
#include <vfife/output/field_writer.h>
#include <vfife/output/history_writer.h>
#include <vfife/output/output_folder.h>
#include <vfife/output/pictures.h>
#include <vfife/output/probe_writer.h>
#include <vfife/output/progress_line.h>
#include <vfife/output/teeth_writer.h>
#include <vfife/study/dynamic_run.h>

#include <chrono>
#include <cmath>

namespace vfife
{
  namespace
  {
    using Clock = std::chrono::steady_clock;

    double seconds_since(const Clock::time_point start)
    {
      return std::chrono::duration<double>(Clock::now() - start).count();
    }

    /** Wall time of one evaluation of the internal forces [s], which is most of a step. */
    double time_forces(VfifeOperator &vfife, const State &state)
    {
      constexpr unsigned int n = 10;
      std::vector<double>    forces(vfife.array_size());
      vfife.compute_internal_forces(state.position.data(), forces.data()); // warms the caches
      const auto start = Clock::now();
      for (unsigned int i = 0; i < n; ++i)
        vfife.compute_internal_forces(state.position.data(), forces.data());
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
    const auto penalties = solver.contact().penalties();
    for (std::size_t i = 0; i < penalties.size(); ++i)
      log.line(
        "contact penalty of the ", model.contacts[i].side, " side ", penalties[i], " N/mm^3");
    log.line(solver.vfife_operator().n_congruence_classes(),
             " classes of congruent elements on this rank, kernels for ",
             solver.vfife_operator().instruction_set());
  }

  void DynamicRun::inspect(Communicator &communicator, Log &log)
  {
    const auto     start = Clock::now();
    const Model    model = gear_case_.make_model(dynamics_.start == Start::ramp, log);
    Timers         timers;
    ExplicitSolver solver(model, dynamics_, communicator, log, timers);
    const double   dt = gear_case_.choose_step(solver.stable_step(), output_.history_every);
    solver.set_step(dt);
    log_step(model, solver, dt, log);
    log.line("built in ", seconds_since(start), " s");

    State state;
    solver.start(state);
    const double steps = gear_case_.operation().meshes / (gear_case_.mesh_frequency() * dt);
    log.line("a run is ",
             std::llround(steps),
             " steps, about ",
             duration_text(1.2 * steps * time_forces(solver.vfife_operator(), state)),
             " with ",
             communicator.size(),
             communicator.size() == 1 ? " rank" : " ranks",
             ", and the equilibrium before it");
  }

  DeflectionParts DynamicRun::preload(const Model        &model,
                                      ExplicitSolver     &solver,
                                      State              &state,
                                      const Communicator &communicator,
                                      Log                &log) const
  {
    const auto start = Clock::now();
    Relaxation relaxation(
      model, dynamics_.relaxation, solver.vfife_operator(), solver.contact(), communicator, log);
    DeflectionProbe probe(model, communicator);

    Relaxation::Loads spinning;
    spinning.torque             = 0;
    spinning.contact            = false;
    spinning.hold_rotation      = true;
    const RelaxationReport spun = relaxation.solve(state, spinning);
    probe.take_spun(state);

    // A ramp starts where the flanks of the spun shapes just touch: under a thousandth of the
    // torque.
    Relaxation::Loads loaded;
    loaded.torque               = dynamics_.start == Start::ramp ? 1e-3 : 1.;
    const RelaxationReport full = relaxation.solve(state, loaded);
    log.line("equilibrium before the start: spinning ",
             spun.steps,
             " steps, ",
             dynamics_.start == Start::ramp ? "touching " : "loaded ",
             full.steps,
             " steps, residual ",
             full.residual,
             ", ",
             duration_text(seconds_since(start)));
    solver.set_rigid_velocities(state);

    const DeflectionParts parts = probe.take_loaded(state);
    log.line("transmission error at the start ",
             parts.total / arcsecond,
             " arcsec: centrifugal shift ",
             parts.centrifugal / arcsecond,
             ", web windup ",
             parts.web_windup / arcsecond,
             ", rim tilt and shift ",
             parts.rim_tilt / arcsecond,
             ", teeth and rest ",
             parts.teeth / arcsecond);
    return parts;
  }

  RunSummary DynamicRun::start_summary(const Model        &model,
                                       ExplicitSolver     &solver,
                                       const double        dt,
                                       const Communicator &communicator) const
  {
    RunSummary summary;
    summary.study           = "run";
    summary.version         = program_version();
    summary.revision        = program_revision();
    summary.instruction_set = solver.vfife_operator().instruction_set();
    summary.ranks           = communicator.size();
    summary.dt              = dt;
    for (const Body &body : model.bodies)
      summary.bodies.push_back({body.name(),
                                body.n_elements(),
                                body.n_nodes(),
                                body.mass(),
                                body.axial_inertia(),
                                body.rate});

    const Transmission &t      = *model.transmission;
    const double        torque = gear_case_.operation().torque;
    summary.figures            = {{"mesh frequency", {t.mesh_frequency(), "Hz"}},
                                  {"pinion speed", {t.driver_rate * 30. / pi, "rpm"}},
                                  {"gear torque", {1e-3 * torque, "N m"}},
                                  {"effective arm", {t.arm, "mm"}},
                                  {"torque over effective arm", {torque / t.arm, "N"}},
                                  {"stable step of the elements",
                                   {1e9 * solver.vfife_operator().limiting_element().stable_step(), "ns"}},
                                  {"contact penalty", {solver.contact().penalties().front(), "N/mm^3"}}};
    return summary;
  }

  void DynamicRun::finish_summary(const Model    &model,
                                  ExplicitSolver &solver,
                                  const State    &state,
                                  const Table    &history,
                                  RunSummary     &summary,
                                  Log            &log) const
  {
    summary.time    = state.time;
    summary.steps   = state.step;
    summary.energy  = state.measured.energy;
    summary.damping = solver.damping_audit();
    for (const Log::Warning &warning : log.warnings())
      summary.warnings.push_back(warning.text);
    if (history.n_rows() < 2)
      return;

    const double ramp_end = dynamics_.start == Start::ramp
                              ? gear_case_.operation().ramp / model.transmission->mesh_frequency()
                              : 0.;
    summary.steady =
      find_steady_part(history, output_.history_every, swing_period_meshes(), ramp_end);
    log.line(summary.steady->explain());
    for (const char *name : {"contact force total", "dte", "rim dte"})
      {
        const ColumnStatistics &c = summary.steady->column(name);
        log.line("  ",
                 name,
                 ": mean ",
                 c.mean,
                 " ",
                 c.unit,
                 ", peak to peak ",
                 c.peak_to_peak,
                 " ",
                 c.unit);
      }
  }

  double DynamicRun::swing_period_meshes() const
  {
    return gear_case_.has_web() ? 13. : 4.;
  }

  void DynamicRun::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    const Communicator &communicator = folder.communicator();
    const Model         model        = gear_case_.make_model(dynamics_.start == Start::ramp, log);
    Timers              timers;
    ExplicitSolver      solver(model, dynamics_, communicator, log, timers);
    const double        dt = gear_case_.choose_step(solver.stable_step(), output_.history_every);
    solver.set_step(dt);
    log_step(model, solver, dt, log);
    RunSummary summary = start_summary(model, solver, dt, communicator);

    const Transmission &t             = *model.transmission;
    const std::uint64_t history_steps = output_.compute_history_steps(&t, dt);
    const double        end_time      = gear_case_.operation().meshes / t.mesh_frequency();
    Observers           observers;
    observers.push_back(std::make_unique<HistoryWriter>(folder, model, history_steps));
    const auto &history = static_cast<const HistoryWriter &>(*observers.back()).table();
    observers.push_back(std::make_unique<TeethWriter>(folder, model, history_steps));
    observers.push_back(std::make_unique<ProbeWriter>(folder, history_steps));
    if (output_.fields_every > 0)
      observers.push_back(std::make_unique<FieldWriter>(
        folder, model, output_.compute_field_steps(&t, dt), dynamics_.stiffness, dynamics_.frame));
    if (output_.checkpoint_every > 0)
      observers.push_back(
        std::make_unique<CheckpointWriter>(folder, output_.checkpoint_every, history_steps));
    observers.push_back(
      std::make_unique<ProgressLine>(log, communicator, 0., end_time, history_steps));

    State state;
    solver.start(state);
    const auto start = Clock::now();
    try
      {
        const DeflectionParts parts = preload(model, solver, state, communicator, log);
        summary.transmission_error  = {
           {"total at the start", {parts.total / arcsecond, "arcsec"}},
           {"teeth and rest", {parts.teeth / arcsecond, "arcsec"}},
           {"web windup", {parts.web_windup / arcsecond, "arcsec"}},
           {"rim tilt and shift", {parts.rim_tilt / arcsecond, "arcsec"}},
           {"centrifugal shift", {parts.centrifugal / arcsecond, "arcsec"}}};
        const auto run_start = Clock::now();
        solver.run(state, end_time, observers);
        summary.run_time = seconds_since(run_start);
      }
    catch (const NumericalError &error)
      {
        summary.status   = "failed";
        summary.failure  = error.what();
        summary.run_time = seconds_since(start);
        finish_summary(model, solver, state, history, summary, log);
        if (!(output_.checkpoint_every > 0)) // else the last good one is kept
          write_checkpoint(folder, model, state);
        write_summary(folder, summary);
        throw;
      }
    finish_summary(model, solver, state, history, summary, log);
    const Table times = timers.report(communicator);
    for (std::size_t i = 0; i < times.n_rows(); ++i)
      summary.timers.emplace_back(times.column("section").texts[i],
                                  Figure{times.numbers("time")[i], "s"});
    write_summary(folder, summary);
    log.line("finished: ",
             state.step,
             " steps in ",
             duration_text(summary.run_time),
             ", ",
             1e-6 * summary.element_steps_per_second(),
             " million element-steps a second");
    if (output_.pictures)
      draw_pictures(folder, log);
  }
} // namespace vfife
