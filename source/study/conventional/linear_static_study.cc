// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/fem/distributed/distributed_checks.h>
#include <vfife/fem/distributed/distributed_statics.h>
#include <vfife/fem/statics/adaptive_refinement.h>
#include <vfife/fem/statics/nodal_solution.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/constraints/supports.h>
#include <vfife/output/files/mode_writer.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/observers/probe_writer.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/study/cases/case.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/conventional/chosen_bodies.h>
#include <vfife/study/conventional/field_grid.h>
#include <vfife/study/conventional/linear_static_study.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/study_kinds.h>
#include <vfife/study/turning_axes.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace vfife
{
  namespace
  {
    /** The solution on one mesh. */
    struct Solution : NodalSolution
    {
      std::unique_ptr<StaticSolver> solver; ///< none on a distributed mesh
      StaticResult                  result;
    };

    /** Stresses of the model's nodes, as displacements, in the fixed frame at time zero. Bodies
     * that are not part of the solution show zeros. */
    ProbeValue
    find_probe_value(const Probe &probe, const Model &model, const NodalSolution &solution)
    {
      const Body   &body   = model.bodies[probe.body];
      const Matrix3 frame  = body.placement.rotation;
      const auto    node   = std::size_t(body.first_node + probe.node);
      const Vector3 moved  = Eigen::Map<const Vector3>(solution.displacements.data() + 3 * node);
      const Stress &stress = solution.stresses[node];
      if (probe.fixed_axes)
        return make_probe_value(moved, stress, {frame});
      const Matrix3 axes = compute_cylindrical_axes(body, body.node_positions()[probe.node]);
      return make_probe_value(axes.transpose() * (frame.transpose() * moved),
                              stress,
                              {frame, axes});
    }

    /** Words for LinearStaticOptions::at_time. */
    const Choices<bool> load_choices = {{"full", false}, {"at time", true}};

    /** One file a body: displacements, stresses in its cylindrical axes and along the fixed ones,
     * von Mises. */
    void write_fields(const OutputFolder              &folder,
                      const Model                     &model,
                      const std::vector<unsigned int> &bodies,
                      const Solution                  &solution)
    {
      folder.make_subfolder("fields");
      if (!folder.is_writer())
        return;
      for (const unsigned int b : bodies)
        {
          const Body     &body  = model.bodies[b];
          const FemSpace *space = solution.solver ? &solution.solver->space() : nullptr;
          const FieldGrid shown = space ? FieldGrid(*space, *space->find_part(b)) : FieldGrid(body);
          std::vector<double> u =
            shown.take(space ? solution.result.displacements.data()
                             : solution.displacements.data() + 3 * std::size_t(body.first_node),
                       3);
          const std::vector<double> stresses =
            shown.take(space ? solution.point_stresses.front().data()
                             : solution.stresses[body.first_node].data(),
                       6);
          std::vector<VtuArray> fields = make_stress_arrays();
          for (unsigned int i = 0; i < shown.n_points(); ++i)
            {
              // Along the fixed axes; r, theta, z are those of the point's own place.
              const Stress stress = Eigen::Map<const Stress>(stresses.data() + 6 * std::size_t(i));
              add_stress(turn_stress(stress,
                                     body.placement.rotation *
                                       compute_cylindrical_axes(body, shown.reference(i))),
                         stress,
                         fields.begin());
            }
          write_shapes(folder,
                       "fields/" + body.name() + ".vtu",
                       shown.make_grid(),
                       {{"displacement", std::move(u), "mm"}},
                       std::move(fields));
        }
    }

    /** Key numbers. */
    NamedFigures list_figures(const NodalSolution &solution)
    {
      double stress = 0;
      for (const Stress &here : solution.stresses)
        stress = std::max(stress, von_mises(here));
      return {{"strain energy", {solution.strain_energy, "mJ"}},
              {"largest displacement", {1e3 * solution.largest_displacement, "um"}},
              {"largest von mises", {stress, "MPa"}}};
    }

    /** Names of the results that can end the adaptive refinement, with their values of a solution
     * (nullptr: none yet): key numbers, and quantities of probes as columns of history.csv. */
    NamedFigures list_results(const Model &model, const NodalSolution *const solution)
    {
      NamedFigures results = list_figures(solution != nullptr ? *solution : NodalSolution());
      for (const Probe &probe : model.probes)
        {
          const ProbeValue value =
            solution == nullptr ? ProbeValue() : find_probe_value(probe, model, *solution);
          for (const ProbeQuantity &quantity : list_probe_quantities(
                 probe.fixed_axes ? column::fixed_axes : column::cylindrical_axes))
            results.push_back(
              {probe.name + " " + quantity.name, {quantity.value(value), quantity.unit}});
        }
      return results;
    }

    Figure find_result(const std::string &name, const NamedFigures &results)
    {
      std::vector<std::string> known;
      for (const auto &result : results)
        {
          if (result.first == name)
            return result.second;
          known.push_back(result.first);
        }
      throw InputError("Linear static/Adaptive refinement/result",
                       "expected strain energy, largest displacement, largest von mises or a probe "
                       "and its quantity (such as \"NAME von mises\"), got \"" +
                         name + "\"" + did_you_mean(name, known));
    }

    /** Refinements where the error is, until the named result settles. */
    class AdaptiveSteps
    {
    public:
      /** Throws InputError where no result has the name. */
      AdaptiveSteps(const LinearStaticOptions &options, const Model &model)
        : options_(options)
        , model_(model)
        , table_(make_adaptive_table())
      {
        find_result(options.adapted_result, list_results(model, nullptr));
      }

      /** Takes the solution in. Whether another mesh is wanted: then @p fem has its elements. */
      bool go_on(const Solution &solution, FemOptions &fem, Log &log)
      {
        const std::string        &name   = options_.adapted_result;
        const Figure              figure = find_result(name, list_results(model_, &solution));
        const double              value  = figure.value;
        const FemSpace           &space  = solution.solver->space();
        const std::vector<double> errors = estimate_errors(space, solution.result.displacements);
        const double              step   = table_.n_rows();
        const double              last   = step == 0 ? value : table_.numbers("value").back();
        change_ =
          value == last ? 0. : std::abs(value - last) / std::max(std::abs(value), std::abs(last));
        const double square = std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.);
        table_.add_row({step,
                        space.n_elements(),
                        3 * space.n_points(),
                        std::sqrt(square),
                        name + " [" + figure.unit + "]",
                        value,
                        step == 0 ? std::numeric_limits<double>::quiet_NaN() : 100 * change_});
        log.line("refinement ", step, ": ", space.n_elements(), " elements, ", name, " ", value);
        if (square == 0. || (step > 0 && change_ < options_.adapted_tolerance))
          return false;
        if (step == options_.most_steps)
          {
            log.warning(name + " has not converged: the last of " + number_text(step) +
                        " refinements changed it by " + number_text(100 * change_) +
                        " %. Increase Linear static/Adaptive refinement/maximum steps, or choose a "
                        "result that converges: stresses in sharp corners do not");
            return false;
          }
        fem.divisions.push_back(mark_elements(space, errors, options_.marked_part));
        return true;
      }

      /** A row a mesh. */
      const Table &table() const
      {
        return table_;
      }
      NamedFigures list_figures() const
      {
        return {{"change by the last refinement", {100 * change_, "%"}}};
      }

    private:
      const LinearStaticOptions &options_;
      const Model               &model_;
      Table                      table_;
      double                     change_ = 0; ///< of the last refinement [-]
    };

    /** A row a support of the bodies looked at: what it exerts on its nodes. */
    Table list_reactions(const Model                     &model,
                         const std::vector<unsigned int> &bodies,
                         const std::vector<Reaction>     &reactions)
    {
      Table                      table    = make_reaction_table();
      const std::vector<Support> supports = list_supports(model);
      for (std::size_t s = 0; s < supports.size(); ++s)
        if (std::find(bodies.begin(), bodies.end(), supports[s].body) != bodies.end())
          {
            // The moment about the origin, moved to a point of the axis.
            const Body    &body  = model.bodies[supports[s].body];
            const Vector3 &force = reactions[s].force;
            const double   torque =
              body.axis.direction.dot(reactions[s].moment - body.axis.point.cross(force));
            table.add_row(
              {supports[s].name, body.name(), force[0], force[1], force[2], 1e-3 * torque});
          }
      return table;
    }

    class LinearStaticStudy : public StudyKind
    {
    public:
      LinearStaticStudy()
      {
        fem_.mass          = MassKind::lumped; // as the mass points of a run
        fem_.linear_solver = LinearSolverKind::direct;
      }

      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        case_ = make_case(file);
        case_->set_defaults(dynamics_, output_);
        output_.fields_every = 1;
        case_->declare(prm, file);
        dynamics_.declare(prm);
        output_.declare(prm);
        options_.declare(prm);
        case_->declare_run(prm);
        declare_section(prm, "Fem", fem_);
      }

      void check() const override
      {
        case_->check();
        dynamics_.check("Dynamics");
        output_.check("Output");
        if (output_.field_format != FieldFormat::vtu)
          throw InputError("Output/field format",
                           "expected vtu, got hdf5. Kind linear static writes one .vtu file per "
                           "body. Set vtu");
        options_.check();
        fem_.check("Fem");
        if (fem_.cyclic_symmetry)
          throw InputError("Fem/cyclic symmetry",
                           "must be no, because loads require the whole body");
        if (fem_.speeds != FemOptions().speeds)
          throw InputError("Fem/speeds", "must be 0, because each body has its own speed");
        check_distributed(fem_);
        if (fem_.distributed && !options_.adapted_result.empty())
          throw InputError("Linear static/Adaptive refinement/result",
                           "expected no result with Fem/distributed = yes, got \"" +
                             options_.adapted_result + "\". Set Fem/local refinement instead.");
      }

      void inspect(Communicator &, Log &log) override
      {
        const Model model = make_model(log);
        for (const unsigned int b : find_chosen_bodies(fem_, model))
          log.line(model.bodies[b].name(),
                   ": ",
                   model.bodies[b].n_elements(),
                   " elements, ",
                   model.bodies[b].rate * 30 / pi,
                   " rpm");
        if (!options_.adapted_result.empty())
          AdaptiveSteps(options_, model); // refuses another name
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      Model make_model(Log &log) const;
      void  refuse_what_is_not_linear(const Model &model) const;
      /** On one mesh, or on meshes that are refined where the error is: @p figures of these. */
      Solution solve(const Model        &model,
                     const StaticLoads  &loads,
                     HubRotation         rotation,
                     const OutputFolder &folder,
                     NamedFigures       &figures,
                     Log                &log) const;
      /** On a mesh that is distributed to the ranks; writes the fields of all points. */
      Solution solve_distributed(const Model        &model,
                                 const StaticLoads  &loads,
                                 const OutputFolder &folder,
                                 Log                &log) const;
      void     write_probes(const OutputFolder  &folder,
                            const Model         &model,
                            const NodalSolution &solution) const;

      std::unique_ptr<Case> case_;
      DynamicsOptions       dynamics_;
      OutputOptions         output_;
      FemOptions            fem_;
      LinearStaticOptions   options_;
    };
  } // namespace

  void LinearStaticOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Linear static");
    declare_choice(prm,
                   "loads",
                   at_time,
                   load_choices,
                   "full: loads and prescribed displacements at full size; at time: multiplied "
                   "by their histories");
    declare_quantity(
      prm, "time", time, "s", "Time at which histories are evaluated, with loads = at time");
    declare_switch(prm,
                   "centrifugal",
                   centrifugal,
                   "Includes centrifugal forces on rotating bodies");
    declare_switch(prm,
                   "spin softening",
                   spin_softening,
                   "Includes spin softening: centrifugal force on the displaced mass");
    declare_switch(prm,
                   "stress stiffness",
                   stress_stiffness,
                   "Includes stress stiffening by centrifugal stresses");
    pressed_flank.declare(prm);
    const Subsection adaptive(prm, "Adaptive refinement");
    declare_text(prm,
                 "result",
                 adapted_result,
                 "Result that ends the adaptive refinement: strain energy, largest "
                 "displacement, largest von mises, or quantity of a probe as a column of "
                 "history.csv (\"hole von mises\"); empty: no adaptive refinement");
    declare_number(prm,
                   "tolerance",
                   adapted_tolerance,
                   "Relative change of the result between two meshes at which the refinement ends",
                   Range::positive());
    declare_number(prm,
                   "marked part",
                   marked_part,
                   "Part of the sum of squared error indicators that the refined elements hold "
                   "in each step; the fewest such elements are divided into eight",
                   Range::between(.05, 1.));
    declare_integer(prm, "maximum steps", most_steps, "Maximum number of refinements", 1, 20);
  }

  void LinearStaticOptions::check() const
  {
    if (!at_time && time != 0)
      throw InputError("Linear static/time", "histories are read with loads = at time only");
    if (pressed_flank.acts() && !adapted_result.empty())
      throw InputError("Linear static/Adaptive refinement/result",
                       "expected no result with a pressed flank, got \"" + adapted_result +
                         "\". Set Fem/local refinement instead.");
  }

  StaticLoads LinearStaticOptions::loads() const
  {
    StaticLoads loads;
    if (at_time)
      loads.time = time;
    loads.centrifugal      = centrifugal;
    loads.spin_softening   = spin_softening;
    loads.stress_stiffness = stress_stiffness;
    return loads;
  }

  void LinearStaticStudy::refuse_what_is_not_linear(const Model &model) const
  {
    if (!model.transmissions.empty())
      return;
    // Contact of a gear pair is left out by itself, each member being looked at alone; that of a
    // general model is something that the user has asked for.
    for (const ContactPair &pair : model.contacts)
      throw InputError("Model/contacts",
                       "contact \"" + pair.side +
                         "\" is not linear: leave it out, or use kind = static");
    for (const RigidWall &wall : model.walls)
      throw InputError("Model/contacts",
                       "the rigid wall \"" + wall.name +
                         "\" is not linear: leave it out, or use kind = static");
    if (options_.centrifugal)
      refuse_standing_loads(
        model,
        find_chosen_bodies(fem_, model),
        "Set Linear static/centrifugal = no for the body at rest (for a balanced rotor the "
        "displacement at any speed, without spin stiffening), or use kind = run");
  }

  Model LinearStaticStudy::make_model(Log &log) const
  {
    Model model = case_->make_model(log);
    refuse_what_is_not_linear(model);
    check_distributed(fem_, model, find_chosen_bodies(fem_, model), options_.centrifugal);
    options_.pressed_flank.check(model);
    if (options_.pressed_flank.acts() && fem_.distributed)
      throw InputError("Fem/distributed", "expected no with a pressed flank, got yes. Set no.");
    return model;
  }

  void LinearStaticStudy::write_probes(const OutputFolder  &folder,
                                       const Model         &model,
                                       const NodalSolution &solution) const
  {
    // Observers write what they are shown: a state that holds what a row of the probes asks for.
    State state;
    state.time = options_.at_time ? options_.time : 1.; // as in `static`, the part of the loads
    state.measured.energy.strain = solution.strain_energy;
    state.measured.reactions     = solution.reactions;
    for (const Probe &probe : model.probes)
      state.measured.probes.push_back(find_probe_value(probe, model, solution));
    Observers observers;
    if (model.transmissions.empty())
      observers.push_back(std::make_unique<HistoryWriter>(folder, model, 1));
    else
      observers.push_back(std::make_unique<ProbeWriter>(folder, 1));
    for (const auto &observer : observers)
      {
        observer->observe(model, state);
        observer->finish(model, state);
      }
  }

  Solution LinearStaticStudy::solve_distributed(const Model        &model,
                                                const StaticLoads  &loads,
                                                const OutputFolder &folder,
                                                Log                &log) const
  {
    const unsigned int b = find_chosen_bodies(fem_, model).front();
    log.line("the mesh of ", model.bodies[b].name(), " is distributed to the ranks");
    DistributedStatics solver(model, b, fem_, folder.communicator());
    Solution           solution;
    static_cast<NodalSolution &>(solution) = solver.solve(loads);
    if (output_.fields_every > 0)
      {
        folder.make_subfolder("fields");
        write_mesh_fields(folder, "fields/" + model.bodies[b].name(), solver.fields());
      }
    return solution;
  }

  Solution LinearStaticStudy::solve(const Model        &model,
                                    const StaticLoads  &loads,
                                    const HubRotation   rotation,
                                    const OutputFolder &folder,
                                    NamedFigures       &figures,
                                    Log                &log) const
  {
    if (fem_.distributed)
      return solve_distributed(model, loads, folder, log);
    const std::vector<unsigned int> bodies = find_chosen_bodies(fem_, model);
    log_housing(model, bodies, log);
    if (options_.centrifugal)
      for (const unsigned int b : bodies)
        if (model.bodies[b].rate != 0)
          warn_of_averaged_bearings(model, b, log);
    FemOptions fem        = fem_;
    const auto solve_once = [&] {
      // Bodies that are free to move are refused here, before anything is assembled.
      Solution solution;
      solution.solver =
        std::make_unique<StaticSolver>(model, bodies, fem, folder.communicator(), rotation);
      solution.result = solution.solver->solve(loads);
      static_cast<NodalSolution &>(solution) =
        make_nodal_solution(*solution.solver, solution.result);
      return solution;
    };
    if (options_.adapted_result.empty())
      return solve_once();
    AdaptiveSteps steps(options_, model);
    Solution      solution = solve_once();
    while (steps.go_on(solution, fem, log))
      solution = solve_once();
    write_csv(folder, "adaptive_refinement.csv", steps.table());
    figures = steps.list_figures();
    return solution;
  }

  void LinearStaticStudy::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    const Model model   = make_model(log);
    RunSummary  summary = start_summary("linear static", model, folder);
    const auto  start   = WallClock::now();
    if (options_.pressed_flank.acts())
      {
        FemOptions fem = fem_;
        fem.choose_elements(affords_quadratic_elements(model), log);
        summary.figures = solve_pressed_flank(
          model, options_.pressed_flank, fem, options_.centrifugal, folder, log);
        summary.run_time = seconds_since(start);
        write_summary(folder, summary, log);
        return;
      }

    // 1. Loads, and how hubs are held that turn freely.
    StaticLoads loads    = options_.loads();
    HubRotation rotation = fem_.hold_hubs ? HubRotation::held : HubRotation::free;
    if (!model.transmissions.empty())
      {
        log.line("the members of the pair rotate independently, without contact and torque");
        loads.part_of_torques = 0;
        if (!fem_.hold_hubs)
          rotation = HubRotation::pinned; // spin has no moment about the axis
      }
    // 2. The solution, and stresses at the nodes.
    NamedFigures                    of_steps;
    const std::vector<unsigned int> bodies   = find_chosen_bodies(fem_, model);
    const Solution                  solution = solve(model, loads, rotation, folder, of_steps, log);
    summary.run_time                         = seconds_since(start);

    // Key numbers, then probes, fields and reactions.
    summary.figures = list_figures(solution);
    summary.figures.insert(summary.figures.end(), of_steps.begin(), of_steps.end());
    log.line("largest displacement ",
             summary.figures[1].second.value,
             " um, largest von Mises stress ",
             summary.figures[2].second.value,
             " MPa, strain energy ",
             solution.strain_energy,
             " mJ; ",
             solution.n_displacements,
             " displacements, ",
             solution.n_iterations,
             " iterations, ",
             summary.run_time,
             " s");

    write_probes(folder, model, solution);
    if (output_.fields_every > 0)
      write_fields(folder, model, bodies, solution);
    write_csv(folder, "reactions.csv", list_reactions(model, bodies, solution.reactions));
    write_summary(folder, summary, log);
    if (output_.pictures)
      draw_pictures(folder, log);
  }

  Table make_adaptive_table()
  {
    Table table;
    for (const char *count : {"step", "elements", "unknowns"})
      table.add_column(count, "-");
    table.add_column("error indicator", "mm^1.5");
    table.add_text_column("result");
    table.add_column("value", "as named");
    table.add_column("change", "%");
    return table;
  }

  Table make_reaction_table()
  {
    Table table{{"constraint"}, {"body"}};
    for (const char *component : {"force x", "force y", "force z"})
      table.add_column(component, "N");
    // Forces are along the fixed axes, from the constraint on the body.
    table.add_column("torque about the axis", "N m");
    return table;
  }

  std::unique_ptr<StudyKind> make_linear_static_study()
  {
    return std::make_unique<LinearStaticStudy>();
  }
} // namespace vfife
