// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/element/stress.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/lumped/speed_sweep.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/output/files/checkpoint.h>
#include <vfife/output/files/figures.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/measures/pair_mounting.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/observers/part_stress_watch.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/reduced/reduced_options.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/reduced/resonance/nearest_wave.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/cases/damping_figures.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/cases/run_length.h>
#include <vfife/study/continuation.h>
#include <vfife/study/fillets/root_submodels.h>
#include <vfife/study/nearest_wave_summary.h>
#include <vfife/study/pressure/instant_options.h>
#include <vfife/study/pressure/pressure_writer.h>
#include <vfife/study/reduced/fillet_readings.h>
#include <vfife/study/reduced/near_cutoff.h>
#include <vfife/study/reduced/pair_reduction.h>
#include <vfife/study/reduced/pair_speed_sweep.h>
#include <vfife/study/reduced/reduced_run.h>
#include <vfife/study/run/pair_recording.h>
#include <vfife/study/run/pair_start.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/stress_waves/stress_wave_places.h>
#include <vfife/study/study_kinds.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace vfife
{
  namespace
  {
    /**
     * The largest stress of web, rim and hub of the pair at rest in its first position, under
     * torque and spin, of all nodes: a reduced body knows stresses of its probes and fillets alone.
     * Says in the log what it finds, or why nothing. @p compliance: of the model's bodies of
     * elements @p fem; nullptr: is factorized here. Collective.
     */
    NamedFigures find_start_stresses(const Model        &model,
                                     const FemOptions   &fem,
                                     Compliance         *compliance,
                                     const Communicator &communicator,
                                     Log                &log)
    {
      const auto   start = WallClock::now();
      PartStresses parts(model);
      try
        {
          std::optional<Compliance> own;
          if (compliance == nullptr)
            compliance = &own.emplace(model, fem, model.any_body_turns(), communicator);
          PairEquilibrium           equilibrium(model, *compliance, {0.});
          const std::vector<double> u        = equilibrium.solve(0., 1.).displacements;
          const std::vector<Stress> stresses = compute_node_stresses(compliance->space(), u);
          parts.look([&](const unsigned int node) { return von_mises(stresses[node]); });
        }
      catch (const NumericalError &error)
        {
          log.line("largest stresses at the start: not available, ", error.what());
          return {};
        }
      log.line(
        "largest stresses at rest in the first position, found in ",
        duration_text(seconds_since(start)),
        "; for all positions use kind loaded tooth contact analysis, with vibration kind run");
      parts.write_to(log);
      NamedFigures figures;
      for (const auto &[name, figure] : parts.list_figures())
        figures.push_back({"at the start, " + name, figure});
      return figures;
    }

    /** The flanks of the teeth in contact from where a reduced pair has them. What is given must
     * outlive it. */
    FlankReader read_flanks(const Model &model, const ReducedPair &pair)
    {
      return [&model, &pair](const State &state) {
        const ContactPair                &contact  = model.contacts.front();
        const std::array<unsigned int, 2> bodies   = {{contact.slave_body, contact.master_body}};
        const std::array<std::string, 2>  surfaces = {
           {contact.slave_surface, contact.master_surface}};
        FlankState flanks;
        for (unsigned int side = 0; side < 2; ++side)
          {
            const Body         &body   = model.bodies[bodies[side]];
            const FacetSurface &facets = body.mesh().surfaces.at(surfaces[side]);
            // Of teeth in contact alone: modes are many, and teeth too.
            std::set<unsigned int> teeth;
            for (const ToothContact &tooth : state.measured.teeth)
              teeth.insert(side == 0 ? tooth.slave_group : tooth.master_group);
            std::set<unsigned int> of_teeth;
            for (std::size_t f = 0; f < facets.facets.size(); ++f)
              if (teeth.count(facets.group[f]) > 0)
                of_teeth.insert(facets.facets[f].begin(), facets.facets[f].end());
            std::vector<unsigned int> nodes;
            for (const unsigned int node : of_teeth)
              nodes.push_back(facets.nodes[node]);
            const std::vector<double> places = pair.reader().read_places(bodies[side], nodes);
            flanks.positions[side].assign(3 * facets.nodes.size(), 0.);
            flanks.forces[side] = flanks.positions[side];
            std::size_t i       = 0;
            for (const unsigned int node : of_teeth)
              {
                std::copy_n(places.begin() + 3 * i++,
                            3,
                            flanks.positions[side].begin() + 3 * std::size_t(node));
                Eigen::Map<Vector3>(flanks.forces[side].data() + 3 * std::size_t(node)) =
                  state.contact_force.value(body.first_node + facets.nodes[node]);
              }
            flanks.motions[side] = pair.body_motion(bodies[side]);
          }
        return flanks;
      };
    }

    class ReducedStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        pair_case_ = make_pair_case(file);
        pair_case_->declare(prm, file);
        pair_case_->set_defaults(dynamics_, output_);
        dynamics_.declare(prm);
        output_.declare(prm);
        fillets_.declare(prm, file);
        instants_.declare(prm);
        Subsection section(prm, "Reduced");
        options_.declare(prm);
        sweep_.declare(prm);
        sweep_options_.declare(prm);
      }

      void check() const override
      {
        pair_case_->check();
        pair_case_->operation().require_driving_pinion("Operation", "reduced pair");
        if (!is_motion())
          pair_case_->operation().require_constant("Operation", "sweep over speeds");
        pair_case_->check_run(dynamics_);
        dynamics_.check("Dynamics");
        output_.check("Output");
        sweep_.check("Reduced");
        if (dynamics_.start == Start::ramp)
          throw InputError("Dynamics/start",
                           "expected \"steady torsional vibration\" or \"static equilibrium\" for "
                           "a reduced pair, got "
                           "\"ramp\"");
        fillets_.check();
        instants_.check();
        if (!is_motion() && instants_.asked_for())
          throw InputError(instants_.asking_entry(),
                           "a sweep over speeds (Reduced/sweep) has no pressures at instants");
        if (!is_motion())
          check_sweep();
        else
          check_lengths(*pair_case_, dynamics_, output_);
        if (dynamics_.damping_rate != DampingRate::momentum)
          throw InputError("Dynamics/damping reference",
                           "must be momentum, because modes are damped relative to this rate");
      }

      void inspect(Communicator &, Log &log) override
      {
        const Model model = pair_case_->make_model(log);
        require_reducible(model);
        RootStress(model, fillets_);
        options_.choose_elements(model, log);
        check_instants(model);
        log.line("penalty ",
                 pair_case_->leaves_penalty_open() ? "from " : "",
                 model.contacts.front().options.penalty.value,
                 pair_case_->leaves_penalty_open() ? " N/mm^3 on, by the contact's own grid"
                                                   : " N/mm^3",
                 "; modes below ",
                 least_cutoff(),
                 " Hz, ",
                 n_steps_of_mesh(least_cutoff()),
                 " steps per mesh cycle");
        report_checks(model, log);
      }

      std::size_t resume(const std::string     &folder,
                         const DeclaredSection &now,
                         const Communicator    &communicator,
                         Log                   &log) override
      {
        if (!is_motion())
          throw InputError("Reduced/sweep",
                           "a sweep over speeds has no checkpoints; start it at the speed where it "
                           "was stopped");
        checkpoint_ = find_checkpoint(
          folder, now, list_changeable(pair_case_->may_be_made_longer()), communicator, log);
        return checkpoint_->log_size;
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      void check_sweep() const
      {
        if (!fillets_.gauges.empty() ||
            (fillets_.teeth != RecordedTeeth::none && fillets_.teeth != RecordedTeeth::all))
          throw InputError(!fillets_.gauges.empty() ? "Fillets/gauges" : "Fillets/teeth",
                           "a speed sweep (Reduced/sweep) supports Fillets/teeth = none or all, "
                           "without gauges. Use single speeds (kind sweep) for gauges");
        if (sweep_options_.settling_decay_times > 0 && !(dynamics_.mass_damping() > 0))
          throw InputError("Reduced/settling decay times",
                           "requires Dynamics/mass proportional damping or Dynamics/damping ratio");
      }
      /** Whether one motion is computed, not one at each of many speeds. */
      bool is_motion() const
      {
        return sweep_.kind == SweepKind::none;
      }
      /** Elements of the bodies. */
      FemOptions fem() const
      {
        return options_.fem(dynamics_.stiffness);
      }
      /** The largest speed over that of the case at time zero. */
      double largest_factor() const
      {
        return is_motion() ? pair_case_->largest_speed_factor()
                           : sweep_.highest_speed / pair_case_->operation().speed;
      }
      /** That which is asked for [Hz]. */
      double least_cutoff() const
      {
        return options_.find_cutoff(pair_case_->mesh_frequency() * largest_factor(),
                                    ReducedOptions::rings_of_motions * pair_case_->ring_rate() /
                                      (2 * pi));
      }
      /** Of a mesh cycle at the largest speed. */
      unsigned int n_steps_of_mesh(const double cutoff) const
      {
        return options_.find_steps(pair_case_->mesh_frequency() * largest_factor(),
                                   cutoff,
                                   output_.history_every);
      }
      std::vector<std::string> report_checks(const Model &model, Log &log) const
      {
        return pair_case_->report_checks({&model, &dynamics_, &output_}, log);
      }
      /** A pair and how it moves. */
      struct Motion
      {
        double             cutoff         = 0; ///< that of the bodies [Hz]
        unsigned int       steps_per_mesh = 0; ///< at the largest speed
        ReducedPairOptions options;
      };
      void check_instants(const Model &model) const
      {
        if (instants_.asked_for())
          check_pressures(instants_,
                          fem(),
                          describe_run(*pair_case_, model, pair_case_->end_time()));
      }
      Motion make_motion(const std::vector<ReducedBody> &bodies) const;
      /** @p at_start: figures of find_start_stresses(). */
      bool         move(Model              &model,
                        ReducedPair        &pair,
                        const Motion       &motion,
                        const NamedFigures &at_start,
                        OutputFolder       &folder,
                        Log                &log) const;
      PairReadings read(const Model &model, ReducedPair &pair) const
      {
        PairReadings readings;
        readings.probes = [&](const std::vector<Probe> &copies) {
          return pair.reader().read_probes(copies);
        };
        readings.fillets = [&](const RootStress &, const RootSubmodels *const found) {
          return found != nullptr ? measure_submodel_readings(model, *found, pair)
                                  : measure_fillet_readings(pair);
        };
        readings.flanks = read_flanks(model, pair);
        readings.rim    = [&](const unsigned int n) { return pair.reader().read_rim(n); };
        readings.bores  = bore_motions(model, pair);
        return readings;
      }
      void sweep(const Model        &model,
                 ReducedPair        &pair,
                 const Motion       &motion,
                 const NamedFigures &at_start,
                 const RootStress   *roots,
                 OutputFolder       &folder,
                 Log                &log) const;

      std::unique_ptr<PairCase> pair_case_;
      DynamicsOptions           dynamics_;
      OutputOptions             output_;
      FilletOptions             fillets_;
      InstantOptions            instants_;
      ReducedOptions            options_;
      SpeedSweepOptions         sweep_;
      PairSpeedSweepOptions     sweep_options_;

      std::optional<Checkpoint>            checkpoint_;
      std::unique_ptr<const RootSubmodels> submodels_; ///< nullptr: elements of the pair
    };

    ReducedStudy::Motion ReducedStudy::make_motion(const std::vector<ReducedBody> &bodies) const
    {
      Motion motion;
      motion.cutoff         = find_kept_cutoff(bodies);
      motion.steps_per_mesh = n_steps_of_mesh(motion.cutoff);
      motion.options.step =
        1. / (pair_case_->mesh_frequency() * largest_factor() * motion.steps_per_mesh);
      motion.options.damping      = dynamics_.mass_damping();
      motion.options.mesh_damping = dynamics_.mesh_damping;
      return motion;
    }

    void ReducedStudy::sweep(const Model            &model,
                             ReducedPair            &pair,
                             const Motion           &motion,
                             const NamedFigures     &at_start,
                             const RootStress *const roots,
                             OutputFolder           &folder,
                             Log                    &log) const
    {
      const StressWavePlaces places(model, roots);
      PairSpeedSweep         sweep(model,
                           {options_,
                                    sweep_,
                                    sweep_options_,
                                    motion.cutoff,
                                    dynamics_.mass_damping(),
                                    output_.history_every,
                                    pair_case_->edges_under_load()},
                           places,
                           pair);
      RunSummary             summary = start_summary("reduced", model, folder);
      summary.contradictions         = report_checks(model, log);
      summary.cause                  = pair_case_->find_cause();
      summary.figures.insert(summary.figures.end(), at_start.begin(), at_start.end());
      run_speed_sweep(sweep, summary, folder, log);
    }

    bool ReducedStudy::move(Model              &model,
                            ReducedPair        &pair,
                            const Motion       &motion,
                            const NamedFigures &at_start,
                            OutputFolder       &folder,
                            Log                &log) const
    {
      const double dt = motion.options.step;
      RunTimes times  = plan_times(*pair_case_, dynamics_, output_, model.only_transmission(), dt);
      times.end       = std::llround(times.end / dt) * dt; // of its last step
      ReducedRun run({folder, log, model, output_, times}, pair, dt);
      if (dynamics_.start == Start::steady_swing && !PairMounting::changes(model))
        run.start_swinging(dynamics_.mesh_damping);
      RunSummary &summary  = run.summary();
      summary              = start_summary("reduced", model, folder);
      const auto   impulse = [&] { return pair.contact_impulse(); };
      const Table &history =
        run.observers().add<HistoryWriter>(model, times.sample_steps, impulse).table();
      PairRecording recording(*pair_case_, dynamics_, output_, read(model, pair), history, run);
      run.record_bearings();
      recording.record_stresses(fillets_, submodels_.get(), instants_, fem());
      summary.figures.push_back({"cut-off frequency", {motion.cutoff, "Hz"}});
      summary.figures.push_back({"steps per mesh cycle", {double(motion.steps_per_mesh), "-"}});
      summary.contradictions = report_checks(model, log);
      summary.cause          = pair_case_->find_cause();
      report_nearest_wave(
        [&] {
          return find_nearest_wave(model,
                                   {motion.options.damping, motion.options.mesh_damping},
                                   pair);
        },
        log,
        summary);
      summary.figures.insert(summary.figures.end(), at_start.begin(), at_start.end());

      const auto complete = [&] {
        recording.add_motion(run.preload());
        tell_near_cutoff(history, *model.only_transmission(), motion.cutoff, summary, log);
        recording.add_results(run.preload());
        if (summary.status != "failed")
          summary.figures.push_back(
            {"iterations a step", {double(pair.n_iterations()) / summary.steps, "-"}});
      };
      run.run(
        checkpoint_ ? &*checkpoint_ : nullptr, [&] { recording.prepare(); }, complete);
      log.line("finished: ", summary.steps, " steps in ", duration_text(summary.run_time));
      return summary.steady && summary.steady->has_steady_ripple();
    }

    void ReducedStudy::run(OutputFolder &folder, Log &log)
    {
      log.set_verbosity(output_.verbosity);
      const Communicator &communicator = folder.communicator();
      Model               model        = pair_case_->make_model(log);
      require_reducible(model);
      options_.choose_elements(model, log);
      check_instants(model); // before the reduction, which takes longer
      const auto   settled      = settle_penalties(*pair_case_, fem(), communicator, log, model);
      const double mean_penalty = model.contacts.front().mean_penalty();
      std::optional<RootStress> roots;
      if (is_motion())
        submodels_ = make_root_submodels(*pair_case_, fillets_, model, log);
      if (fillets_.records() && !submodels_)
        roots.emplace(model, fillets_);
      const MoreReadings of_fillets = [&](const unsigned int b) {
        return submodels_ ? list_submodel_readings(submodels_->of_body(b))
                          : list_fillet_readings(model, *roots, b);
      };
      std::vector<ReducedBody> bodies = reduce_pair(model,
                                                    {options_.store,
                                                     options_.reach,
                                                     fem(),
                                                     least_cutoff(),
                                                     largest_factor(),
                                                     fillets_.records() ? of_fillets : nullptr},
                                                    communicator,
                                                    log);
      if (options_.exports)
        export_bodies(bodies, model, folder);
      const Motion motion = make_motion(bodies);
      log.line("penalty ",
               mean_penalty,
               " N/mm^3, ",
               motion.steps_per_mesh,
               " steps of ",
               1e9 * motion.options.step,
               largest_factor() == 1. ? " ns per mesh cycle"
                                      : " ns per mesh cycle at the largest speed");
      ReducedPair  pair(model, std::move(bodies), motion.options);
      NamedFigures at_start =
        find_start_stresses(model, fem(), settled.compliance.get(), communicator, log);
      at_start.insert(at_start.end(), settled.figures.begin(), settled.figures.end());
      at_start.push_back(
        {figure_name::degree_of_elements, {double(degree_of(fem().element)), "-"}});
      if (is_motion())
        {
          const NamedFigures damping = list_damping(dynamics_, model.only_transmission(), log);
          at_start.insert(at_start.end(), damping.begin(), damping.end());
          run_lengths(
            *pair_case_,
            dynamics_,
            folder,
            checkpoint_,
            [&] { return move(model, pair, motion, at_start, folder, log); },
            log);
        }
      else
        sweep(model, pair, motion, at_start, roots ? &*roots : nullptr, folder, log);
      if (output_.pictures)
        draw_pictures(folder, log);
    }
  } // namespace

  std::unique_ptr<StudyKind> make_reduced_study()
  {
    return std::make_unique<ReducedStudy>();
  }
} // namespace vfife
