// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/output_options.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/cases/pair/pair_conflicts.h>
#include <vfife/study/cases/pair_case.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    struct Pair
    {
      const PairCase  &pair_case;
      const PairFacts &facts;
    };

    /** A sentence, or nothing where all is well or the study has not what is looked at. */
    using Check = std::string (*)(const Pair &pair, const RunPlan &plan);

    std::string check_friction(const Pair &, const RunPlan &plan)
    {
      // Reduced pairs refuse friction themselves.
      if (plan.model == nullptr || plan.dynamics != nullptr ||
          !plan.model->contacts.front().options.friction.acts())
        return "";
      return "this analysis has no friction: Contact/friction coefficient acts in runs only";
    }

    std::string check_damping(const Pair &pair, const RunPlan &plan)
    {
      if (plan.dynamics == nullptr)
        return "";
      const double largest = std::max(plan.dynamics->mass_damping(), plan.dynamics->mesh_damping),
                   limit   = PairCase::recommended_damping * pair.pair_case.ring_rate();
      if (!(largest > limit))
        return "";
      return sentence_of(4,
                         "damping of ",
                         largest,
                         " 1/s exceeds ",
                         limit,
                         " 1/s: it distorts the static deflection pattern and the compliance");
    }

    std::string check_damping_rate(const Pair &, const RunPlan &plan)
    {
      if (plan.dynamics == nullptr || plan.dynamics->damping_rate == DampingRate::momentum ||
          !(plan.dynamics->mass_damping() > 0))
        return "";
      return "damping relative to the mean speed exerts a torque about the axis; the damping audit "
             "of summary.json states it";
    }

    std::string check_ramp(const Pair &pair, const RunPlan &plan)
    {
      const OperationOptions &operation = pair.pair_case.operation();
      if (plan.dynamics == nullptr || plan.dynamics->start != Start::ramp)
        return "";
      if (operation.ramp == 0)
        return "start = ramp with ramp = 0 is a step of the torque: the contact force overshoots "
               "and the flanks may separate";
      if (operation.ramp >= pair.pair_case.run_meshes())
        return sentence_of(4,
                           "the ramp of ",
                           operation.ramp,
                           " mesh cycles does not end within the run of ",
                           pair.pair_case.run_meshes(),
                           ": no steady part is possible");
      return "";
    }

    std::string check_torque(const Pair &pair, const RunPlan &plan)
    {
      const PairCase &the_case = pair.pair_case;
      if (plan.dynamics == nullptr ||
          !(the_case.driven_torque_history().find_range(the_case.end_time()).first < 0.))
        return "";
      return "the torque becomes negative within the run: the coast flanks are then in contact, "
             "but penalty, patterns and root stresses are those of the drive flanks";
    }

    std::string check_flank(const Pair &, const RunPlan &plan)
    {
      if (plan.model == nullptr)
        return "";
      // The driver pushes along -n: the moment -a . ((P - c) x n) about the driven axis must have
      // the sense in which the driven member turns.
      const Transmission &t    = *plan.model->only_transmission();
      const Axis         &axis = plan.model->bodies[t.driven].axis;
      const double        arm  = -t.driven_sense *
                         axis.direction.dot((t.contact_point - axis.point).cross(t.contact_normal));
      return arm > 0 ? ""
                     : "the flanks of the drive side push the gear against the drive "
                       "direction: the load torque opens them";
    }

    std::string check_hertz(const Pair &pair, const RunPlan &plan)
    {
      if (plan.model == nullptr)
        return "";
      const Model &model = *plan.model;
      // Two smaller semi-axes.
      const double width = 2 * TorquePressure(pair.pair_case.hertz_contact(), model).semi_axes[1];
      const ContactResolution seen(model, model.contacts.front(), width);
      if (seen.has_single_points())
        return seen.describe_points("the Hertzian contact");
      if (seen.facet > width)
        return sentence_of(
          4,
          "flank elements are ",
          seen.facet,
          " mm wide, the Hertzian contact ",
          width,
          " mm (full width): tooth forces and Hertzian pressures are usable, nodal pressures and "
          "subsurface stresses are not");
      return "";
    }

    /** What is wrong with Hertz's pressure under all the torque; empty for nothing. */
    std::string describe_excess(const PairCase &pair_case, const PairFacts &facts)
    {
      return facts.pressure ? facts.pressure->find_excess(pair_case.operation().pressure_limit)
                            : "";
    }

    std::string check_pressure(const Pair &pair, const RunPlan &)
    {
      return describe_excess(pair.pair_case, pair.facts);
    }

    std::string check_path(const Pair &pair, const RunPlan &)
    {
      return pair.facts.fault_of_path;
    }

    std::string check_spin(const Pair &pair, const RunPlan &)
    {
      // Of steels 1000 MPa: the strongest gears carry no more, teeth and web on the rim left out.
      constexpr double limit  = 0.005;
      const double     strain = pair.facts.ring_strain;
      if (strain <= limit)
        return "";
      return sentence_of(4,
                         "a free ring at the pitch circle would be stretched by ",
                         1e2 * strain,
                         " % at this speed, more than any gear body withstands");
    }

    std::string check_hub(const Pair &pair, const RunPlan &)
    {
      if (pair.facts.has_web || pair.pair_case.operation().hub != HubKind::free_rotation)
        return "";
      return "body type = rim only with bore rotation = per node: the underside of the rim is "
             "guided "
             "radially and axially, and each node rotates independently";
    }

    std::string check_step(const Pair &, const RunPlan &plan)
    {
      // Whole steps from sample to sample cost little, unless samples are a few steps apart: then
      // the user can have the time back.
      if (plan.step < 0.7 * plan.stable_step)
        return sentence_of(4,
                           "samples per mesh cycle = ",
                           plan.output->history_every,
                           " reduces the step to ",
                           plan.step / plan.stable_step,
                           " of the stable step");
      if (plan.stable_step < 0.6 * plan.element_step)
        return sentence_of(4,
                           "the contact penalty reduces the step to ",
                           plan.stable_step / plan.element_step,
                           " of the stable step of the elements");
      return "";
    }

    std::string check_fields(const Pair &pair, const RunPlan &plan)
    {
      // Fields are those of explicit runs, [mesh cycles] as their length.
      const double every = plan.step > 0 ? plan.output->fields_every : 0.;
      if (every <= pair.pair_case.run_meshes())
        return "";
      return sentence_of(4,
                         "field output interval = ",
                         every,
                         " is more than the run's ",
                         pair.pair_case.run_meshes(),
                         " mesh cycles: fields are written at the start and the end only");
    }

    std::string check_checkpoint(const Pair &, const RunPlan &plan)
    {
      if (plan.expected_time < 3600 || plan.output->checkpoint_every > 0)
        return "";
      return "a run of about " + duration_text(plan.expected_time) +
             " without checkpoints (Output/checkpoint interval)";
    }

    std::string check_samples(const Pair &, const RunPlan &plan)
    {
      // A tooth pair's share of a mesh and its harmonics need some points.
      if (plan.output == nullptr || plan.output->history_every >= 10)
        return "";
      return sentence_of(4,
                         "samples per mesh cycle = ",
                         plan.output->history_every,
                         " cannot resolve the ripple: use at least 10");
    }

    std::string check_length(const Pair &pair, const RunPlan &plan)
    {
      constexpr double month = 30. * 24 * 3600;
      if (!(plan.expected_time > month))
        return "";
      // Slow motion or one flat element, as of a small chamfer: the user knows which.
      double height = std::numeric_limits<double>::infinity();
      for (const Body &body : plan.model->bodies)
        height = std::min(height, compute_mesh_quality(body.mesh().triangulation).least_height);
      return sentence_of(
        4,
        "a mesh cycle has ",
        std::round(1. / (pair.pair_case.mesh_frequency() * plan.step)),
        " steps at this speed; the flattest element is ",
        height,
        " mm high. Enlarge it, or use the loaded tooth contact analysis or a reduced pair for slow "
        "motion");
    }

    const std::vector<Check> checks = {&check_flank,
                                       &check_path,
                                       &check_hub,
                                       &check_spin,
                                       &check_hertz,
                                       &check_pressure,
                                       &check_friction,
                                       &check_damping,
                                       &check_damping_rate,
                                       &check_ramp,
                                       &check_torque,
                                       &check_step,
                                       &check_samples,
                                       &check_fields,
                                       &check_length,
                                       &check_checkpoint};
  } // namespace

  // The checks know the case, which knows none of them.
  std::vector<std::string> PairCase::report_checks(const RunPlan &plan, Log &log) const
  {
    // Without a mesh it is a tooth contact analysis, which looks at the path itself.
    const PairFacts known = facts(plan.model != nullptr);
    if (known.pressure)
      {
        log.line("torque on the pinion ",
                 1e-3 * torque_on(0),
                 " N m, on the gear ",
                 1e-3 * torque_on(1),
                 " N m, without friction");
        log.line(known.pressure->describe());
      }
    // Contradictions are said and not refused: a user may want just that.
    std::vector<std::string> found;
    for (const Check check : checks)
      report_conflict(check({*this, known}, plan), found, log);
    if (found.empty())
      log.line("no input conflicts found");
    return found;
  }

  std::string PairCase::find_cause() const
  {
    return describe_excess(*this, facts(false));
  }
} // namespace vfife
