// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/command_line.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/column_names.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/observers/rim_writer.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/reduced/reduced_options.h>
#include <vfife/reduced/resonance/linear_response.h>
#include <vfife/reduced/resonance/static_passage.h>
#include <vfife/study/case_runner.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/nearest_wave_summary.h>
#include <vfife/study/reduced/fillet_readings.h>
#include <vfife/study/reduced/pair_reduction.h>
#include <vfife/study/run/pair_start.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/stress_waves/stress_wave_places.h>
#include <vfife/study/study_kinds.h>
#include <vfife/study/waves/driven_lines.h>
#include <vfife/study/waves/driven_wave.h>
#include <vfife/study/waves/line_theory.h>
#include <vfife/study/waves/wave_line_tables.h>
#include <vfife/study/waves/wave_runs.h>
#include <vfife/study/waves/waves_options.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vfife
{
  namespace
  {
    class WavesStudy : public StudyKind
    {
    public:
      explicit WavesStudy(const CaseRunner &runner)
        : runner_(runner)
      {
      }

      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        own_.parameter_file = file.path();
        own_.overrides      = file.overrides();
        pair_case_          = make_pair_case(file);
        pair_case_->declare(prm, file);
        pair_case_->set_defaults(dynamics_, output_);
        dynamics_.declare(prm);
        output_.declare(prm);
        fillets_.declare(prm, file);
        declare_section(prm, "Reduced", reduced_);
        declare_section(prm, "Waves", options_);
      }

      void check() const override
      {
        pair_case_->check();
        pair_case_->operation().require_driving_pinion("Operation", "study of waves");
        pair_case_->operation().require_constant("Operation", "study of waves");
        dynamics_.check("Dynamics");
        output_.check("Output");
        options_.check("Waves");
        const RecordedTeeth teeth = fillets_.teeth;
        if (!fillets_.gauges.empty() ||
            (teeth != RecordedTeeth::none && teeth != RecordedTeeth::all))
          throw InputError("Fillets/teeth", "expected none or all, without gauges");
        if (!(dynamics_.mass_damping() > 0))
          throw InputError("Dynamics/mass proportional damping", "damping must be positive");
        if (dynamics_.damping_rate != DampingRate::momentum)
          throw InputError("Dynamics/damping reference",
                           "must be momentum, because modes are damped relative to this rate");
        if (drives_runs())
          check_run();
      }

      void inspect(Communicator &, Log &log) override
      {
        const Model model = pair_case_->make_model(log);
        check_model(model);
        choose_elements(model, log);
        log.line("waves of the ",
                 model.bodies[model.only_transmission()->driven].name(),
                 " with modes below ",
                 least_cutoff(),
                 " Hz");
        pair_case_->report_checks({&model, &dynamics_, &output_}, log);
        if (drives_runs())
          log.line(
            "each line: ",
            options_.offsets.size(),
            " runs of ",
            reduced_.settling_meshes + reduced_.counted_meshes,
            " mesh cycles or more. For the time of one run use --check with Study/kind = run");
      }

      std::size_t
      resume(const std::string &, const DeclaredSection &, const Communicator &, Log &) override
      {
        if (!drives_runs())
          throw InputError("Waves/solver", "--restart is available only with Waves/solver = run");
        resumes_ = true;
        return std::numeric_limits<std::size_t>::max(); // each run is looked at by itself
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      bool drives_runs() const
      {
        return options_.driven && options_.solver == WaveSolver::run;
      }
      /** Lines that runs repeat have the elements of runs. */
      void choose_elements(const Model &model, Log &log)
      {
        reduced_.choose_elements(model, log, drives_runs());
      }
      void check_run() const;
      /** Mesh frequency at a speed of the driver [rad/s]. */
      double mesh_frequency(const double speed) const
      {
        return pair_case_->mesh_frequency() * speed / pair_case_->operation().speed;
      }
      /** That which is asked for [Hz]. */
      double least_cutoff() const
      {
        return reduced_.find_cutoff(mesh_frequency(options_.highest_speed),
                                    ReducedOptions::rings_of_waves * pair_case_->ring_rate() /
                                      (2 * pi));
      }
      /** At the highest speed: what lies below is between it and rest. */
      std::vector<ReducedBody> reduce(const Model        &model,
                                      const RootStress   *roots,
                                      const Communicator &communicator,
                                      Log                &log) const
      {
        const double       faster     = options_.highest_speed / pair_case_->operation().speed;
        const MoreReadings of_fillets = [&](const unsigned int b) {
          return b == model.only_transmission()->driven ? list_fillet_readings(model, *roots, b)
                                                        : std::vector<SectorReading>();
        };
        return reduce_pair(model,
                           {reduced_.store,
                            reduced_.reach,
                            reduced_.fem(dynamics_.stiffness),
                            least_cutoff(),
                            faster,
                            roots != nullptr ? of_fillets : nullptr},
                           communicator,
                           log);
      }
      /** Throws InputError for bodies that have no reduction, and too many nodal diameters. */
      void check_model(const Model &model) const;
      /** Throws InputError for diameters without a mode of the body. */
      void require_waves(const ReducedBody &body) const;
      struct Tools;
      void
      drive(Tools &tools, const OutputFolder &folder, Log &log, std::vector<WaveLine> &lines) const;
      WaveSchedule       schedule(const Tools &tools, const WaveLine &line, double speed) const;
      ReducedPairOptions pair_options() const;

      const CaseRunner &runner_;
      CommandLine       own_;             ///< file and overrides of the study itself
      bool              resumes_ = false; ///< its runs

      std::unique_ptr<PairCase> pair_case_;
      DynamicsOptions           dynamics_;
      OutputOptions             output_;
      FilletOptions             fillets_;
      ReducedOptions            reduced_;
      WavesOptions              options_;
    };

    void WavesStudy::check_run() const
    {
      if (dynamics_.start != Start::static_preload)
        throw InputError("Dynamics/start",
                         "expected \"static equilibrium\" with Waves/solver = run");
      // Before hours of runs, not behind them.
      constexpr unsigned int least = 8;
      if (reduced_.settling_meshes + reduced_.counted_meshes < least)
        throw InputError("Reduced/settling mesh cycles",
                         "expected at least eight settling and counted mesh cycles");
      runner_.read(WaveRuns::command_line(own_,
                                          options_.highest_speed,
                                          reduced_.settling_meshes + reduced_.counted_meshes,
                                          options_.diameter_numbers().front(),
                                          fillets_.records()));
    }

    void WavesStudy::check_model(const Model &model) const
    {
      for (const Body &body : model.bodies)
        body.require_no_initial_strains("reduced bodies");
      const unsigned int most = RimWriter::count_diameters(model);
      for (const unsigned int n : options_.diameter_numbers())
        if (n > most)
          throw InputError("Waves/nodal diameters",
                           "expected at most " + std::to_string(most) + " nodal diameters");
    }

    void WavesStudy::require_waves(const ReducedBody &body) const
    {
      for (const unsigned int n : options_.diameter_numbers())
        for_entry("Waves/nodal diameters", [&] { find_harmonic(body, n); });
    }

    ReducedPairOptions WavesStudy::pair_options() const
    {
      ReducedPairOptions options;
      options.step    = 1. / (mesh_frequency(options_.highest_speed) * reduced_.steps_per_mesh);
      options.damping = dynamics_.mass_damping();
      options.mesh_damping = dynamics_.mesh_damping;
      return options;
    }

    /** What lines have in common: waves of the driven body, their drive and its linear theory. */
    struct WavesStudy::Tools
    {
      const WavesOptions             &waves;
      const Model                    &model;
      const std::vector<ReducedBody> &bodies;
      ReducedPairOptions              options;
      unsigned int                    n_steps; ///< of a mesh cycle
      const StressWavePlaces         &places;
      ReducedPair                    &pair;

      const Transmission &transmission = *model.only_transmission();
      WaveDriver          driver{model, pair, places};
      StaticPassage       passage{model, pair, n_steps};
      LinearResponse      linear{bodies[transmission.driven],
                            passage,
                            {options.damping, options.mesh_damping},
                            pair.sector_sense(transmission.driven),
                            transmission.driven_sense};
      LineTheory          theory{waves,
                        transmission,
                        model.bodies[transmission.driven].rate < 0 ? -1. : 1.,
                        transmission.driver_rate,
                        linear,
                        driver};
      double cutoff = find_kept_cutoff(bodies); ///< of the modes that the bodies have [Hz]
    };

    WaveSchedule
    WavesStudy::schedule(const Tools &tools, const WaveLine &line, const double speed) const
    {
      const double frequency = mesh_frequency(speed);
      WaveSchedule schedule;
      schedule.speed   = speed;
      schedule.samples = output_.history_every;
      schedule.steps   = reduced_.find_steps(frequency, tools.cutoff, output_.history_every);
      schedule.settling_meshes =
        std::max<unsigned int>(reduced_.settling_meshes,
                               std::ceil(options_.decay_times * frequency /
                                         line.meeting.wave.decay_rate(line.zeta)));
      schedule.counted_meshes = reduced_.counted_meshes;
      return schedule;
    }

    void WavesStudy::drive(Tools                 &tools,
                           const OutputFolder    &folder,
                           Log                   &log,
                           std::vector<WaveLine> &lines) const
    {
      const StressWavePlaces  &places = tools.places;
      const WaveRuns           runs(runner_, own_, tools.model, places, folder, log, resumes_);
      std::vector<NamedSolver> solvers;
      if (drives_runs())
        solvers.push_back({"run", [&runs](const auto &...what) { return runs.drive(what...); }});
      solvers.push_back(
        {"reduced", [&tools](const WaveMeeting &meeting, const WaveSchedule &at, const auto &) {
           return tools.driver.drive(meeting, at);
         }});
      DrivenLines  driven(options_, tools.theory, places, tools.driver, folder, log);
      unsigned int number = 0;
      for (WaveLine &line : lines)
        driven.drive(
          ++number,
          solvers,
          [&](const double speed) { return schedule(tools, line, speed); },
          line);
      driven.finish(lines);
    }

    void WavesStudy::run(OutputFolder &folder, Log &log)
    {
      log.set_verbosity(output_.verbosity);
      Model model = pair_case_->make_model(log);
      check_model(model);
      choose_elements(model, log);
      settle_penalties(
        *pair_case_, reduced_.fem(dynamics_.stiffness), folder.communicator(), log, model);
      const auto                start = WallClock::now();
      std::optional<RootStress> roots;
      if (fillets_.records())
        roots.emplace(model, fillets_);
      const RootStress *const        looked_at = roots ? &*roots : nullptr;
      const std::vector<ReducedBody> bodies = reduce(model, looked_at, folder.communicator(), log);
      const StressWavePlaces         places(model, looked_at);
      ReducedPair                    pair(model, bodies, pair_options());
      RunSummary                     summary = start_summary("waves", model, folder);
      summary.contradictions = pair_case_->report_checks({&model, &dynamics_, &output_}, log);
      summary.cause          = pair_case_->find_cause();

      require_waves(bodies[model.only_transmission()->driven]);
      std::vector<WaveLine>      lines;
      std::optional<NearestWave> nearest;
      try
        {
          Tools tools{
            options_, model, bodies, pair_options(), reduced_.steps_per_mesh, places, pair};
          log.line("static curves over a mesh cycle: contact, teeth and driver contribute ",
                   100. * tools.linear.contact_compliance() * tools.passage.stiffness(),
                   " % of the static rotation");
          write_csv(folder,
                    "waves_in_contact.csv",
                    tools.theory.list_meetings(RimWriter::count_diameters(model)));
          write_csv(folder, "waves_frequencies.csv", tools.theory.list_frequencies());
          lines   = tools.theory.find_lines(dynamics_.mass_damping());
          nearest = tools.theory.find_nearest(pair_case_->operation().speed);
          if (lines.empty())
            log.line("no mesh order excites any of these waves between these speeds");
          for (const WaveLine &line : lines)
            log_wave_line(line, log);
          if (options_.driven)
            drive(tools, folder, log, lines);
        }
      catch (const NumericalError &error)
        {
          summary.fail(error.what());
        }
      Table table = make_wave_line_table();
      for (const WaveLine &line : lines)
        add_wave_lines(line, table);
      write_csv(folder, "waves_lines.csv", table);
      write_own_figures(folder, list_line_figures(lines, nearest));
      summary.run_time = seconds_since(start);
      summary.figures  = {{"cut-off frequency", {find_kept_cutoff(bodies), "Hz"}},
                          {"damping", {dynamics_.mass_damping(), "1/s"}},
                          {"lines", {double(lines.size()), "-"}}};
      if (nearest)
        report_nearest_wave(*nearest, log, summary);
      write_summary(folder, summary, log);
      if (summary.status == "failed")
        throw NumericalError(summary.failure);
      log.line(lines.size(), " lines in ", duration_text(summary.run_time));
      if (output_.pictures)
        draw_pictures(folder, log);
    }
  } // namespace

  std::unique_ptr<StudyKind> make_waves_study(const CaseRunner &runner)
  {
    return std::make_unique<WavesStudy>(runner);
  }
} // namespace vfife
