// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/dynamics/equilibrium/relaxation.h>
#include <vfife/dynamics/operator/mass_scaling.h>
#include <vfife/fem/system/fem_space.h>
#include <vfife/model/observer.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/observers/field_writer.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/study/cases/model_case.h>
#include <vfife/study/pressure/contact_width_watch.h>
#include <vfife/study/run/stepped_solver.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/study_kinds.h>
#include <vfife/study/turning_axes.h>

namespace vfife
{
  namespace
  {
    /** At rest the step matters to points that stick only. */
    double stable_step_itself(const double stable_step)
    {
      return stable_step;
    }

    class StaticStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        case_.declare(prm, file);
        case_.set_defaults(dynamics_, output_);
        // Few load steps, and a report without a picture of the bodies says little.
        output_.fields_every = 1;
        dynamics_.declare(prm);
        output_.declare(prm);
        // The end time of a run, whose file may be that of its equilibrium as well.
        case_.declare_run(prm);
      }

      void check() const override
      {
        case_.check();
        dynamics_.check("Dynamics");
        output_.check("Output");
        case_.check_dynamics(dynamics_);
      }

      void inspect(Communicator &communicator, Log &log) override
      {
        const Model   model = make_model(log);
        SteppedSolver stepped(model, dynamics_, communicator, log, &stable_step_itself);
        stepped.log_step(model, log);
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      Model     make_model(Log &log) const;
      Observers make_observers(const OutputFolder &folder, const Model &model, Log &log) const;

      ModelCase       case_;
      DynamicsOptions dynamics_;
      OutputOptions   output_;
    };
  } // namespace

  namespace
  {
    /** Why a load step has no equilibrium, and what helps. */
    std::string
    explain_failure(const std::string &reason, const State &state, const unsigned int n_steps)
    {
      // In the state is the last step whose equilibrium was found.
      return "load step " + std::to_string(state.step + 1) + " of " + std::to_string(n_steps) +
             ": " + reason + "; large loads, displacements and angles need more load steps " +
             "(Dynamics/Relaxation/load steps = " + std::to_string(4 * n_steps) + ")";
    }
  } // namespace

  Model StaticStudy::make_model(Log &log) const
  {
    Model model = case_.make_model(log);
    refuse_standing_loads(model,
                          all_bodies(model),
                          "Set the speed of the body to 0, or use kind = run");
    scale_masses(dynamics_, model, log);
    return model;
  }

  Observers
  StaticStudy::make_observers(const OutputFolder &folder, const Model &model, Log &log) const
  {
    // A sample each load step.
    Observers observers;
    observers.push_back(std::make_unique<HistoryWriter>(folder, model, 1));
    if (output_.fields_every > 0)
      observers.push_back(std::make_unique<FieldWriter>(
        folder, model, output_.field_format, 1, dynamics_.stiffness, dynamics_.frame));
    observers.push_back(std::make_unique<ContactWidthWatch>(folder, model, 1, log));
    return observers;
  }

  void StaticStudy::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    const Communicator &communicator = folder.communicator();
    const Model         model        = make_model(log);
    SteppedSolver       stepped(model, dynamics_, communicator, log, &stable_step_itself);
    stepped.log_step(model, log);

    ExplicitSolver &solver    = stepped.solver;
    RunSummary      summary   = start_summary("static", model, solver, stepped.dt, folder);
    Observers       observers = make_observers(folder, model, log);
    Relaxation      relaxation(model,
                          dynamics_.relaxation,
                          solver.vfife_operator(),
                          solver.contact(),
                          solver.walls(),
                          communicator,
                          log);
    State           state;
    solver.start(state);
    const auto         start              = WallClock::now();
    const unsigned int n_steps            = dynamics_.relaxation.load_steps;
    std::uint64_t      n_relaxation_steps = 0;
    const auto         finish             = [&]() {
      // Steps of the summary are those of relaxation, not load steps: they are what takes the time.
      summary.run_time = seconds_since(start);
      summary.steps    = n_relaxation_steps;
      summary.energy   = state.measured.energy;
      write_summary(folder, summary, log);
    };
    try
      {
        // Load step by load step; a row of the histories each, with the part of the loads as its
        // time.
        for (unsigned int step = 1; step <= n_steps; ++step)
          {
            // From the equilibrium before: large loads reach theirs in steps that relaxation can
            // follow.
            Relaxation::Loads loads;
            loads.part                    = static_cast<double>(step) / n_steps;
            const RelaxationReport report = relaxation.solve(state, loads);
            n_relaxation_steps += report.steps;
            log.line("load step ", step, " of ", n_steps, ": ", report.describe());
            state.time = *loads.part;
            state.step = step;
            // On all ranks: its sums over the bodies are collective.
            solver.set_windings(relaxation.windings());
            solver.measure_at_rest(state);
            state.measured.reactions = relaxation.compute_reactions(state, loads);
            for (const auto &observer : observers)
              observer->observe(model, state);
          }
      }
    // Load steps that found their equilibrium keep their rows; why the next one did not is stated
    // before others hear of it.
    catch (const NumericalError &error)
      {
        summary.status  = "failed";
        summary.failure = explain_failure(error.what(), state, n_steps);
        finish();
        throw NumericalError(summary.failure);
      }
    for (const auto &observer : observers)
      observer->finish(model, state);
    finish();
    log.line(
      "finished: ", n_relaxation_steps, " relaxation steps in ", duration_text(summary.run_time));
    if (output_.pictures)
      draw_pictures(folder, log);
  }

  std::unique_ptr<StudyKind> make_static_study()
  {
    return std::make_unique<StaticStudy>();
  }
} // namespace vfife
