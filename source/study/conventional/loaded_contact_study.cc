// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/section_of_options.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/table.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/element/stress.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/load_torque.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/part_stress_watch.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/study/cases/gear_case.h>
#include <vfife/study/cases/run_plan.h>
#include <vfife/study/conventional/loaded_contact_study.h>
#include <vfife/study/conventional/loaded_contact_tables.h>
#include <vfife/study/conventional/loaded_fields.h>
#include <vfife/study/conventional/loaded_fillets.h>
#include <vfife/study/conventional/loaded_modes.h>
#include <vfife/study/conventional/loaded_pattern.h>
#include <vfife/study/conventional/loaded_pressure.h>
#include <vfife/study/conventional/loaded_probes.h>
#include <vfife/study/conventional/loaded_supports.h>
#include <vfife/study/pressure/pressure_depth.h>
#include <vfife/study/run/run_penalties.h>
#include <vfife/study/start_summary.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Of this kind, in messages and results. */
    constexpr char study_word[] = "loaded tooth contact analysis";

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
        gear_case_.declare(prm, file);
        dynamics_.declare(prm);
        output_.declare(prm);
        declare_section(prm, "Fem", fem_);
        declare_section(prm, "Loaded contact", options_);
        fillets_.declare(prm, file);
      }

      void check() const override
      {
        gear_case_.check_at_rest();
        gear_case_.operation().require_driving_pinion("Operation", study_word);
        gear_case_.operation().require_constant("Operation", study_word);
        dynamics_.check("Dynamics");
        fem_.check("Fem");
        fillets_.check();
      }

      void inspect(Communicator &communicator, Log &log) override
      {
        const Model model = gear_case_.make_model(log); // what is wrong with it, and what it is
        RootStress(model, fillets_);
        log.line("penalty of a run of this file ",
                 find_run_penalties(gear_case_, dynamics_, output_.history_every, communicator, log)
                   .front(),
                 " N/mm^3; ",
                 options_.positions,
                 " positions");
        gear_case_.report_checks({&model}, log);
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      /** Finds the equilibria and writes all tables. */
      void analyse(const Model               &model,
                   const std::vector<double> &penalties,
                   OutputFolder              &folder,
                   Log                       &log);

      /** Of the driver over one tooth mesh, its @p pitch [rad], from the reference position or a
       * later mesh on. */
      std::vector<double> list_turns(const double pitch) const
      {
        std::vector<double> turns;
        for (unsigned int i = 0; i < options_.positions; ++i)
          turns.push_back((options_.first_mesh + i / double(options_.positions)) * pitch);
        return turns;
      }

      /** Returns the transmission error [rad]. */
      double add_position(const Model                 &model,
                          const Compliance            &compliance,
                          double                       position,
                          const PairEquilibriumResult &result,
                          const std::vector<Stress>   &stresses,
                          Log                         &log);

      /** Whether edges carry, and Hertz's pressure of the tooth pair that carries most. */
      NamedFigures judge_teeth(const OutputFolder &folder, Log &log) const;

      /** None where it is not asked for. */
      std::unique_ptr<LoadedPressure> make_pressure(const Model &model,
                                                    Compliance  &compliance) const;

      GearCase             gear_case_;
      DynamicsOptions      dynamics_;
      OutputOptions        output_;
      FemOptions           fem_;
      LoadedContactOptions options_;
      FilletOptions        fillets_;
      Table                positions_, teeth_;
    };

    void log_largest(const Model &model, const LoadedProbes &probes, Log &log)
    {
      for (const Probe &probe : model.probes)
        {
          const std::size_t row        = probes.find_largest(probe.name);
          const double      after_mesh = probes.table().numbers(column::after_mesh)[row];
          log.line(probe.name,
                   ": largest von Mises stress of a turn ",
                   probes.table().numbers(column::von_mises)[row],
                   " MPa, ",
                   std::abs(after_mesh),
                   after_mesh < 0. ? " tooth meshes before the mesh"
                                   : " tooth meshes after the mesh");
        }
    }
  } // namespace

  void LoadedContactStudy::run(OutputFolder &folder, Log &log)
  {
    const Model               model = gear_case_.make_model(log);
    const std::vector<double> penalties =
      find_run_penalties(gear_case_, dynamics_, output_.history_every, folder.communicator(), log);
    RunSummary summary = start_summary(study_word, model, folder);
    for (unsigned int member = 0; member < model.bodies.size(); ++member)
      summary.figures.push_back({figure_name::torque_of(model.bodies[member].name()),
                                 {1e-3 * gear_case_.torque_on(member), "N m"}});
    summary.contradictions = gear_case_.report_checks({&model}, log);
    summary.cause          = gear_case_.find_cause();
    const auto begin       = WallClock::now();
    try
      {
        analyse(model, penalties, folder, log);
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

  void LoadedContactStudy::analyse(const Model               &model,
                                   const std::vector<double> &penalties,
                                   OutputFolder              &folder,
                                   Log                       &log)
  {
    auto       start = WallClock::now();
    Compliance compliance(model, fem_, options_.centrifugal, folder.communicator());
    log.line("penalty ",
             penalties.front(),
             " N/mm^3; ",
             compliance.n_unknowns(),
             " unknowns, factors of ",
             compliance.memory(),
             compliance.by_sectors() ? " MB by one sector of each body in " : " MB in ",
             seconds_since(start),
             " s");

    const double              pitch = 2 * pi / model.transmission->driver_teeth;
    const std::vector<double> turns = list_turns(pitch);
    // One factorization serves all positions: bodies stay as they are in turning axes.
    PairEquilibrium equilibrium(model, compliance, penalties, turns);
    LoadedProbes    probes(model);
    LoadedSupports  supports(model);
    LoadedPattern   pattern(model);
    LoadedFillets   fillets(model, fillets_);
    PartStresses    parts(model);
    LoadedFields    fields(folder, model, output_.fields_every);
    auto            pressure = make_pressure(model, compliance);
    for (const double turn : turns)
      {
        start                              = WallClock::now();
        const unsigned int          before = compliance.n_prepared();
        const PairEquilibriumResult result = equilibrium.solve(turn, 1.);
        const std::vector<Stress>   stresses =
          compute_node_stresses(compliance.discretization(), result.displacements);
        const double error = add_position(model, compliance, turn / pitch, result, stresses, log);
        probes.add_position(turn / pitch, stresses);
        supports.add_position(compliance.discretization(), turn / pitch, result);
        pattern.add_position(result);
        parts.look([&](const unsigned int node) { return von_mises(stresses[node]); });
        fields.add_position(
          turn / pitch, compliance.discretization(), equilibrium, result, stresses);
        fillets.add_position(compliance.discretization(), turn / pitch, result);
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
          pressure->add_position(turn / pitch, error, equilibrium, result, log);
        // Modes are those of the pair tied together where it touches in the reference position.
        if (turn == turns.front() && options_.coupled_modes > 0)
          write_loaded_modes(model,
                             compliance,
                             result,
                             {fem_, options_.centrifugal, options_.coupled_modes},
                             folder,
                             log);
      }
    log_largest(model, probes, log);
    parts.write_to(log);
    write_csv(folder, "loaded_probes.csv", probes.table());
    write_csv(folder, "loaded_teeth.csv", teeth_);
    supports.write(folder);
    write_csv(folder, "pattern.csv", pattern.table());
    NamedFigures figures = list_loaded_figures(positions_, supports.misalignments());
    const auto   add     = [&figures](const NamedFigures &more) {
      figures.insert(figures.end(), more.begin(), more.end());
    };
    add(judge_teeth(folder, log));
    add(pattern.figures(gear_case_.make_pair(), model.contacts[0].side));
    add(parts.list_figures());
    fillets.write(folder, log);
    if (pressure)
      {
        pressure->write(folder);
        add(pressure->list_figures());
      }
    add(fillets.list_figures());
    write_own_figures(folder, figures);
    write_tables(folder, "loaded_contact", positions_);
  }

  NamedFigures LoadedContactStudy::judge_teeth(const OutputFolder &folder, Log &log) const
  {
    NamedFigures figures =
      write_edge_contact(gear_case_.edges_under_load(), teeth_, column::position, 1., folder, log);
    const std::vector<double> &forces = teeth_.numbers(column::force);
    const double               force  = *std::max_element(forces.begin(), forces.end());
    figures.push_back({"hertz pressure of the largest force of a tooth pair",
                       {gear_case_.hertz_contact().largest_pressure(force), "MPa"}});
    return figures;
  }

  std::unique_ptr<LoadedPressure> LoadedContactStudy::make_pressure(const Model &model,
                                                                    Compliance  &compliance) const
  {
    if (options_.pressure_cells == 0)
      return nullptr;
    // Their balance has the bodies' linear answers alone.
    if (!model.bearings.empty())
      throw InputError("Loaded contact/pressure cells",
                       "pressures on their own grid are found of pairs on ideal bores; bearing \"" +
                         model.bearings.front().name + "\" holds one that is not");
    return std::make_unique<LoadedPressure>(model,
                                            *gear_case_.outlines(),
                                            compliance,
                                            choose_pressure_depth(options_.pressure_depth,
                                                                  model,
                                                                  gear_case_.hertz_contact()),
                                            options_.pressure_cells);
  }

  double LoadedContactStudy::add_position(const Model                 &model,
                                          const Compliance            &compliance,
                                          const double                 position,
                                          const PairEquilibriumResult &result,
                                          const std::vector<Stress>   &stresses,
                                          Log                         &log)
  {
    // Leads of the driven member in the drive direction: where flanks touch without load, and under
    // the torque. The secant leads from one to the other, the tangent is the slope under load.
    const Transmission &t    = *model.transmission;
    const auto          lead = [&](const double turn, const std::vector<double> &u) {
      return lead_of_driven(compliance.discretization(), turn, u);
    };
    // [rad]; transmission error = theta_driven - (z_driver/z_driven) theta_driver. A lead is
    // counted from the kinematic turn, so of both angles only those at time zero remain.
    const double offset   = t.driven_start - t.ratio() * t.driver_start;
    const double unloaded = offset + lead(result.touch_turn, result.touch_displacements);
    const double loaded   = offset + lead(result.turn, result.displacements);
    const double torque   = load_torque(model);
    // [N mm/rad]; the slope is the change per unit of the load factor, so the whole torque belongs
    // to it.
    const double secant  = torque / std::abs(loaded - unloaded);
    const double tangent = torque / std::abs(lead(result.turn_slope, result.displacement_slope));

    // A row a tooth pair, and one for their sum.
    double force = 0, pressure = 0;
    for (const ToothContact &tooth : result.teeth)
      {
        force += tooth.force.norm();
        pressure = std::max(pressure, tooth.largest_pressure);
        teeth_.add_row({position,
                        tooth.side,
                        tooth.slave_group,
                        tooth.master_group,
                        tooth.force.norm(),
                        1e-3 * tooth.torque,
                        tooth.torque / result.contact_torque,
                        tooth.largest_pressure,
                        tooth.area});
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
    return loaded;
  }

  std::unique_ptr<StudyKind> make_loaded_contact_study()
  {
    return std::make_unique<LoadedContactStudy>();
  }
} // namespace vfife
