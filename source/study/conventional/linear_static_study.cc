// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/section_of_options.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/fem/statics/reactions.h>
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
#include <vfife/study/conventional/linear_static_study.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/turning_axes.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Stresses of the model's nodes, as displacements, in the fixed frame at time zero. Bodies
     * that are not part of the space show zeros. */
    ProbeValue find_probe_value(const Probe               &probe,
                                const FemSpace            &space,
                                const StaticResult        &result,
                                const std::vector<Stress> &stresses)
    {
      const FemSpace::Part *const part = space.find_part(probe.body);
      if (part == nullptr)
        return {};
      const Body       &body   = space.model().bodies[probe.body];
      const Matrix3     frame  = body.placement.rotation;
      const std::size_t row    = 3 * std::size_t(part->first_point + probe.node);
      const Vector3     moved  = Eigen::Map<const Vector3>(result.displacements.data() + row);
      const Stress     &stress = stresses[body.first_node + probe.node];
      if (probe.fixed_axes)
        return make_probe_value(moved, stress, {frame});
      const Matrix3 axes = compute_cylindrical_axes(body, body.node_positions()[probe.node]);
      return make_probe_value(axes.transpose() * (frame.transpose() * moved),
                              stress,
                              {frame, axes});
    }

    /** Words for LinearStaticOptions::at_time. */
    const Choices<bool> load_choices = {{"full", false}, {"at time", true}};

    /** @p part 's displacements [mm], 3 a node: points of a body are in the order of its nodes. */
    std::vector<double>
    displacements_of(const FemSpace::Part &part, const Body &body, const StaticResult &result)
    {
      const auto first = result.displacements.begin() + 3 * std::size_t(part.first_point);
      return {first, first + 3 * std::size_t(body.n_nodes())};
    }

    /** One file a body: displacements, stresses in its cylindrical axes, von Mises. */
    void write_fields(const OutputFolder        &folder,
                      const FemSpace            &space,
                      const StaticResult        &result,
                      const std::vector<Stress> &stresses)
    {
      folder.make_subfolder("fields");
      for (const FemSpace::Part &part : space.parts())
        {
          const Body           &body   = space.model().bodies[part.body];
          std::vector<VtuArray> fields = make_stress_arrays();
          for (unsigned int i = 0; i < body.n_nodes(); ++i)
            {
              // Stresses of the solver are along the fixed axes; r, theta, z are those of the
              // node's own place.
              const Stress &stress = stresses[body.first_node + i];
              add_stress(turn_stress(stress,
                                     body.placement.rotation *
                                       compute_cylindrical_axes(body, body.node_positions()[i])),
                         stress,
                         fields.begin());
            }
          write_shapes(folder,
                       "fields/" + body.name() + ".vtu",
                       body,
                       {{"displacement", displacements_of(part, body, result), "mm"}},
                       std::move(fields));
        }
    }

    /** A row a support of the bodies looked at: what it exerts on its nodes. */
    Table list_reactions(const FemSpace &space, const std::vector<Reaction> &reactions)
    {
      Table                      table    = make_reaction_table();
      const Model               &model    = space.model();
      const std::vector<Support> supports = list_supports(model);
      for (std::size_t s = 0; s < supports.size(); ++s)
        if (space.find_part(supports[s].body) != nullptr)
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
        fem_.mass            = MassKind::lumped; // as the mass points of a run
        fem_.linear_solver   = LinearSolverKind::direct;
        output_.fields_every = 1;
      }


      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        case_ = make_case(file);
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
        options_.check();
        fem_.check("Fem");
        if (fem_.cyclic_symmetry)
          throw InputError("Fem/cyclic symmetry",
                           "must be no, because loads require the whole body");
        if (fem_.speeds != FemOptions().speeds)
          throw InputError("Fem/speeds", "must be 0, because each body has its own speed");
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
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      Model make_model(Log &log) const;
      void  refuse_what_is_not_linear(const Model &model) const;
      void  write_probes(const OutputFolder        &folder,
                         const Model               &model,
                         const FemSpace            &space,
                         const StaticResult        &result,
                         const std::vector<Stress> &stresses) const;

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
                   "Loads and prescribed displacements in full, or as their histories say");
    declare_quantity(prm, "time", time, "s", "At which histories are read, with loads = at time");
    declare_switch(prm, "centrifugal", centrifugal, "Centrifugal force on bodies that turn");
    declare_switch(prm,
                   "spin softening",
                   spin_softening,
                   "Whether the centrifugal force acts on the displaced mass");
    declare_switch(prm,
                   "stress stiffness",
                   stress_stiffness,
                   "Whether stresses of the centrifugal force stiffen the bodies");
  }

  void LinearStaticOptions::check() const
  {
    if (!at_time && time != 0)
      throw InputError("Linear static/time", "histories are read with loads = at time only");
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
    if (model.transmission)
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
    return model;
  }

  void LinearStaticStudy::write_probes(const OutputFolder        &folder,
                                       const Model               &model,
                                       const FemSpace            &space,
                                       const StaticResult        &result,
                                       const std::vector<Stress> &stresses) const
  {
    // Observers write what they are shown: a state that holds what a row of the probes asks for.
    State state;
    state.time = options_.at_time ? options_.time : 1.; // as in `static`, the part of the loads
    state.measured.energy.strain = result.strain_energy;
    state.measured.reactions     = compute_reactions(space, result);
    for (const Probe &probe : model.probes)
      state.measured.probes.push_back(find_probe_value(probe, space, result, stresses));
    Observers observers;
    if (!model.transmission)
      observers.push_back(std::make_unique<HistoryWriter>(folder, model, 1));
    else
      observers.push_back(std::make_unique<ProbeWriter>(folder, 1));
    for (const auto &observer : observers)
      {
        observer->observe(model, state);
        observer->finish(model, state);
      }
  }

  void LinearStaticStudy::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    const Model model   = make_model(log);
    RunSummary  summary = start_summary("linear static", model, folder);
    const auto  start   = WallClock::now();

    // 1. Loads, and how hubs are held that turn freely.
    StaticLoads loads    = options_.loads();
    HubRotation rotation = fem_.hold_hubs ? HubRotation::held : HubRotation::free;
    if (model.transmission)
      {
        log.line("the members of the pair rotate independently, without contact and torque");
        loads.part_of_torques = 0;
        if (!fem_.hold_hubs)
          rotation = HubRotation::pinned; // spin has no moment about the axis
      }
    // 2. The solution, and stresses at the nodes.
    // Bodies that are free to move are refused here, before anything is assembled.
    const std::vector<unsigned int> bodies = find_chosen_bodies(fem_, model);
    log_housing(model, bodies, log);
    if (options_.centrifugal)
      for (const unsigned int b : bodies)
        if (model.bodies[b].rate != 0)
          warn_of_averaged_bearings(model, b, log);
    const StaticSolver        solver(model, bodies, fem_, folder.communicator(), rotation);
    const StaticResult        result   = solver.solve(loads);
    const std::vector<Stress> stresses = solver.compute_node_stresses(result);
    summary.run_time                   = seconds_since(start);

    // Key numbers, then probes, fields and reactions.
    double largest = 0, stress = 0;
    for (std::size_t i = 0; i < result.displacements.size(); i += 3)
      largest =
        std::max(largest, Eigen::Map<const Vector3>(result.displacements.data() + i).norm());
    for (const Stress &here : stresses)
      stress = std::max(stress, von_mises(here));
    summary.figures = {{"strain energy", {result.strain_energy, "mJ"}},
                       {"largest displacement", {1e3 * largest, "um"}},
                       {"largest von mises", {stress, "MPa"}}};
    log.line("largest displacement ",
             1e3 * largest,
             " um, largest von Mises stress ",
             stress,
             " MPa, strain energy ",
             result.strain_energy,
             " mJ; ",
             3 * solver.space().n_points(),
             " displacements, ",
             result.n_iterations,
             " iterations, ",
             summary.run_time,
             " s");

    write_probes(folder, model, solver.space(), result, stresses);
    if (output_.fields_every > 0)
      write_fields(folder, solver.space(), result, stresses);
    write_csv(folder,
              "reactions.csv",
              list_reactions(solver.space(), compute_reactions(solver.space(), result)));
    write_summary(folder, summary, log);
    if (output_.pictures)
      draw_pictures(folder, log);
  }

  Table make_reaction_table()
  {
    Table table;
    table.add_text_column("constraint");
    table.add_text_column("body");
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
