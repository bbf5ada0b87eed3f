// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/fem/cyclic/cyclic_body.h>
#include <vfife/fem/distributed/distributed_checks.h>
#include <vfife/fem/distributed/distributed_modes.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/modes/campbell.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/pair_measures.h>
#include <vfife/output/files/mode_writer.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/study/cases/case.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/conventional/chosen_bodies.h>
#include <vfife/study/conventional/field_grid.h>
#include <vfife/study/start_summary.h>
#include <vfife/study/study_kinds.h>
#include <vfife/study/turning_axes.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace vfife
{
  namespace
  {
    class ModalStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        case_ = make_case(file);
        case_->declare(prm, file);
        // Of the section Dynamics the damping is of use: that of a run of the same file.
        case_->set_defaults(dynamics_, output_);
        dynamics_.declare(prm);
        output_.declare(prm);
        case_->declare_run(prm);
        declare_section(prm, "Fem", fem_);
      }

      void check() const override
      {
        // Speeds are those of the section Fem, at rest if nothing is said, and nothing loads the
        // bodies.
        case_->check_bodies();
        dynamics_.check("Dynamics");
        output_.check("Output");
        fem_.check("Fem");
        check_distributed(fem_);
      }

      void inspect(Communicator &, Log &log) override
      {
        const Model model = make_model(log);
        for (const unsigned int b : find_chosen_bodies(fem_, model))
          log.line("modes of the ",
                   model.bodies[b].name(),
                   ": ",
                   fem_.n_modes,
                   " at ",
                   fem_.rates().size(),
                   fem_.rates().size() == 1 ? " speed" : " speeds");
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      /** Where entries leave them open. */
      void  choose_methods(const Model &model, Log &log);
      Model make_model(Log &log) const
      {
        Model model = case_->make_model(log);
        check_distributed(fem_, model, find_chosen_bodies(fem_, model), false);
        return model;
      }
      /** All modes at rest, on a mesh that is distributed to the ranks; writes their shapes at all
       * points. */
      ModesAtSpeed find_distributed_modes(const Model        &model,
                                          unsigned int        body,
                                          const OutputFolder &folder,
                                          Log                &log) const;
      void solve_body(const Model &model, unsigned int body, const OutputFolder &folder, Log &log);
      void log_damping(const ModesAtSpeed &found, double zeta, Log &log) const;

      std::unique_ptr<Case> case_;
      DynamicsOptions       dynamics_;
      OutputOptions         output_;
      FemOptions            fem_;
      Table                 modes_      = make_mode_table();
      Table                 campbell_   = make_campbell_table();
      Table                 resonances_ = make_resonance_table();
    };

    /** Speed of the pinion over that of a member of a pair; no number without a pair. */
    double find_pinion_ratio(const Model &model, const unsigned int body)
    {
      for (const Transmission &t : model.transmissions)
        if (body == t.driver || body == t.driven)
          {
            const unsigned int teeth  = find_member(t, body).teeth;
            const bool         drives = model.bodies[t.driver].name() == "pinion";
            return double(teeth) / (drives ? t.driver_teeth : t.driven_teeth);
          }
      return not_known;
    }
  } // namespace

  void ModalStudy::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    const Model model   = make_model(log);
    RunSummary  summary = start_summary("modal", model, folder);
    const auto  start   = WallClock::now();
    choose_methods(model, log);
    summary.figures.push_back(
      {figure_name::degree_of_elements, {double(degree_of(fem_.element)), "-"}});
    folder.make_subfolder("modes");
    for (const unsigned int b : find_chosen_bodies(fem_, model))
      solve_body(model, b, folder, log);
    // A single speed has no branches.
    if (fem_.rates().size() > 1)
      {
        write_tables(folder, "campbell", campbell_);
        write_tables(folder, "resonances", resonances_);
      }
    write_tables(folder, "modes", modes_);
    summary.run_time = seconds_since(start);
    write_summary(folder, summary, log);
    if (output_.pictures)
      draw_pictures(folder, log);
  }

  void ModalStudy::choose_methods(const Model &model, Log &log)
  {
    const auto &bodies = find_chosen_bodies(fem_, model);
    // Lobpcg is asked for where the memory is short of factors, and distributed meshes have no
    // sectors.
    const bool can_have_sectors =
      !fem_.distributed && fem_.eigen_solver == EigenSolverKind::shift_invert &&
      std::all_of(bodies.begin(), bodies.end(), [&](const unsigned int b) {
        // Nodes are a third of the unknowns: enough also where many are held.
        return fem_.n_modes <=
                 ModalSolver::largest_number(model.bodies[b].structure().nodes_per_sector()) &&
               has_equal_sectors(model, b, fem_);
      });
    fem_.choose_sectors(can_have_sectors, log);
    fem_.choose_elements(fem_.cyclic_symmetry, log);
  }

  void ModalStudy::log_damping(const ModesAtSpeed &found, const double zeta, Log &log) const
  {
    const auto percent = [zeta](const RotatingMode &mode) {
      return 1e2 * mode.damping_ratio(zeta);
    };
    const auto lowest = std::find_if(found.modes.begin(),
                                     found.modes.end(),
                                     [](const RotatingMode &mode) { return mode.frequency > 0; });
    if (!(zeta > 0) || lowest == found.modes.end())
      return;
    log.line("damping of ",
             zeta,
             " 1/s: ratios from ",
             percent(*lowest),
             " % of the lowest vibration to ",
             percent(found.modes.back()),
             " % of the highest (modes.csv)");
  }

  ModesAtSpeed ModalStudy::find_distributed_modes(const Model        &model,
                                                  const unsigned int  b,
                                                  const OutputFolder &folder,
                                                  Log                &log) const
  {
    DistributedModes modes(model, b, fem_, folder.communicator());
    ModesAtSpeed     found = modes.find_modes();
    log.line("the mesh of ",
             model.bodies[b].name(),
             " is distributed to the ranks; LOBPCG, ",
             modes.n_iterations(),
             " iterations; modes are not counted, so that one may be missing");
    write_mesh_fields(folder, "modes/" + model.bodies[b].name() + "_0_rpm", modes.fields());
    return found;
  }

  void ModalStudy::solve_body(const Model        &model,
                              const unsigned int  b,
                              const OutputFolder &folder,
                              Log                &log)
  {
    const Body                         &body = model.bodies[b];
    std::unique_ptr<const RotatingBody> rotating;
    if (!fem_.distributed)
      rotating = std::make_unique<RotatingBody>(model, b, fem_, folder.communicator());
    const FieldGrid shown =
      rotating ? FieldGrid(rotating->shown(), rotating->shown().parts().front()) : FieldGrid(body);
    std::vector<ModesAtSpeed> speeds;
    log_housing(model, {b}, log);
    const std::vector<double> rates = fem_.rates();
    if (std::any_of(rates.begin(), rates.end(), [](const double rate) { return rate != 0; }))
      {
        refuse_standing_springs(model, b);
        warn_of_averaged_bearings(model, b, log);
      }
    else if (body.rate != 0)
      log.line(body.name(),
               ": modes at rest; in operation it rotates at ",
               std::abs(body.rate) * 30. / pi,
               " rpm. Set Fem/speeds, and Fem/coriolis = yes for travelling waves");
    // Dampers of bearings are not in the ratios, which are unknown then.
    const double zeta = warn_of_dampers(model, b, log) ? not_known : dynamics_.mass_damping();
    for (const double rate : rates)
      {
        // Each speed is a problem of its own: stresses of its spin, its Coriolis forces.
        const auto   start = WallClock::now();
        ModesAtSpeed found =
          rotating ? rotating->find_modes(rate) : find_distributed_modes(model, b, folder, log);
        const double seconds = seconds_since(start);
        log.line(body.name(),
                 " at ",
                 rate * 30. / pi,
                 " rpm: ",
                 found.modes.size(),
                 " modes from ",
                 found.modes.front().frequency,
                 " to ",
                 found.modes.back().frequency,
                 " Hz, rigid motions of the body at rest: ",
                 found.n_rigid,
                 "; ",
                 found.counted ? "counted by factorization" : "not counted",
                 "; ",
                 found.n_unknowns,
                 " unknowns, ",
                 found.memory > 0 ? "factors of " + figure_text(found.memory) + " MB, " : "",
                 seconds,
                 " s");
        if (rate != 0)
          log.line("largest displacement under spin ", 1e3 * found.growth, " um");
        log_damping(found, zeta, log);
        add_modes(body.name(), found, zeta, modes_);

        // Shapes go into the file and out of memory, speed by speed; branches need frequencies
        // alone.
        std::vector<NamedShape> shapes;
        for (std::size_t k = 0; k < found.modes.size(); ++k)
          {
            std::vector<double> &shape = found.modes[k].shape;
            shapes.push_back({shape_name(k, found.modes[k].frequency), shown.take(shape)});
            shape = {};
          }
        std::ostringstream name;
        name << "modes/" << body.name() << "_" << std::lround(rate * 30. / pi) << "_rpm.vtu";
        write_shapes(folder, name.str(), shown.make_grid(), shapes);
        speeds.push_back(std::move(found));
      }
    // Modes of the same kind joined over the speeds, then their crossings with the orders of
    // excitation.
    const std::vector<CampbellBranch> branches = make_branches(speeds);
    add_branches(body.name(), branches, campbell_);
    add_resonances(body.name(),
                   branches,
                   body.structure().n_sectors(),
                   fem_.mesh_orders,
                   find_pinion_ratio(model, b),
                   resonances_);
  }

  std::unique_ptr<StudyKind> make_modal_study()
  {
    return std::make_unique<ModalStudy>();
  }
} // namespace vfife
