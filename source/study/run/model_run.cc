// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/timers.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/dynamics/equilibrium/relaxation.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/operator/mass_scaling.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/observers/field_writer.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/pictures.h>
#include <vfife/study/run/model_run.h>
#include <vfife/study/run/stepping.h>
#include <vfife/study/start_summary.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  ModelStudy::ModelStudy()
  {
    // A general model moves as it is told: no start of a gear pair, no dampers.
    dynamics_.start        = Start::undeformed;
    dynamics_.damping      = 0;
    dynamics_.mesh_damping = 0;
    output_.fields_every   = 0;
  }

  void ModelStudy::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    model_.declare(prm, file);
    dynamics_.declare(prm);
    output_.declare(prm);
  }

  void ModelStudy::check() const
  {
    model_.check();
    dynamics_.check("Dynamics");
    output_.check("Output");
    if (dynamics_.start == Start::ramp)
      throw InputError("Dynamics/start",
                       "a ramp of the torque is for gear pairs; loads of a model have histories");
    if (dynamics_.mesh_damping > 0)
      throw InputError("Dynamics/mesh damping", "there is no gear pair in the model");
  }

  void ModelStudy::log_model(const Model &model, Log &log) const
  {
    for (const Body &body : model.bodies)
      {
        const MeshQuality quality = compute_mesh_quality(body.mesh().triangulation);
        log.line(body.name(),
                 ": ",
                 quality.cells,
                 " elements, ",
                 quality.nodes,
                 " nodes, mass ",
                 1e3 * body.mass(),
                 " kg, least scaled Jacobian ",
                 quality.least_scaled_jacobian,
                 ", least edge ",
                 quality.least_edge,
                 " mm");
      }
  }

  void ModelStudy::log_step(ExplicitSolver &solver, const double dt, Log &log) const
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
             " ns");
    const VfifeOperator &vfife   = solver.vfife_operator();
    const auto           without = [&](const int n) { return 1e9 * vfife.stable_step_without(n); };
    log.line("without the 10 worst ", without(10), " ns, the 100 worst ", without(100), " ns");
    log.line(solver.vfife_operator().n_congruence_classes(),
             " classes of congruent elements on this rank, kernels for ",
             solver.vfife_operator().instruction_set());
  }

  Observers ModelStudy::make_observers(const OutputFolder &folder,
                                       const Model        &model,
                                       const std::uint64_t history_steps,
                                       const std::uint64_t field_steps) const
  {
    Observers observers;
    observers.push_back(std::make_unique<HistoryWriter>(folder, model, history_steps));
    if (field_steps > 0)
      observers.push_back(std::make_unique<FieldWriter>(
        folder, model, field_steps, dynamics_.stiffness, dynamics_.frame));
    return observers;
  }

  void ModelRun::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    ModelStudy::declare(prm, file);
    Subsection section(prm, "Dynamics");
    declare_quantity(
      prm, "end time", end_time_, "s", "Time at which the run ends", Range::not_negative());
  }

  void ModelRun::check() const
  {
    ModelStudy::check();
    if (!(end_time_ > 0))
      throw InputError("Dynamics/end time", "the end of the run is missing or zero");
  }

  double ModelRun::choose_step(const double stable_step) const
  {
    return end_time_ / std::ceil(end_time_ / stable_step);
  }

  void ModelRun::inspect(Communicator &communicator, Log &log)
  {
    Model model = model_.make_model();
    scale_masses(dynamics_, model, log);
    log_model(model, log);
    Timers         timers;
    ExplicitSolver solver(model, dynamics_, communicator, log, timers);
    const double   dt = choose_step(solver.stable_step());
    solver.set_step(dt);
    log_step(solver, dt, log);
    log.line("a run is ", std::llround(end_time_ / dt), " steps");
  }

  std::size_t ModelRun::go_on(const std::string  &folder,
                              const EntryValues  &now,
                              const Communicator &communicator,
                              Log                &log)
  {
    checkpoint_ = find_checkpoint(folder, now, communicator, log);
    return checkpoint_->log_size;
  }

  void ModelRun::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    const Communicator &communicator = folder.communicator();
    Model               model        = model_.make_model();
    scale_masses(dynamics_, model, log);
    log_model(model, log);
    Timers         timers;
    ExplicitSolver solver(model, dynamics_, communicator, log, timers);
    const double   dt = choose_step(solver.stable_step());
    solver.set_step(dt);
    log_step(solver, dt, log);
    const double end_time =
      dynamics_.largest_steps > 0 ? std::min(end_time_, dynamics_.largest_steps * dt) : end_time_;

    const std::uint64_t history_steps = output_.compute_history_steps(nullptr, dt);
    Stepping            stepping(folder, log, model, solver, output_, history_steps);
    stepping.summary() = start_summary("run", model, solver, dt, communicator);
    stepping.add<HistoryWriter>(model, history_steps);
    stepping.add_fields(output_.compute_field_steps(nullptr, dt), dynamics_);

    Stepping::Parts parts;
    parts.prepare = [&](State &state) {
      if (dynamics_.start != Start::static_preload)
        return;
      Relaxation             relaxation(model,
                            dynamics_.relaxation,
                            solver.vfife_operator(),
                            solver.contact(),
                            solver.walls(),
                            communicator,
                            log);
      const RelaxationReport report = relaxation.solve(state, Relaxation::Loads());
      log.line(
        "equilibrium before the start: ", report.steps, " steps, residual ", report.residual);
      solver.set_rigid_velocities(state);
    };
    stepping.run(checkpoint_ ? &*checkpoint_ : nullptr, end_time, end_time_, parts);
    if (output_.pictures)
      draw_pictures(folder, log);
  }

  void StaticRun::inspect(Communicator &communicator, Log &log)
  {
    Model model = model_.make_model();
    scale_masses(dynamics_, model, log);
    log_model(model, log);
    Timers         timers;
    ExplicitSolver solver(model, dynamics_, communicator, log, timers);
    log_step(solver, solver.stable_step(), log);
  }

  void StaticRun::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    const Communicator &communicator = folder.communicator();
    Model               model        = model_.make_model();
    scale_masses(dynamics_, model, log);
    log_model(model, log);
    Timers         timers;
    ExplicitSolver solver(model, dynamics_, communicator, log, timers);
    const double   dt = solver.stable_step();
    solver.set_step(dt);
    log_step(solver, dt, log);

    RunSummary summary   = start_summary("static", model, solver, dt, communicator);
    Observers  observers = make_observers(folder, model, 1, output_.fields_every > 0 ? 1 : 0);
    Relaxation relaxation(model,
                          dynamics_.relaxation,
                          solver.vfife_operator(),
                          solver.contact(),
                          solver.walls(),
                          communicator,
                          log);
    State      state;
    solver.start(state);
    const auto         start              = WallClock::now();
    const unsigned int n_steps            = dynamics_.relaxation.load_steps;
    std::uint64_t      n_relaxation_steps = 0;
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        Relaxation::Loads loads;
        loads.part                    = static_cast<double>(step) / n_steps;
        const RelaxationReport report = relaxation.solve(state, loads);
        n_relaxation_steps += report.steps;
        log.line("load step ",
                 step,
                 " of ",
                 n_steps,
                 ": ",
                 report.steps,
                 " relaxation steps, residual ",
                 report.residual);
        state.time = *loads.part;
        state.step = step;
        solver.measure_at_rest(state);
        for (const auto &observer : observers)
          observer->observe(model, state);
      }
    for (const auto &observer : observers)
      observer->finish(model, state);
    summary.run_time = seconds_since(start);
    summary.steps    = n_relaxation_steps;
    summary.energy   = state.measured.energy;
    for (const Log::Warning &warning : log.warnings())
      summary.warnings.push_back(warning.text);
    write_summary(folder, summary);
    log.line(
      "finished: ", n_relaxation_steps, " relaxation steps in ", duration_text(summary.run_time));
    if (output_.pictures)
      draw_pictures(folder, log);
  }
} // namespace vfife
