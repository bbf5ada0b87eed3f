// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/output/output_options.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/cases/model_case.h>
#include <vfife/study/cases/run_length.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    void log_bodies(const Model &model, Log &log)
    {
      for (const Body &body : model.bodies)
        {
          for (const std::string &warning : body.mesh().warnings)
            log.warning("body \"", body.name(), "\": ", warning);
          for (const std::string &note : body.mesh().notes)
            log.line(body.name(), ": ", note);
          const MeshQuality quality = compute_mesh_quality(body.mesh().triangulation);
          log.line(body.name(),
                   ": ",
                   quality.cells,
                   " elements, ",
                   quality.nodes,
                   " nodes, mass ",
                   1e3 * body.mass(),
                   " kg, least scaled Jacobian ",
                   quality.least_scaled_jacobian,
                   ", least edge ",
                   quality.least_edge,
                   " mm");
        }
    }

    /** Says where the last sample is if it is a noticeable part of the run before its end: the last
     * values of histories are then not those at the end. */
    std::string describe_last_sample(const RunTimes &times, const double step)
    {
      constexpr double    noticeable = 0.01;
      const std::uint64_t n_steps    = std::llround(times.end / step),
                          rest       = n_steps % times.sample_steps;
      if (rest <= noticeable * n_steps)
        return "";
      return sentence_of(4,
                         "Output/steps per sample: the last sample is at ",
                         1e3 * (n_steps - rest) * step,
                         " ms, the run ends at ",
                         1e3 * n_steps * step,
                         " ms. Choose a divisor of its ",
                         n_steps,
                         " steps");
    }
  } // namespace

  void ModelCase::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    options_.declare(prm, file);
  }

  void ModelCase::check() const
  {
    options_.check();
  }

  Model ModelCase::make_model(Log &log) const
  {
    Model model = options_.make_model();
    log_bodies(model, log);
    options_.log_probes(model, log);
    log_parts(model, log);
    warn_of_materials(model, log);
    return model;
  }

  void ModelCase::set_defaults(DynamicsOptions &dynamics, OutputOptions &output) const
  {
    // A general model moves as it is told: no start of a gear pair, no dampers.
    dynamics.start        = Start::undeformed;
    dynamics.damping      = 0;
    dynamics.mesh_damping = 0;
    output.fields_every   = 0;
    output.of_model       = true;
  }

  void ModelCase::declare_run(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Dynamics");
    declare_quantity(
      prm, "end time", end_time_, "s", "Time at the end of the run", Range::not_negative());
  }

  void ModelCase::check_dynamics(const DynamicsOptions &dynamics) const
  {
    if (dynamics.start == Start::ramp || dynamics.start == Start::steady_swing)
      throw InputError(
        "Dynamics/start",
        "expected \"undeformed\" or \"static equilibrium\" for a model of the section "
        "Model, got a start for gear pairs");
    if (dynamics.mesh_damping > 0)
      throw InputError("Dynamics/driven speed damping",
                       "requires a gear pair, got a model without one");
  }

  void ModelCase::check_run(const DynamicsOptions &dynamics) const
  {
    check_dynamics(dynamics);
    if (!(end_time_ > 0))
      throw InputError("Dynamics/end time", "expected a positive end time, got none");
  }

  double ModelCase::end_time() const
  {
    return end_time_;
  }

  double ModelCase::choose_step(const double stable_step, const unsigned int) const
  {
    // T/ceil(T/dt_s): the last step ends at the end time.
    return end_time_ / std::ceil(end_time_ / stable_step);
  }

  std::vector<std::string> ModelCase::report_checks(const RunPlan &plan, Log &log) const
  {
    std::vector<std::string> found;
    if (plan.step > 0)
      report_conflict(
        describe_last_sample(plan_times(*this, *plan.dynamics, *plan.output, nullptr, plan.step),
                             plan.step),
        found,
        log);
    return found;
  }
} // namespace vfife
