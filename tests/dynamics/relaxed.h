// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_dynamics_relaxed_h
#define vfife_tests_dynamics_relaxed_h

#include "one_solver.h"

#include <vfife/dynamics/equilibrium/relaxation.h>

/** Takes the state of @p run to equilibrium under the loads of time zero and centrifugal force. */
inline vfife::RelaxationReport relax(const vfife::Model &model, OneSolver &run)
{
  vfife::Relaxation relaxation(model,
                               run.options.relaxation,
                               run.solver.vfife_operator(),
                               run.solver.contact(),
                               run.solver.walls(),
                               run.communicator,
                               run.log);
  return relaxation.solve(run.state, vfife::Relaxation::Loads());
}

#endif
