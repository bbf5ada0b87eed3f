// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A build without algebraic multigrid refuses both iterative solvers and has the others.
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/mesh/primitives/primitives.h>

using namespace vfife;

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  Model      model;
  model.add_body(Body("block", make_block(Vector3(10., 2., 2.), {{5, 2, 2}}), {}));
  model.constraints.push_back({"end", ConstraintKind::held, 0, model.bodies[0].node_set("x-")});
  StaticLoads loads;
  loads.body_force = [](const Vector3 &) { return Vector3(1., 0., 0.); };
  FemOptions options;
  options.n_modes = 2;
  for (const bool iterative : {true, false})
    {
      options.linear_solver = iterative ? LinearSolverKind::multigrid : LinearSolverKind::direct;
      options.eigen_solver  = iterative ? EigenSolverKind::lobpcg : EigenSolverKind::shift_invert;
      const std::string expected =
        iterative ? "Fem/linear solver, Fem/eigenvalue solver: expected \"direct\", "
                    "\"shift-invert\", got \"multigrid\" or \"lobpcg\". deal.II of this build has "
                    "no algebraic multigrid (PreconditionAMG by Epetra and ML of Trilinos). Choose "
                    "\"direct\" and \"shift-invert\", or build vfife with such a deal.II."
                  : "";
      const std::string name = iterative ? "is refused" : "is accepted";
      check("static solver " + name,
            message_of([&] { StaticSolver(model, {0}, options, session.world()).solve(loads); }) ==
              expected);
      check("eigenvalue solver " + name,
            message_of([&] { RotatingBody(model, 0, options, session.world()).find_modes(0.); }) ==
              expected);
    }
  return check_counts().failed > 0 ? 1 : 0;
}
