// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/dynamics/operator/mass_scaling.h>
#include <vfife/study/cases/gear_case.h>
#include <vfife/study/run/run_penalties.h>
#include <vfife/study/run/stepped_solver.h>

#include <ostream>

namespace vfife
{
  std::vector<double> find_run_penalties(const GearCase        &gear_case,
                                         const DynamicsOptions &dynamics,
                                         const unsigned int     samples,
                                         const Communicator    &communicator,
                                         Log                   &log)
  {
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
