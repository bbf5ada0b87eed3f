// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/lumped/lumped_options.h>
#include <vfife/lumped/speed_sweep.h>
#include <vfife/output/files/figures.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/pictures.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/gear/bearing_supports.h>
#include <vfife/study/gear/lumped_study.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** Multiples of the mesh frequency whose critical speeds are written. */
    constexpr unsigned int n_orders = 3;
    /** As in a run (Dynamics/energy limit) [-]. */
    constexpr double largest_energy_error = .05;

    Json modes_json(const LumpedModel &model)
    {
      Json modes = Json::array();
      for (const LumpedMode &mode : model.find_modes())
        {
          Json critical = Json::array();
          for (unsigned int order = 1; order <= n_orders; ++order)
            // n = 60 f/(k z_driver) [rpm]: harmonic k of the mesh meets the mode.
            critical.push_back(60 * mode.frequency / (order * model.pair().driver_teeth));
          modes.push_back({{lumped_place::frequency, mode.frequency},
                           {"damping ratio [-]", mode.damping_ratio},
                           {"critical pinion speeds of mesh orders 1, 2, 3 [rpm]", critical}});
        }
      return modes;
    }

    NamedFigures model_figures(const LumpedModel &model)
    {
      const LumpedPair &pair = model.pair();
      return {{"torque on the gear", {1e-3 * pair.torque, "N m"}},
              {"gear inertia", {1e3 * pair.driven_inertia, "kg mm^2"}},
              {"pinion inertia", {1e3 * pair.driver_inertia, "kg mm^2"}},
              {"inertia of the torsional mode, at the gear",
               {1e3 * model.swing_inertia(), "kg mm^2"}},
              {"mesh stiffness, mean at the torque", {1e-3 * model.mesh_stiffness(), "N m/rad"}},
              {"lever arm", {pair.arm, "mm"}},
              {"backlash angle of the gear", {pair.law.backlash / arcsecond, "arcsec"}}};
    }

    NamedFigures response_figures(const LumpedResponse &response, const double speed)
    {
      return {{"speed", {speed * 30 / pi, "rpm"}},
              {column::mean_dte, {response.mean_error / arcsecond, "arcsec"}},
              {"rms dte", {response.rms_error / arcsecond, "arcsec"}},
              {column::peak_to_peak_dte, {response.pp_error / arcsecond, "arcsec"}},
              {column::mean_force, {response.mean_force, "N"}},
              {"rms force", {response.rms_force, "N"}},
              {column::peak_to_peak_force, {response.pp_force, "N"}},
              {"losses of contact", {static_cast<double>(response.losses), "-"}},
              {column::time_without_contact, {response.time_apart, "-"}},
              {"time on coast flanks", {response.time_coast, "-"}},
              {column::energy_error, {response.energy_error, "-"}}};
    }

    /** Largest peak-to-peak DTE of a sweep, where contact was lost, and how far both directions
     * differ at one speed. */
    Json sweep_json(const Table &table)
    {
      const std::vector<double> &speed        = table.numbers(column::speed),
                                &swing        = table.numbers(column::peak_to_peak_dte),
                                &apart        = table.numbers(column::time_without_contact);
      const std::vector<std::string> &pass    = table.column(column::direction).texts;
      const std::size_t               n       = std::count(pass.begin(), pass.end(), "up");
      std::size_t                     largest = 0;
      Json                            lost    = Json::array();
      double                          jump = 0, jump_speed = 0;
      for (std::size_t i = 0; i < speed.size(); ++i)
        {
          if (swing[i] > swing[largest])
            largest = i;
          if (apart[i] > 0)
            lost.push_back({{"direction", pass[i]}, {"speed [rpm]", speed[i]}});
          // The way down has the same speeds in opposite order: rows i and 2n - 1 - i are one
          // speed. They differ where the response depends on where it comes from.
          if (i < n && speed.size() == 2 * n)
            {
              const double difference = std::abs(swing[i] - swing[2 * n - 1 - i]);
              if (difference > jump)
                {
                  jump       = difference;
                  jump_speed = speed[i];
                }
            }
        }
      return {{"largest peak to peak dte", figure_json(swing[largest], "arcsec")},
              {"at the speed", figure_json(speed[largest], "rpm")},
              {"largest difference of both directions", figure_json(jump, "arcsec")},
              {"difference at the speed", figure_json(jump_speed, "rpm")},
              {"contact lost at", lost}};
    }

    void log_model(const LumpedModel &model, Log &log)
    {
      log.line("mean mesh stiffness ",
               1e-3 * model.mesh_stiffness(),
               " N m/rad at ",
               1e-3 * model.pair().torque,
               " N m, inertia of the torsional mode ",
               1e3 * model.swing_inertia(),
               " kg mm^2");
      for (const LumpedMode &mode : model.find_modes())
        if (mode.frequency > 0)
          log.line("natural frequency ",
                   mode.frequency,
                   " Hz, damping ratio ",
                   mode.damping_ratio,
                   ", excited by the gear mesh at ",
                   60 * mode.frequency / model.pair().driver_teeth,
                   " rpm");
    }

    class LumpedStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        // Without a gear pair the section Lumped has to give all numbers, and Operation stands
        // alone.
        if (describes_pair(file))
          {
            pair_case_ = make_pair_case(file);
            pair_case_->declare(prm, file);
          }
        else
          operation_.declare(prm);
        options_.declare(prm, file);
        Subsection section(prm, "Lumped");
        run_.declare(prm);
        sweep_.declare(prm);
        declare_switch(prm, "report", pictures_, "Writes the report at the end");
      }

      void check() const override
      {
        if (pair_case_)
          pair_case_->check_bodies();
        operation().require_speed("Operation");
        operation().check("Operation");
        operation().require_driving_pinion("Operation", "lumped model");
        operation().require_constant("Operation", "lumped model");
        options_.check();
        sweep_.check("Lumped");
      }

      void inspect(Communicator &, Log &log) override
      {
        log_model(LumpedModel(make_pair(log)), log);
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      const OperationOptions &operation() const;
      /** Fills what the options leave open from the gear pair. */
      LumpedPair make_pair(Log &log) const;

      std::unique_ptr<PairCase> pair_case_; ///< nullptr: without a gear pair
      OperationOptions          operation_; ///< without a gear pair
      LumpedOptions             options_;
      LumpedRunOptions          run_;
      SpeedSweepOptions         sweep_;
      bool                      pictures_ = true;
    };
  } // namespace

  const OperationOptions &LumpedStudy::operation() const
  {
    return pair_case_ ? pair_case_->operation() : operation_;
  }

  LumpedPair LumpedStudy::make_pair(Log &log) const
  {
    // What the file gives wins over what the pair would have given.
    LumpedOptions              filled = options_;
    std::vector<LumpedSupport> bearings;
    if (pair_case_)
      {
        // What the section leaves open is taken of the bodies' meshes and the pair: zeros, a
        // negative backlash, a normal of no length.
        const Model model = pair_case_->make_model(log);
        if (model.has_initial_strains())
          log.warning("a temperature acts in the lumped model only as far as the table of the "
                      "loaded contact contains it");
        const Transmission &t    = *model.only_transmission();
        const auto          fill = [](auto &value, const auto known) {
          if (!(value > 0))
            value = known;
        };
        fill(filled.driver_teeth, t.driver_teeth);
        fill(filled.driven_teeth, t.driven_teeth);
        fill(filled.driver_inertia, model.bodies[t.driver].axial_inertia());
        fill(filled.driven_inertia, model.bodies[t.driven].axial_inertia());
        fill(filled.arm, t.arm);
        // The turn of the gear [rad] times the arm: along the line of action [mm].
        if (filled.backlash < 0)
          filled.backlash = pair_case_->backlash_angle() * filled.arm;
        if (filled.contact_normal.norm() == 0)
          {
            filled.contact_normal = t.contact_normal;
            filled.contact_point  = t.contact_point;
          }
        if (filled.in_bearings)
          bearings = find_bearing_supports(model);
      }
    if (filled.in_bearings && bearings.empty())
      throw InputError("Lumped/bearings", "no member of the pair is on a shaft in bearings");
    // The pinion drives.
    const OperationOptions &given = operation();
    LumpedPair              pair  = filled.make_pair(
      given.pinion_torque > 0 ? given.pinion_torque * filled.driven_teeth / filled.driver_teeth
                              : given.torque);
    pair.supports.insert(pair.supports.end(), bearings.begin(), bearings.end());
    return pair;
  }

  void LumpedStudy::run(OutputFolder &folder, Log &log)
  {
    const LumpedModel model(make_pair(log));
    log_model(model, log);
    const double speed = operation().speed;
    // The speed of the section Operation first, with its motion; then the sweep, of which only
    // figures are kept.
    Table          motion = make_motion_table(model);
    LumpedResponse response;
    {
      LumpedSolver solver(model, run_);
      response = solver.run(speed * model.pair().driver_teeth / (2 * pi),
                            [&](const LumpedSolver::Sample &s) { add_motion(model, s, motion); });
    }
    log.line("at ",
             speed * 30 / pi,
             " rpm: dte ",
             response.mean_error / arcsecond,
             " arcsec, peak to peak ",
             response.pp_error / arcsecond,
             "; force ",
             response.mean_force,
             " N, peak to peak ",
             response.pp_force,
             "; ",
             response.losses,
             " tooth separations; energy error ",
             response.energy_error);
    if (response.energy_error > largest_energy_error)
      log.warning("the energy error of the lumped model exceeds ",
                  1e2 * largest_energy_error,
                  " %: forces and transmission errors are inaccurate. Decrease Lumped/tolerance.");
    Table resonance = make_resonance_response_table();
    if (sweep_.kind != SweepKind::none)
      {
        sweep_speeds(model, run_, sweep_, resonance);
        write_csv(folder, "resonance.csv", resonance);
      }
    write_csv(folder, "lumped.csv", motion);
    write_json(folder, "lumped.json", make_lumped_json(model, response, speed, resonance));
    if (pictures_)
      draw_pictures(folder, log);
  }

  Json make_lumped_json(const LumpedModel    &model,
                        const LumpedResponse &response,
                        const double          speed,
                        const Table          &resonance)
  {
    Json json = {{"model", figures_json(model_figures(model))},
                 {lumped_place::modes, modes_json(model)},
                 {lumped_place::response, figures_json(response_figures(response, speed))}};
    if (resonance.n_rows() > 0)
      json["sweep"] = sweep_json(resonance);
    return json;
  }

  std::unique_ptr<StudyKind> make_lumped_study()
  {
    return std::make_unique<LumpedStudy>();
  }
} // namespace vfife
