// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/element/stress.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/model/model.h>
#include <vfife/output/observers/part_stress_watch.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/study/reduced/start_stresses.h>
#include <vfife/study/run/pair_start.h>

#include <optional>

namespace vfife
{
  NamedFigures find_start_stresses(const Model        &model,
                                   const FemOptions   &fem,
                                   Compliance         *compliance,
                                   const Communicator &communicator,
                                   Log                &log)
  {
    const auto   start = WallClock::now();
    PartStresses parts(model);
    try
      {
        std::optional<Compliance> own;
        if (compliance == nullptr)
          compliance = &own.emplace(model, fem, model.any_body_turns(), communicator);
        PairEquilibrium           equilibrium(model, *compliance, {0.});
        const std::vector<double> u        = equilibrium.solve(0., 1.).displacements;
        const std::vector<Stress> stresses = compute_node_stresses(compliance->space(), u);
        parts.look([&](const unsigned int node) { return von_mises(stresses[node]); });
      }
    catch (const NumericalError &error)
      {
        log.line("largest stresses at the start: not available, ", error.what());
        return {};
      }
    log.line("largest stresses at rest in the first position, found in ",
             duration_text(seconds_since(start)),
             "; for all positions use kind loaded tooth contact analysis, with vibration kind run");
    parts.write_to(log);
    NamedFigures figures;
    for (const auto &[name, figure] : parts.list_figures())
      figures.push_back({"at the start, " + name, figure});
    return figures;
  }
} // namespace vfife
