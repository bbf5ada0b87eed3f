// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/dynamics/operator/mass_scaling.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/model/model.h>
#include <vfife/study/cases/gear_case.h>
#include <vfife/study/pressure/calibrated_penalty.h>
#include <vfife/study/run/pair_start.h>
#include <vfife/study/run/run_penalties.h>
#include <vfife/study/run/stepped_solver.h>

#include <ostream>

namespace vfife
{
  std::shared_ptr<Compliance> settle_penalties(const Case            &the_case,
                                               const DynamicsOptions &dynamics,
                                               const Communicator    &communicator,
                                               Log                   &log,
                                               Model                 &model)
  {
    if (!needs_calibration(the_case, model))
      return nullptr;
    auto compliance = std::make_shared<Compliance>(model,
                                                   make_fem_options(dynamics),
                                                   model.any_body_turns(),
                                                   communicator);
    calibrate_penalty(the_case, *compliance, log, model);
    return compliance;
  }

  std::vector<double> find_run_penalties(const Model           &model_as_it_is,
                                         const GearCase        &gear_case,
                                         const DynamicsOptions &dynamics,
                                         const unsigned int     samples,
                                         const Communicator    &communicator,
                                         Log                   &log)
  {
    std::vector<double> values;
    bool                from_step = false;
    for (const ContactPair &pair : model_as_it_is.contacts)
      {
        values.push_back(pair.options.penalty.value);
        from_step = from_step || pair.options.penalty.from_step;
      }
    if (!from_step)
      return values;
    // Penalties of a run follow from its step and its nodes' masses: the solver of that run is set
    // up and asked. Mass scaling is a matter of the run: it has a model of its own, others keep
    // their masses.
    std::ostream nowhere(nullptr); // the pair has been described
    Log          silent(nowhere, communicator.is_root(), Verbosity::quiet);
    Model        model = gear_case.make_model(silent);
    scale_masses(dynamics, model, log);
    SteppedSolver stepped(model, dynamics, communicator, log, [&](const double stable_step) {
      return gear_case.choose_step(stable_step, samples);
    });
    return stepped.solver.contact().penalties();
  }
} // namespace vfife
