// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/fem/fem_options.h>
#include <vfife/model/model.h>
#include <vfife/output/files/matrix_writer.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/output/observers/rim_writer.h>
#include <vfife/reduced/body_reduction.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/real_body.h>
#include <vfife/reduced/reduced_options.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/study/reduced/pair_reduction.h>
#include <vfife/study/reduced/reduction_store.h>

#include <algorithm>
#include <sstream>

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
               " Hz (pairs with nodal diameters count once), ",
               body.touch_nodes.size(),
               " nodes per sector that may be in contact, residual flexibility beyond ",
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
                                       Log                  &log,
                                       const MoreReadings   &more)
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
        const auto                      start = WallClock::now();
        const Body                     &body  = model.bodies[b];
        const std::vector<unsigned int> nodes = list_touch_nodes(model, b);
        std::vector<SectorReading>      readings =
          list_readings(model, b, stiffness, RimWriter::count_diameters(model));
        if (more)
          for (SectorReading &reading : more(b))
            readings.push_back(std::move(reading));
        const ReductionSource source(model, b, nodes, readings, fem);
        const double          rate = faster * body.rate;
        if (auto kept = store.find(body.name(), source, {2. * pi * cutoff, rate, options.reach}))
          {
            log_body(body.name(), *kept, "from \"" + options.store + "\"", log);
            bodies.push_back(std::move(*kept));
            continue;
          }
        store.require_writable();
        bodies.push_back(reduce_body(
          model, b, nodes, readings, fem, {2. * pi * cutoff, options.reach}, rate, communicator));
        log_body(body.name(), bodies.back(), duration_text(seconds_since(start)), log);
        store.keep(body.name(), source, bodies.back());
      }
    return bodies;
  }

  double find_kept_cutoff(const std::vector<ReducedBody> &bodies)
  {
    double cutoff = 0;
    for (const ReducedBody &body : bodies)
      cutoff = std::max(cutoff, .5 / pi * body.cutoff);
    return cutoff;
  }

  void export_bodies(const std::vector<ReducedBody> &bodies,
                     const Model                    &model,
                     const OutputFolder             &folder)
  {
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const std::string name = model.bodies[b].name() + "_";
        const RealBody    real = make_real_body(bodies[b], model, b);
        const auto        write =
          [&](const char *const what, const Eigen::MatrixXd &matrix, const std::string &meaning) {
            write_matrix_market(folder, name + what + ".mtx", matrix, meaning);
          };
        std::ostringstream rate;
        rate << bodies[b].rate;
        write("mass", real.mass, "M of M x'' + 2 Omega G x' + (K + (Omega^2 - Omega_0^2) D) x = f");
        write("stiffness", real.stiffness, "K at Omega_0 = " + rate.str() + " rad/s");
        write("coriolis", real.coriolis, "G, antisymmetric");
        write("spin_stiffness", real.spin_stiffness, "D");
        write("shapes", real.shapes, "values of " + name + "rows.csv from x");
        write("residual",
              real.residual,
              "mm/N: flank nodes, residual displacement under forces on them");
        write("torque", real.torque, "f of a torque of 1 N mm about the axis of rotation");
        if (real.seats.size() > 0)
          write("seat_stiffness",
                real.seats,
                "springs of the bearings' seats that " + name + "stiffness.mtx contains");
        write_csv(folder, name + "coordinates.csv", real.coordinates);
        write_csv(folder, name + "rows.csv", real.rows);
      }
  }
} // namespace vfife
