// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/dynamics/operator/mass_scaling.h>
#include <vfife/dynamics/watch/measurement.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/study/cases/case.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/cases/damping_figures.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/cases/run_length.h>
#include <vfife/study/continuation.h>
#include <vfife/study/fillets/root_submodels.h>
#include <vfife/study/fillets/submodel_follower.h>
#include <vfife/study/nearest_wave_summary.h>
#include <vfife/study/pressure/contact_width_watch.h>
#include <vfife/study/pressure/instant_options.h>
#include <vfife/study/pressure/pressure_writer.h>
#include <vfife/study/run/explicit_stepping.h>
#include <vfife/study/run/pair_recording.h>
#include <vfife/study/run/pair_start.h>
#include <vfife/study/run/run_start.h>
#include <vfife/study/run/start_kinds.h>
#include <vfife/study/run/stepped_solver.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/study_kinds.h>

#include <cmath>
#include <optional>

namespace vfife
{
  namespace
  {
    /** Beyond it --check names what makes a run short [s]. */
    constexpr double long_wait = 300;

    /** Whether a pair has more elements and mesh cycles than a first look needs. */
    bool is_large(const Model &model, const double end_time)
    {
      constexpr std::size_t  first_elements = 30000;
      constexpr unsigned int first_meshes   = 14;
      std::size_t            elements       = 0;
      for (const Body &body : model.bodies)
        elements += body.n_elements();
      return elements > first_elements ||
             count_meshes(*model.only_transmission(), end_time) > first_meshes;
    }

    /** Strains of fillets from where nodes are. */
    PairReadings::Fillets measure_places(const Model &model, const Communicator &communicator)
    {
      return [&](const RootStress &stress, const RootSubmodels *const submodels) -> FilletMeasure {
        if (submodels != nullptr)
          return [follower = SubmodelFollower(model, *submodels, communicator)](
                   const State &state) mutable { return follower.measure(state); };
        return [places = FilletPlaces(model, stress, communicator)](const State &state) mutable {
          return places.measure(state);
        };
      };
    }

    void add_figures(const NamedFigures &more, NamedFigures &figures)
    {
      figures.insert(figures.end(), more.begin(), more.end());
    }

    class RunStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        case_ = make_case(file);
        case_->declare(prm, file);
        // Before the entries are declared: a default is what its member has at that moment.
        case_->set_defaults(dynamics_, output_);
        dynamics_.declare(prm);
        output_.declare(prm);
        if (case_->pair() != nullptr)
          {
            fillets_.teeth = RecordedTeeth::in_contact;
            fillets_.declare(prm, file);
            instants_.declare(prm);
          }
        case_->declare_run(prm);
      }

      void check() const override
      {
        case_->check();
        dynamics_.check("Dynamics");
        output_.check("Output");
        case_->check_run(dynamics_);
        fillets_.check();
        if (case_->pair() == nullptr)
          output_.refuse_stress_waves("Output");
        instants_.check();
        check_lengths(*case_, dynamics_, output_);
      }

      void        inspect(Communicator &communicator, Log &log) override;
      std::size_t resume(const std::string     &folder,
                         const DeclaredSection &now,
                         const Communicator    &communicator,
                         Log                   &log) override
      {
        // What the log has beyond the checkpoint is written again by the steps that are repeated.
        checkpoint_ = find_checkpoint(
          folder, now, list_changeable(case_->may_be_made_longer()), communicator, log);
        return checkpoint_->log_size;
      }

      void run(OutputFolder &folder, Log &log) override
      {
        log.set_verbosity(output_.verbosity);
        run_lengths(
          *case_, dynamics_, folder, checkpoint_, [&] { return run_once(folder, log); }, log);
        if (output_.pictures)
          draw_pictures(folder, log);
      }

    private:
      /** From the checkpoint, if there is one; returns whether the ripple is steady. */
      bool       run_once(OutputFolder &folder, Log &log);
      Model      make_model(Log &log) const;
      FemOptions fem() const
      {
        return make_fem_options(dynamics_.stiffness);
      }
      double                   choose_step(double stable_step) const;
      std::vector<std::string> report_contradictions(const Model   &model,
                                                     SteppedSolver &stepped,
                                                     double         run_time,
                                                     Log           &log) const;

      /** What is known of the run before its first step, for log and summary. */
      void foresee(const Model        &model,
                   SteppedSolver      &stepped,
                   double              run_time,
                   const Communicator &communicator,
                   Log                &log,
                   RunSummary         &summary) const;

      std::unique_ptr<Case>     case_;
      DynamicsOptions           dynamics_;
      OutputOptions             output_;
      FilletOptions             fillets_;
      InstantOptions            instants_;
      std::optional<Checkpoint> checkpoint_;
    };
  } // namespace

  Model RunStudy::make_model(Log &log) const
  {
    Model model = case_->make_model(log);
    // A case does not know how its run starts: the ramp of the torque is set here.
    if (dynamics_.start == Start::ramp)
      for (Torque &torque : model.torques)
        torque.ramp_time = case_->ramp_time();
    scale_masses(dynamics_, model, log);
    return model;
  }

  double RunStudy::choose_step(const double stable_step) const
  {
    return case_->choose_step(stable_step, output_.history_every);
  }

  std::vector<std::string> RunStudy::report_contradictions(const Model   &model,
                                                           SteppedSolver &stepped,
                                                           const double   run_time,
                                                           Log           &log) const
  {
    // The steps that elements, contact and samples allow, one after the other: checks tell by which
    // of them a run is slow.
    RunPlan plan{&model, &dynamics_, &output_};
    plan.element_step  = dynamics_.safety * stepped.solver.element_step();
    plan.stable_step   = stepped.solver.stable_step();
    plan.step          = stepped.dt;
    plan.expected_time = run_time;
    return case_->report_checks(plan, log);
  }

  void RunStudy::foresee(const Model        &model,
                         SteppedSolver      &stepped,
                         const double        run_time,
                         const Communicator &communicator,
                         Log                &log,
                         RunSummary         &summary) const
  {
    summary.contradictions = report_contradictions(model, stepped, run_time, log);
    summary.cause          = case_->find_cause();
    // For the report.
    if (const PairCase *const pair = case_->pair(); pair != nullptr && output_.pictures)
      report_nearest_wave_of_run(model, pair->ring_rate(), dynamics_, communicator, log, summary);
  }

  void RunStudy::inspect(Communicator &communicator, Log &log)
  {
    // All that a run sets up, and none of its steps: mistakes of mesh, contact and step show here.
    const auto start   = WallClock::now();
    const auto lengths = case_->list_lengths(dynamics_);
    if (!lengths.empty())
      case_->set_length(lengths.front());
    const Model model = make_model(log);
    if (!model.transmissions.empty())
      RootStress(model, fillets_);
    if (instants_.asked_for())
      check_pressures(instants_, fem(), describe_run(*case_->pair(), model, case_->end_time()));
    SteppedSolver stepped(model, dynamics_, communicator, log, [this](const double stable_step) {
      return choose_step(stable_step);
    });
    stepped.log_step(model, log);
    log.line("built in ", seconds_since(start), " s");

    State state;
    stepped.solver.start(state);
    const double n_steps  = case_->end_time() / stepped.dt;
    const double run_time = stepped.expect_run_time(state, n_steps);
    log.line("the run has ",
             lengths.empty() ? "" : "at least ",
             std::llround(n_steps),
             " steps and takes ",
             lengths.empty() ? "about " : "at least ",
             duration_text(run_time),
             " with ",
             communicator.size(),
             communicator.size() == 1 ? " rank" : " ranks",
             dynamics_.start == Start::undeformed ? "" : ", plus the equilibrium before the start");
    if (!model.transmissions.empty() && run_time > long_wait && is_large(model, case_->end_time()))
      log.line("for a shorter run set Gear pair/mesh = coarse, Operation/mesh cycles = 14");
    report_contradictions(model, stepped, run_time, log);
  }

  bool RunStudy::run_once(OutputFolder &folder, Log &log)
  {
    const Communicator &communicator = folder.communicator();
    Model               model        = make_model(log);
    const PairCase     *pair         = case_->pair();
    SettledPenalties    settled;
    if (pair != nullptr)
      settled = settle_penalties(*pair, fem(), communicator, log, model);
    SteppedSolver stepped(model, dynamics_, communicator, log, [this](const double stable_step) {
      return choose_step(stable_step);
    });
    stepped.log_step(model, log);
    const auto submodels =
      pair != nullptr ? make_root_submodels(*pair, fillets_, model, log) : nullptr;

    const Transmission *transmission = model.only_transmission();
    const RunTimes      times = plan_times(*case_, dynamics_, output_, transmission, stepped.dt);
    const auto          start = make_start(
      {model, dynamics_, stepped.solver, std::move(settled.compliance), communicator, log});
    // Checkpoints hold the observers in this order.
    ExplicitStepping stepping({folder, log, model, output_, times}, stepped.solver, *start);
    RunSummary      &summary = stepping.summary();
    summary                  = start_summary("run", model, stepped.solver, stepped.dt, folder);
    const auto   impulse     = [&] { return stepped.solver.contact_impulse(); };
    const Table &history =
      stepping.observers().add<HistoryWriter>(model, times.sample_steps, impulse).table();
    std::optional<PairRecording> recording;
    if (pair != nullptr)
      {
        PairReadings readings;
        readings.probes = [&](const std::vector<Probe> &copies) {
          return measure_probes(
            model, copies, stepping.state(), stepped.solver.vfife_operator(), communicator);
        };
        readings.fillets = measure_places(model, communicator);
        readings.flanks  = gather_flanks(model, communicator);
        recording.emplace(*pair, dynamics_, output_, std::move(readings), history, stepping);
        recording->record_stresses(fillets_, submodels.get(), instants_, fem());
        summary.figures.push_back(
          {"stable step without contact", {1e9 * stepped.solver.element_step(), "ns"}});
        add_figures(settled.figures, summary.figures);
      }
    else if (!model.contacts.empty())
      stepping.observers().add<ContactWidthWatch>(model, times.sample_steps, log);
    stepping.record_bearings();
    add_figures(list_damping(dynamics_, transmission, log), summary.figures);
    stepping.add_fields(output_, stepped.dt, dynamics_);
    const double run_time = stepped.expect_run_time(stepping.state(), times.end / stepped.dt);
    foresee(model, stepped, run_time, communicator, log, summary);
    // The steps; what has been found is put together when they have ended, well or not.
    const auto prepared = [&] {
      if (recording)
        recording->prepare();
    };
    const auto complete = [&] {
      if (recording)
        {
          recording->add_motion(*start->preload());
          recording->add_results(*start->preload());
        }
      if (summary.status != "failed")
        stepped.add_times(communicator, summary, log);
    };
    stepping.run(checkpoint_ ? &*checkpoint_ : nullptr, prepared, complete);
    log.line("finished: ",
             summary.steps,
             " steps in ",
             duration_text(summary.run_time),
             checkpoint_ ? " with the time before the checkpoint, " : ", ",
             1e-6 * summary.element_steps_per_second(),
             " million element-steps per second");
    return summary.steady && summary.steady->has_steady_ripple();
  }

  std::unique_ptr<StudyKind> make_run_study()
  {
    return std::make_unique<RunStudy>();
  }
} // namespace vfife
