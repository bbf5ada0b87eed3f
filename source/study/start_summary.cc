// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/revision.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/study/start_summary.h>

namespace vfife
{
  RunSummary start_summary(const std::string &study, const Model &model, const OutputFolder &folder)
  {
    // What is known before anything is computed: a summary of a failure has it too.
    RunSummary summary;
    summary.study          = study;
    summary.parameter_file = folder.parameter_file();
    summary.input_digests  = folder.input_digests();
    summary.version        = program_version();
    summary.revision       = program_revision();
    summary.ranks          = folder.communicator().size();
    for (const Body &body : model.bodies)
      summary.bodies.push_back({body.name(),
                                body.n_elements(),
                                body.n_nodes(),
                                body.mass(),
                                body.axial_inertia(),
                                body.rate,
                                body.added_mass()});
    return summary;
  }

  RunSummary start_summary(const std::string  &study,
                           const Model        &model,
                           ExplicitSolver     &solver,
                           const double        dt,
                           const OutputFolder &folder)
  {
    RunSummary summary      = start_summary(study, model, folder);
    summary.instruction_set = solver.vfife_operator().instruction_set();
    summary.dt              = dt;
    return summary;
  }
} // namespace vfife
