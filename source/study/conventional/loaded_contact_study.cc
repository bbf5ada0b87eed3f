// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/table.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/element/stress.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/pair_measures.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/part_stress_watch.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/conventional/loaded_contact_options.h>
#include <vfife/study/conventional/loaded_contact_tables.h>
#include <vfife/study/conventional/loaded_fields.h>
#include <vfife/study/conventional/loaded_fillets.h>
#include <vfife/study/conventional/loaded_modes.h>
#include <vfife/study/conventional/loaded_pattern.h>
#include <vfife/study/conventional/loaded_pressure.h>
#include <vfife/study/conventional/loaded_probes.h>
#include <vfife/study/conventional/loaded_supports.h>
#include <vfife/study/pressure/calibrated_penalty.h>
#include <vfife/study/pressure/pressure_depth.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Of this kind, in messages and results. */
    constexpr char study_word[] = "loaded tooth contact analysis";
    /** Fewer positions do not follow a tooth pair, and their edges are not looked at. */
    constexpr unsigned int least_positions_with_edges = 4;

    /** Transmission errors of a position [rad]. */
    struct PairErrors
    {
      double unloaded = 0, loaded = 0;
      double slope = 0; ///< of the loaded one, per unit of the load factor
    };

    /** What is recorded at each position. */
    struct Recorders
    {
      const Model                    &model;
      LoadedFillets                   fillets;
      LoadedFields                    fields;
      std::unique_ptr<LoadedPressure> pressure; ///< nullptr: is not asked for

      LoadedProbes   probes{model};
      LoadedSupports supports{model};
      LoadedPattern  pattern{model};
      PartStresses   parts{model};

      /** All but pressures. */
      void add(const double                 position,
               const FemSpace              &space,
               const PairEquilibrium       &equilibrium,
               const PairEquilibriumResult &result,
               const std::vector<Stress>   &stresses)
      {
        const std::vector<ToothPressure> none;
        probes.add_position(position, stresses);
        supports.add_position(space, position, result);
        pattern.add_position(result);
        parts.look([&](const unsigned int node) { return von_mises(stresses[node]); });
        fields.add_position(position, space, equilibrium, result, stresses);
        fillets.add_position(
          space, position, equilibrium, result, pressure ? pressure->teeth() : none);
      }
    };

    class LoadedContactStudy : public StudyKind
    {
    public:
      LoadedContactStudy()
        : positions_(make_loaded_contact_table())
        , teeth_(make_loaded_teeth_table())
      {
        fem_.mass      = MassKind::lumped; // as the mass points of a run
        fillets_.teeth = RecordedTeeth::all;
      }

      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        pair_case_ = make_pair_case(file);
        pair_case_->declare(prm, file);
        dynamics_.declare(prm);
        output_.declare(prm);
        declare_section(prm, "Fem", fem_);
        declare_section(prm, "Loaded contact", options_);
        fillets_.declare(prm, file);
      }

      void check() const override
      {
        pair_case_->check_at_rest();
        pair_case_->operation().require_driving_pinion("Operation", study_word);
        pair_case_->operation().require_constant("Operation", study_word);
        dynamics_.check("Dynamics");
        fem_.check("Fem");
        if (fem_.distributed)
          throw InputError("Fem/distributed",
                           "expected no, got yes. Only the kinds linear static and modal have "
                           "distributed meshes. Set no.");
        fillets_.check();
      }

      void inspect(Communicator &, Log &log) override
      {
        const Model model = pair_case_->make_model(log); // what is wrong with it, and what it is
        RootStress(model, fillets_);
        if (pair_case_->leaves_penalty_open())
          log.line("penalty by the contact's own grid; ", options_.positions, " positions");
        else
          log.line("penalty of a run of this file ",
                   model.contacts.front().options.penalty.value,
                   " N/mm^3; ",
                   options_.positions,
                   " positions");
        pair_case_->report_checks({&model}, log);
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      /** Finds the equilibria and writes all tables. */
      void analyse(Model &model, OutputFolder &folder, Log &log);

      void
      write(const Model &model, Recorders &recorders, const OutputFolder &folder, Log &log) const;

      unsigned int n_pressure_cells() const
      {
        // Nodal forces of coarse flanks change root stresses by up to a fifth.
        const bool needed = pair_case_->leaves_penalty_open() || fillets_.follows_submodels();
        return options_.pressure_cells.is_word && !needed ? 0 : options_.pressure_cells.number;
      }
      /** What the contact's own grid changes of the transmission error [rad]; where it was not
       * asked for and is not found, nothing, with a warning. */
      double find_change(double                       position,
                         const PairErrors            &errors,
                         const PairEquilibrium       &equilibrium,
                         const PairEquilibriumResult &result,
                         LoadedPressure              &pressure,
                         Log                         &log) const;

      /** A turn of the driver over one mesh cycle. */
      struct Position
      {
        double meshes  = 0;     ///< from the reference position on [mesh cycles]
        bool   at_edge = false; ///< only forces of tooth pairs are looked at, at their edges
      };

      /** Equal steps from the reference position or a later mesh on, and where edges have their
       * largest forces; ascending. */
      std::vector<Position> list_positions() const
      {
        std::vector<Position> positions;
        for (unsigned int i = 0; i < options_.positions; ++i)
          positions.push_back({options_.first_mesh + i / double(options_.positions), false});
        const auto edges = pair_case_->edges_under_load();
        if (edges && options_.positions >= least_positions_with_edges)
          for (const double place : edges->positions())
            positions.push_back({options_.first_mesh + place, true});
        std::stable_sort(positions.begin(), positions.end(), [](const auto &one, const auto &two) {
          return one.meshes < two.meshes;
        });
        return positions;
      }

      void add_teeth(const Model &model, double position, const PairEquilibriumResult &result);
      void add_position(const Model                 &model,
                        const PairErrors            &errors,
                        double                       position,
                        const PairEquilibriumResult &result,
                        const std::vector<Stress>   &stresses,
                        Log                         &log);

      /** Whether edges carry, and Hertz's pressure of the tooth pair that carries most. */
      NamedFigures judge_teeth(const OutputFolder &folder, Log &log) const;

      /** None where it is not asked for. */
      std::unique_ptr<LoadedPressure> make_pressure(const Model &model,
                                                    Compliance  &compliance) const;

      std::unique_ptr<PairCase> pair_case_;
      DynamicsOptions           dynamics_;
      OutputOptions             output_;
      FemOptions                fem_;
      LoadedContactOptions      options_;
      FilletOptions             fillets_;
      Table                     positions_, teeth_;
    };

    PairErrors
    find_errors(const Model &model, const FemSpace &space, const PairEquilibriumResult &result)
    {
      // Leads of the driven member in the drive direction: where flanks touch without load, and
      // under the torque. The secant leads from one to the other, the tangent is the slope under
      // load. Transmission error = theta_driven - (z_driver/z_driven) theta_driver: a lead is
      // counted from the kinematic turn, so of both angles only those at time zero remain.
      const Transmission &t    = *model.only_transmission();
      const auto          lead = [&](const double turn, const std::vector<double> &u) {
        return lead_of_driven(space, turn, u);
      };
      const double offset = t.driven_start - t.ratio() * t.driver_start;
      return {offset + lead(result.touch_turn, result.touch_displacements),
              offset + lead(result.turn, result.displacements),
              lead(result.turn_slope, result.displacement_slope)};
    }

    void log_largest(const Model &model, const LoadedProbes &probes, Log &log)
    {
      for (const Probe &probe : model.probes)
        {
          const std::size_t row        = probes.find_largest(probe.name);
          const double      after_mesh = probes.table().numbers(column::after_mean_contact)[row];
          log.line(probe.name,
                   ": largest von Mises stress in one revolution ",
                   probes.table().numbers(column::von_mises)[row],
                   " MPa, ",
                   std::abs(after_mesh),
                   after_mesh < 0. ? " mesh cycles before contact" : " mesh cycles after contact");
        }
    }
  } // namespace

  void LoadedContactStudy::run(OutputFolder &folder, Log &log)
  {
    Model      model   = pair_case_->make_model(log);
    RunSummary summary = start_summary(study_word, model, folder);
    for (unsigned int member = 0; member < model.bodies.size(); ++member)
      summary.figures.push_back({figure_name::torque_of(model.bodies[member].name()),
                                 {1e-3 * pair_case_->torque_on(member), "N m"}});
    fem_.choose_elements(options_.coupled_modes == 0 && affords_quadratic_elements(model), log);
    summary.figures.push_back(
      {figure_name::degree_of_elements, {double(degree_of(fem_.element)), "-"}});
    summary.contradictions = pair_case_->report_checks({&model}, log);
    summary.cause          = pair_case_->find_cause();
    const auto begin       = WallClock::now();
    try
      {
        analyse(model, folder, log);
      }
    catch (const NumericalError &error)
      {
        summary.fail(error.what());
      }
    summary.run_time = seconds_since(begin);
    write_summary(folder, summary, log);
    if (summary.status == "failed")
      throw NumericalError(summary.failure);
    if (output_.pictures)
      draw_pictures(folder, log);
  }

  void LoadedContactStudy::analyse(Model &model, OutputFolder &folder, Log &log)
  {
    auto       start = WallClock::now();
    Compliance compliance(model, fem_, options_.centrifugal, folder.communicator());
    log.line(compliance.n_unknowns(),
             " unknowns, factors of ",
             compliance.memory(),
             compliance.by_sectors() ? " MB by one sector of each body in " : " MB in ",
             seconds_since(start),
             " s");
    if (needs_calibration(*pair_case_, model))
      calibrate_penalty(*pair_case_, compliance, log, model);
    log.line("penalty ", model.contacts.front().mean_penalty(), " N/mm^3");
    const double                pitch     = 2 * pi / model.only_transmission()->driver_teeth;
    const std::vector<Position> positions = list_positions();
    std::vector<double>         turns;
    for (const Position &position : positions)
      turns.push_back(position.meshes * pitch);
    // One factorization serves all positions: bodies stay as they are in turning axes.
    PairEquilibrium       equilibrium(model, compliance, turns);
    Recorders             recorders{model,
                        {model,
                                     fillets_,
                                     make_root_submodels(*pair_case_, fillets_, model, log),
                                     options_.centrifugal},
                        {folder, model, output_},
                        make_pressure(model, compliance)};
    LoadedPressure *const pressure = recorders.pressure.get();
    for (std::size_t i = 0; i < turns.size(); ++i)
      {
        const double turn = turns[i];
        if (positions[i].at_edge)
          {
            add_teeth(model, positions[i].meshes, equilibrium.solve(turn, 1.));
            continue;
          }
        start                              = WallClock::now();
        const unsigned int          before = compliance.n_prepared();
        const PairEquilibriumResult result = equilibrium.solve(turn, 1.);
        const std::vector<Stress>   stresses =
          compute_node_stresses(compliance.space(), result.displacements);
        PairErrors errors = find_errors(model, compliance.space(), result);
        if (pressure)
          {
            // Where the penalty is open, the grid shares the load.
            const double change =
              find_change(turn / pitch, errors, equilibrium, result, *pressure, log);
            errors.loaded += pair_case_->leaves_penalty_open() ? change : 0.;
          }
        add_position(model, errors, turn / pitch, result, stresses, log);
        recorders.add(turn / pitch, compliance.space(), equilibrium, result, stresses);
        log.line("  ",
                 result.iterations,
                 " iterations, residual ",
                 result.residual,
                 ", ",
                 compliance.n_prepared() - before,
                 " unit forces, ",
                 seconds_since(start),
                 " s");
        if (pressure)
          log.line("  ", pressure->describe());
        // Modes are those of the pair tied together where it touches in the reference position.
        if (turn == turns.front() && options_.coupled_modes > 0)
          write_loaded_modes(model,
                             compliance,
                             result,
                             {fem_, options_.centrifugal, options_.coupled_modes},
                             folder,
                             log);
      }
    write(model, recorders, folder, log);
  }

  double LoadedContactStudy::find_change(const double                 position,
                                         const PairErrors            &errors,
                                         const PairEquilibrium       &equilibrium,
                                         const PairEquilibriumResult &result,
                                         LoadedPressure              &pressure,
                                         Log                         &log) const
  {
    try
      {
        return pressure.add_position(position, errors.loaded, equilibrium, result);
      }
    catch (const NumericalError &error)
      {
        if (!options_.pressure_cells.is_word)
          throw;
        log.warning(
          "position " + number_text(position) + ": " + error.what() +
          ". This position has the transmission error of the penalties and no pressures.");
        return 0.;
      }
  }

  void LoadedContactStudy::write(const Model        &model,
                                 Recorders          &recorders,
                                 const OutputFolder &folder,
                                 Log                &log) const
  {
    log_largest(model, recorders.probes, log);
    recorders.parts.write_to(log);
    write_csv(folder, "loaded_probes.csv", recorders.probes.table());
    write_csv(folder, "loaded_teeth.csv", teeth_);
    recorders.supports.write(folder);
    write_csv(folder, "pattern.csv", recorders.pattern.table());
    NamedFigures figures = list_loaded_figures(positions_, recorders.supports.misalignments());
    const auto   add     = [&figures](const NamedFigures &more) {
      figures.insert(figures.end(), more.begin(), more.end());
    };
    add(judge_teeth(folder, log));
    add(pair_case_->rate(log));
    add(recorders.pattern.figures(pair_case_->outlines(), model.contacts[0].side));
    add(recorders.parts.list_figures());
    recorders.fillets.write(folder, log);
    if (recorders.pressure)
      {
        recorders.pressure->write(folder);
        add(recorders.pressure->list_figures());
      }
    add(recorders.fillets.list_figures());
    write_own_figures(folder, figures);
    write_tables(folder, "loaded_contact", positions_);
  }

  NamedFigures LoadedContactStudy::judge_teeth(const OutputFolder &folder, Log &log) const
  {
    NamedFigures figures =
      write_edge_contact(pair_case_->edges_under_load(), teeth_, column::position, 1., folder, log);
    const std::vector<double> &forces = teeth_.numbers(column::force);
    const double               force  = *std::max_element(forces.begin(), forces.end());
    figures.push_back({"hertz pressure of the largest force of a tooth pair",
                       {pair_case_->hertz_contact().largest_pressure(force), "MPa"}});
    return figures;
  }

  std::unique_ptr<LoadedPressure> LoadedContactStudy::make_pressure(const Model &model,
                                                                    Compliance  &compliance) const
  {
    if (n_pressure_cells() == 0)
      return nullptr;
    return std::make_unique<LoadedPressure>(model,
                                            pair_case_->outlines(),
                                            compliance,
                                            choose_pressure_depth(options_.pressure_depth,
                                                                  model,
                                                                  pair_case_->hertz_contact()),
                                            n_pressure_cells());
  }

  void LoadedContactStudy::add_teeth(const Model                 &model,
                                     const double                 position,
                                     const PairEquilibriumResult &result)
  {
    for (const ToothContact &tooth : result.teeth)
      teeth_.add_row({position,
                      model.contacts[tooth.contact].side,
                      tooth.slave_group,
                      tooth.master_group,
                      tooth.force.norm(),
                      1e-3 * tooth.torque,
                      tooth.torque / result.contact_torque,
                      tooth.largest_pressure,
                      tooth.area});
  }

  void LoadedContactStudy::add_position(const Model                 &model,
                                        const PairErrors            &errors,
                                        const double                 position,
                                        const PairEquilibriumResult &result,
                                        const std::vector<Stress>   &stresses,
                                        Log                         &log)
  {
    // [N mm/rad]; the slope is the change per unit of the load factor, so the whole torque belongs
    // to it.
    const Transmission &t        = *model.only_transmission();
    const double        torque   = load_torque(model);
    const double        unloaded = errors.unloaded, loaded = errors.loaded;
    const double        secant  = torque / std::abs(loaded - unloaded);
    const double        tangent = torque / std::abs(errors.slope);

    add_teeth(model, position, result);
    double force = 0, pressure = 0;
    for (const ToothContact &tooth : result.teeth)
      {
        force += tooth.force.norm();
        pressure = std::max(pressure, tooth.largest_pressure);
      }
    // Where teeth break: the largest stress of either fillet, and of the web's faces.
    const std::vector<const char *> fillets = {node_set::concave_fillet, node_set::convex_fillet};
    const Body &driver = model.bodies[t.driver], &driven = model.bodies[t.driven];
    positions_.add_row(
      {position,
       (t.driver_start + result.driver_turn) * 180. / pi,
       unloaded / arcsecond,
       loaded / arcsecond,
       1e-3 * result.contact_torque,
       force,
       result.teeth.size(),
       pressure,
       1e-3 * secant,
       1e-3 * tangent,
       find_largest_stress(driver, stresses, fillets),
       find_largest_stress(driven, stresses, fillets),
       find_largest_stress(driven, stresses, {node_set::web_front, node_set::web_back}),
       result.iterations,
       result.residual});
    log.line("position ",
             position,
             ": transmission error ",
             loaded / arcsecond,
             " arcsec (unloaded ",
             unloaded / arcsecond,
             "), ",
             result.teeth.size(),
             " teeth, contact torque ",
             1e-3 * result.contact_torque,
             " N m, force ",
             force,
             " N, stiffness ",
             1e-3 * secant,
             " (tangent ",
             1e-3 * tangent,
             ") N m/rad");
  }

  std::unique_ptr<StudyKind> make_loaded_contact_study()
  {
    return std::make_unique<LoadedContactStudy>();
  }
} // namespace vfife
