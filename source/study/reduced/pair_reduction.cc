// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/fem/fem_options.h>
#include <vfife/model/model.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/observers/rim_writer.h>
#include <vfife/reduced/body_reduction.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/reduced_options.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/study/reduced/pair_reduction.h>
#include <vfife/study/reduced/reduction_store.h>

namespace vfife
{
  namespace
  {
    void
    log_body(const std::string &name, const ReducedBody &body, const std::string &origin, Log &log)
    {
      log.line(name,
               ": ",
               body.n_modes(),
               " modes below ",
               .5 / pi * body.cutoff,
               " Hz (with nodal diameters count once), ",
               body.touch_nodes.size(),
               " nodes a sector that may touch, residual flexibility beyond ",
               body.reach,
               " sectors at most ",
               100. * body.residual_left,
               " % of the largest, ",
               origin);
    }
  } // namespace

  std::vector<ReducedBody> reduce_pair(const Model          &model,
                                       const ReducedOptions &options,
                                       const StiffnessKind   stiffness,
                                       const double          cutoff,
                                       const double          faster,
                                       const Communicator   &communicator,
                                       Log                  &log)
  {
    require_reducible(model);
    FemOptions fem;
    fem.mass = MassKind::lumped; // as the mass points of a run
    fem.element =
      stiffness == StiffnessKind::full ? FemElement::full : FemElement::incompatible_modes;
    const ReductionStore     store(options.store, communicator, log);
    std::vector<ReducedBody> bodies;
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const auto                       start = WallClock::now();
        const Body                      &body  = model.bodies[b];
        const std::vector<unsigned int>  nodes = list_touch_nodes(model, b);
        const std::vector<SectorReading> readings =
          list_readings(model, b, stiffness, RimWriter::count_diameters(model));
        const ReductionSource source(model, b, nodes, readings, fem);
        const double          rate = faster * body.rate;
        if (auto kept = store.find(body.name(), source, {2. * pi * cutoff, rate, options.reach}))
          {
            log_body(body.name(), *kept, "from \"" + options.store + "\"", log);
            bodies.push_back(std::move(*kept));
            continue;
          }
        bodies.push_back(reduce_body(
          model, b, nodes, readings, fem, {2. * pi * cutoff, options.reach}, rate, communicator));
        log_body(body.name(), bodies.back(), duration_text(seconds_since(start)), log);
        store.keep(body.name(), source, bodies.back());
      }
    return bodies;
  }
} // namespace vfife
