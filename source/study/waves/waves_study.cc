// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/section_of_options.h>
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
#include <vfife/study/cases/gear_case.h>
#include <vfife/study/reduced/fillet_readings.h>
#include <vfife/study/reduced/pair_reduction.h>
#include <vfife/study/run/run_penalties.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/waves/line_theory.h>
#include <vfife/study/waves/linear_response.h>
#include <vfife/study/waves/static_passage.h>
#include <vfife/study/waves/wave_line.h>
#include <vfife/study/waves/waves_options.h>
#include <vfife/study/waves/waves_study.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vfife
{
  namespace
  {
    class WavesStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        gear_case_.declare(prm, file);
        gear_case_.set_defaults(dynamics_, output_);
        dynamics_.declare(prm);
        output_.declare(prm);
        fillets_.declare(prm, file);
        declare_section(prm, "Reduced", reduced_);
        declare_section(prm, "Waves", options_);
      }

      void check() const override
      {
        gear_case_.check();
        gear_case_.operation().require_driving_pinion("Operation", "study of waves");
        gear_case_.operation().require_constant("Operation", "study of waves");
        dynamics_.check("Dynamics");
        output_.check("Output");
        options_.check("Waves");
        const RecordedTeeth teeth = fillets_.teeth;
        if (!fillets_.gauges.empty() ||
            (teeth != RecordedTeeth::none && teeth != RecordedTeeth::all))
          throw InputError("Fillets/teeth",
                           "stresses of waves are those of all teeth: none or all, and no gauges");
        if (!(dynamics_.mass_damping() > 0))
          throw InputError("Dynamics/damping",
                           "waves without damping grow for ever where a mesh order meets them");
        if (dynamics_.damping_rate != DampingRate::momentum)
          throw InputError("Dynamics/damping rate",
                           "modes are damped relative to the momentum's rate of the body");
      }

      void inspect(Communicator &, Log &log) override
      {
        const Model model = gear_case_.make_model(log);
        check_diameters(model);
        log.line("waves of the ",
                 model.bodies[model.transmission->driven].name(),
                 " with modes below ",
                 least_cutoff(),
                 " Hz");
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      /** Mesh frequency at a speed of the driver [rad/s]. */
      double mesh_frequency(const double speed) const
      {
        return gear_case_.mesh_frequency() * speed / gear_case_.operation().speed;
      }
      /** That which is asked for [Hz]. */
      double least_cutoff() const
      {
        return reduced_.find_cutoff(mesh_frequency(options_.highest_speed));
      }
      /** At the highest speed: what lies below is between it and rest. */
      std::vector<ReducedBody> reduce(const Model        &model,
                                      const RootStress   *roots,
                                      const Communicator &communicator,
                                      Log                &log) const
      {
        const double       faster     = options_.highest_speed / gear_case_.operation().speed;
        const MoreReadings of_fillets = [&](const unsigned int b) {
          return b == model.transmission->driven ? list_fillet_readings(model, *roots, b)
                                                 : std::vector<SectorReading>();
        };
        return reduce_pair(model,
                           reduced_,
                           dynamics_.stiffness,
                           least_cutoff(),
                           faster,
                           communicator,
                           log,
                           roots != nullptr ? of_fillets : nullptr);
      }
      void check_diameters(const Model &model) const;
      std::vector<WaveLine>
           find_lines(const Model &model, const ReducedBody &body, double sense, Log &log) const;
      void write_frequencies(const Model        &model,
                             const ReducedBody  &body,
                             double              sense,
                             const OutputFolder &folder) const;
      struct Tools;
      void               drive(const Tools           &tools,
                               WaveDriver            &driver,
                               const OutputFolder    &folder,
                               Log                   &log,
                               std::vector<WaveLine> &lines) const;
      WaveSchedule       schedule(const Tools &tools, const WaveLine &line, double speed) const;
      ReducedPairOptions pair_options() const;

      GearCase        gear_case_;
      DynamicsOptions dynamics_;
      OutputOptions   output_;
      FilletOptions   fillets_;
      ReducedOptions  reduced_;
      WavesOptions    options_;
    };

    void WavesStudy::check_diameters(const Model &model) const
    {
      const unsigned int most = RimWriter::count_diameters(model);
      for (const unsigned int n : options_.diameter_numbers())
        if (n > most)
          throw InputError("Waves/diameters",
                           "waves of the rim are measured up to " + std::to_string(most) +
                             " nodal diameters");
    }

    ReducedPairOptions WavesStudy::pair_options() const
    {
      ReducedPairOptions options;
      options.step    = 1. / (mesh_frequency(options_.highest_speed) * reduced_.steps_per_mesh);
      options.damping = dynamics_.mass_damping();
      options.mesh_damping = dynamics_.mesh_damping;
      return options;
    }

    std::vector<WaveLine> WavesStudy::find_lines(const Model       &model,
                                                 const ReducedBody &body,
                                                 const double       sense,
                                                 Log               &log) const
    {
      const Transmission   &t       = *model.transmission;
      const double          ratio   = std::abs(t.ratio());
      const double          turning = model.bodies[t.driven].rate < 0 ? -1. : 1.;
      std::vector<WaveLine> lines;
      for (const unsigned int n : options_.diameter_numbers())
        try
          {
            for (WaveMeeting &meeting : find_wave_meetings(body,
                                                           n,
                                                           options_.wave_orders,
                                                           options_.mesh_orders,
                                                           ratio * options_.lowest_speed,
                                                           ratio * options_.highest_speed,
                                                           turning,
                                                           sense))
              {
                WaveLine line;
                line.meeting      = std::move(meeting);
                line.speed        = std::abs(line.meeting.rate) / ratio;
                line.driver_teeth = t.driver_teeth;
                line.zeta         = dynamics_.mass_damping();
                lines.push_back(std::move(line));
              }
          }
        catch (const InputError &error)
          {
            throw InputError("Waves/diameters", error.what());
          }
      std::sort(lines.begin(), lines.end(), [](const WaveLine &a, const WaveLine &b) {
        return a.speed < b.speed;
      });
      if (lines.empty())
        log.line("no mesh order meets a wave between these speeds");
      return lines;
    }

    void WavesStudy::write_frequencies(const Model        &model,
                                       const ReducedBody  &body,
                                       const double        sense,
                                       const OutputFolder &folder) const
    {
      const Transmission &t     = *model.transmission;
      Table               table = make_wave_frequency_table();
      for (unsigned int k = 0; k < options_.n_speeds; ++k)
        {
          const double speed = options_.highest_speed * k / (options_.n_speeds - 1);
          const double rate  = model.bodies[t.driven].rate / t.driver_rate * speed;
          for (std::size_t h = 0; h < body.harmonics.size(); ++h)
            {
              const std::vector<unsigned int> numbers = options_.diameter_numbers();
              if (std::count(numbers.begin(), numbers.end(), body.harmonics[h].number) == 0)
                continue;
              for (const BodyWave &wave : find_waves(body, h, rate, sense))
                if (wave.order <= options_.wave_orders)
                  add_wave_frequency(wave, speed, rate, table);
            }
        }
      write_csv(folder, "waves_frequencies.csv", table);
    }

    /** What lines have in common: waves of the driven body, their drive and its linear theory. */
    struct WavesStudy::Tools
    {
      WaveDriver     driver;
      StaticPassage  passage;
      LinearResponse linear;
      LineTheory     theory;
      double         cutoff; ///< of the modes that the bodies have [Hz]

      Tools(const WavesOptions             &waves,
            const Model                    &model,
            const std::vector<ReducedBody> &bodies,
            const std::vector<double>      &penalties,
            const ReducedPairOptions       &options,
            const unsigned int              n_steps,
            const RootStress               *roots,
            ReducedPair                    &pair)
        : driver(model, pair, roots)
        , passage(model, bodies, penalties, options, n_steps)
        , linear(bodies[model.transmission->driven],
                 passage,
                 {options.damping, options.mesh_damping},
                 pair.sector_sense(model.transmission->driven),
                 model.transmission->driven_sense)
        , theory(waves,
                 *model.transmission,
                 model.bodies[model.transmission->driven].rate < 0 ? -1. : 1.,
                 linear,
                 driver)
        , cutoff(find_kept_cutoff(bodies))
      {
      }
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

    void WavesStudy::drive(const Tools           &tools,
                           WaveDriver            &driver,
                           const OutputFolder    &folder,
                           Log                   &log,
                           std::vector<WaveLine> &lines) const
    {
      Table motions = make_wave_motion_table(), growth = make_build_up_table(),
            stresses = make_wave_stress_table();
      for (WaveLine &line : lines)
        {
          std::vector<WaveMotion>           found;
          std::vector<std::complex<double>> expected;
          for (const double part : options_.offset_parts())
            {
              const double speed = line.linear_curve.peak * (1. + part);
              found.push_back(driver.drive(line.meeting, schedule(tools, line, speed)));
              expected.push_back(tools.theory.amplitude(line, speed));
            }
          line.response           = evaluate_wave(line,
                                        std::move(found),
                                        std::move(expected),
                                        driver.rim_gains(line.meeting.wave.diameters));
          line.response->n_probes = driver.n_probes();
          log_wave_response(line, log);
          add_wave_motions(line, motions);
          add_build_up(line, growth);
          add_wave_stresses(line, driver.places(), stresses);
          write_csv(folder, "waves_response.csv", motions);
          write_csv(folder, "waves_build_up.csv", growth);
          write_csv(folder, "waves_stress.csv", stresses);
        }
      write_csv(folder,
                "speeds_to_avoid.csv",
                make_avoided_speed_table(lines, options_.allowed_amplification, options_.margin));
    }

    void WavesStudy::run(OutputFolder &folder, Log &log)
    {
      log.set_verbosity(output_.verbosity);
      const Model model = gear_case_.make_model(log);
      check_diameters(model);
      const std::vector<double> penalties = find_run_penalties(
        gear_case_, dynamics_, output_.history_every, folder.communicator(), log);
      const auto                start = WallClock::now();
      std::optional<RootStress> roots;
      if (fillets_.records())
        roots.emplace(model, fillets_);
      const RootStress *const        looked_at = roots ? &*roots : nullptr;
      const std::vector<ReducedBody> bodies = reduce(model, looked_at, folder.communicator(), log);
      ReducedPair                    pair(model, bodies, penalties, pair_options());
      const unsigned int             driven  = model.transmission->driven;
      RunSummary                     summary = start_summary("waves", model, folder);

      std::vector<WaveLine> lines =
        find_lines(model, bodies[driven], pair.sector_sense(driven), log);
      write_frequencies(model, bodies[driven], pair.sector_sense(driven), folder);
      try
        {
          Tools tools(options_,
                      model,
                      bodies,
                      penalties,
                      pair_options(),
                      reduced_.steps_per_mesh,
                      looked_at,
                      pair);
          log.line("static curves of a slow tooth mesh: the moment of the contact varies by ",
                   100. * tools.passage.moment_ripple(),
                   " %; of the rotation under the torque the contact with teeth and driver has ",
                   100. * tools.linear.contact_compliance() * tools.passage.stiffness(),
                   " %");
          write_csv(folder,
                    "waves_in_contact.csv",
                    tools.theory.list_meetings(RimWriter::count_diameters(model)));
          for (WaveLine &line : lines)
            {
              tools.theory.predict(line);
              log_wave_line(line, log);
            }
          if (options_.driven)
            drive(tools, tools.driver, folder, log, lines);
        }
      catch (const NumericalError &error)
        {
          summary.status  = "failed";
          summary.failure = error.what();
        }
      Table table = make_wave_line_table();
      for (const WaveLine &line : lines)
        add_wave_line(line, table);
      write_csv(folder, "waves_lines.csv", table);
      write_own_figures(folder, list_line_figures(lines, gear_case_.operation().speed));
      summary.run_time = seconds_since(start);
      summary.figures  = {{"cut-off frequency", {find_kept_cutoff(bodies), "Hz"}},
                          {"damping", {dynamics_.mass_damping(), "1/s"}},
                          {"lines", {double(lines.size()), "-"}}};
      write_summary(folder, summary);
      if (summary.status == "failed")
        throw NumericalError(summary.failure);
      log.line(lines.size(), " lines in ", duration_text(summary.run_time));
      if (output_.pictures)
        draw_pictures(folder, log);
    }
  } // namespace

  std::unique_ptr<StudyKind> make_waves_study()
  {
    return std::make_unique<WavesStudy>();
  }
} // namespace vfife
