// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of GearCase that finds what a user will not expect; doc/study.md lists the checks.
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/gear/unloaded_contact/unloaded_contact.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/output_options.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/cases/gear_case.h>
#include <vfife/study/cases/run_plan.h>
#include <vfife/study/cases/torque_pressure.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** A sentence of texts and numbers, these with four digits. */
    template <typename... Parts>
    std::string text(const Parts &...parts)
    {
      std::ostringstream message;
      message.precision(4);
      (message << ... << parts);
      return message.str();
    }

    /** A sentence, or nothing where all is well. */
    using ModelCheck = std::string (*)(const GearCase &gear_case, const Model &model);
    using RunCheck   = std::string (*)(const GearCase &gear_case, const RunPlan &plan);

    std::string check_damping(const GearCase &, const RunPlan &plan)
    {
      const double largest = std::max(plan.dynamics.mass_damping(), plan.dynamics.mesh_damping);
      // Recommended in doc/conventions.md, Damping; DynamicsOptions refuses dampers that are far
      // stronger.
      if (!(largest > 2000.))
        return "";
      return text("damping of ",
                  largest,
                  " 1/s is above 2000 1/s: it drags the deformation that stands still in space and "
                  "changes the compliance");
    }

    std::string check_damping_rate(const GearCase &, const RunPlan &plan)
    {
      if (plan.dynamics.damping_rate == DampingRate::momentum ||
          !(plan.dynamics.mass_damping() > 0))
        return "";
      return "damping relative to the mean speed exerts a torque about the axis; the damping audit "
             "of summary.json states it";
    }

    std::string check_ramp(const GearCase &gear_case, const RunPlan &plan)
    {
      const OperationOptions &operation = gear_case.operation();
      if (plan.dynamics.start != Start::ramp)
        return "";
      if (operation.ramp == 0)
        return "start = ramp with ramp = 0 is a step of the torque: the contact force overshoots "
               "and the flanks may part";
      if (operation.ramp >= gear_case.run_meshes())
        return text("the ramp of ",
                    operation.ramp,
                    " tooth meshes does not end within the run of ",
                    gear_case.run_meshes(),
                    ": no steady part is possible");
      return "";
    }

    std::string check_flank(const GearCase &, const Model &model)
    {
      // The driver pushes along -n: the moment -a . ((P - c) x n) about the driven axis must have
      // the sense in which the driven member turns.
      const Transmission &t    = *model.transmission;
      const Axis         &axis = model.bodies[t.driven].axis;
      const double        arm  = -t.driven_sense *
                         axis.direction.dot((t.contact_point - axis.point).cross(t.contact_normal));
      return arm > 0 ? ""
                     : "the flanks of the drive side push the gear against the drive "
                       "direction: the load torque opens them";
    }

    std::string check_hertz(const GearCase &gear_case, const Model &model)
    {
      // Two smaller semi-axes.
      const double width = 2 * TorquePressure(gear_case.hertz_contact(), model).semi_axes[1];
      const ContactResolution seen(model, model.contacts.front(), width);
      if (seen.has_single_points())
        return seen.describe_points("Hertz's contact");
      if (seen.facet > width)
        return text("flank elements of ",
                    seen.facet,
                    " mm are wider than Hertz's contact of ",
                    width,
                    " mm: forces are meaningful, pressures and subsurface stresses are not");
      return "";
    }

    std::string check_pressure(const GearCase &gear_case, const Model &model)
    {
      return TorquePressure(gear_case.hertz_contact(), model)
        .find_excess(gear_case.operation().pressure_limit);
    }

    std::string check_path(const GearCase &gear_case, const Model &)
    {
      try
        {
          const GearPair pair = gear_case.make_pair();
          UnloadedContact(pair, gear_case.working_side()).path_range();
        }
      catch (const NumericalError &error)
        {
          return error.what();
        }
      return "";
    }

    std::string check_spin(const GearCase &gear_case, const Model &)
    {
      // Of steels 1000 MPa: the strongest gears carry no more, teeth and web on the rim left out.
      constexpr double limit  = 0.005;
      const double     strain = gear_case.ring_strain();
      if (strain <= limit)
        return "";
      return text("a free ring at the pitch circle would be stretched by ",
                  1e2 * strain,
                  " % at this speed: no gear body carries that");
    }

    std::string check_hub(const GearCase &gear_case, const Model &)
    {
      if (gear_case.has_web() || gear_case.operation().hub != HubKind::free_rotation)
        return "";
      return "web = none with hub = free rotation: the rim's underside is guided radially and "
             "axially, and each of its nodes turns on its own";
    }

    std::string check_step(const GearCase &, const RunPlan &plan)
    {
      // Whole steps from sample to sample cost little, unless samples are a few steps apart: then
      // the user can have the time back.
      if (plan.step < 0.7 * plan.stable_step)
        return text("history every = ",
                    plan.output.history_every,
                    " samples a tooth mesh makes the step ",
                    plan.step / plan.stable_step,
                    " of the stable one");
      if (plan.stable_step < 0.6 * plan.element_step)
        return text("the contact penalty makes the step ",
                    plan.stable_step / plan.element_step,
                    " of that of the elements");
      return "";
    }

    std::string check_fields(const GearCase &gear_case, const RunPlan &plan)
    {
      const double every = plan.output.fields_every;
      // [tooth meshes], as the length of the run.
      if (every <= gear_case.run_meshes())
        return "";
      return text("fields every = ",
                  every,
                  " is more than the run's ",
                  gear_case.run_meshes(),
                  " tooth meshes: fields are written at the start and the end only");
    }

    std::string check_checkpoint(const GearCase &, const RunPlan &plan)
    {
      if (plan.output.checkpoint_every > 0 || plan.expected_time < 3600)
        return "";
      return "a run of about " + duration_text(plan.expected_time) +
             " without checkpoints (Output/checkpoint every)";
    }

    std::string check_samples(const GearCase &, const RunPlan &plan)
    {
      // A tooth pair's share of a mesh and its harmonics need some points.
      if (plan.output.history_every >= 10)
        return "";
      return text("history every = ",
                  plan.output.history_every,
                  " samples a tooth mesh miss the ripple: means and peaks will be wrong");
    }

    std::string check_length(const GearCase &gear_case, const RunPlan &plan)
    {
      constexpr double month = 30. * 24 * 3600;
      if (!(plan.expected_time > month))
        return "";
      return text("a tooth mesh has ",
                  std::round(1. / (gear_case.mesh_frequency() * plan.step)),
                  " steps at this speed: slow motion is for the loaded tooth contact analysis or a "
                  "reduced pair");
    }

    const std::vector<ModelCheck> model_checks = {
      &check_flank, &check_path, &check_hub, &check_spin, &check_hertz, &check_pressure};
    const std::vector<RunCheck> run_checks = {&check_damping,
                                              &check_damping_rate,
                                              &check_ramp,
                                              &check_step,
                                              &check_samples,
                                              &check_fields,
                                              &check_length,
                                              &check_checkpoint};

    /** Contradictions are said and not refused: a user may want just that. */
    template <typename Check, typename Of>
    void add_sentences(const std::vector<Check> &checks,
                       const GearCase           &gear_case,
                       const Of                 &of,
                       std::vector<std::string> &found)
    {
      for (const Check check : checks)
        {
          const std::string sentence = check(gear_case, of);
          if (!sentence.empty())
            found.push_back(sentence);
        }
    }
  } // namespace

  std::vector<std::string> GearCase::find_model_contradictions(const Model &model) const
  {
    std::vector<std::string> found;
    add_sentences(model_checks, *this, model, found);
    return found;
  }

  std::vector<std::string> GearCase::report_load(const Model &model, Log &log) const
  {
    log.line(TorquePressure(hertz_contact(), model).describe());
    const std::vector<std::string> found = find_model_contradictions(model);
    log_contradictions(found, log);
    return found;
  }

  std::vector<std::string> GearCase::find_contradictions(const RunPlan &plan) const
  {
    std::vector<std::string> found = find_model_contradictions(plan.model);
    add_sentences(run_checks, *this, plan, found);
    return found;
  }
} // namespace vfife
