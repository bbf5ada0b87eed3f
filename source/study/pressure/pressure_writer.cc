// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/pressure/instant_options.h>
#include <vfife/study/pressure/pressure_depth.h>
#include <vfife/study/pressure/pressure_writer.h>

#include <algorithm>
#include <utility>

namespace vfife
{
  FlankReader gather_flanks(const Model &model, const Communicator &communicator)
  {
    return [&model, &communicator](const State &state) {
      const ContactPair                &pair     = model.contacts.front();
      const std::array<unsigned int, 2> bodies   = {{pair.slave_body, pair.master_body}};
      const std::array<std::string, 2>  surfaces = {{pair.slave_surface, pair.master_surface}};
      FlankState                        flanks;
      for (unsigned int side = 0; side < 2; ++side)
        {
          // Each node on the rank that owns it, zero on the others: the sum is known to all.
          const Body          &body  = model.bodies[bodies[side]];
          const auto          &nodes = body.mesh().surfaces.at(surfaces[side]).nodes;
          std::vector<double> &x = flanks.positions[side], &f = flanks.forces[side];
          x.assign(3 * nodes.size(), 0.);
          f = x;
          for (std::size_t i = 0; i < nodes.size(); ++i)
            {
              const std::uint32_t local = state.partition->find_owned(body.first_node + nodes[i]);
              if (local == Partition::absent)
                continue;
              Eigen::Map<Vector3>(x.data() + 3 * i) = state.node_position(local);
              Eigen::Map<Vector3>(f.data() + 3 * i) = state.contact_force.value(local);
            }
          communicator.sum(x);
          communicator.sum(f);
          flanks.motions[side] = state.body_motion[bodies[side]];
        }
      return flanks;
    };
  }

  PairRun describe_run(const PairCase &pair_case, const Model &model, const double end_time)
  {
    return {model, pair_case.outlines(), pair_case.hertz_contact(), end_time};
  }

  void
  check_pressures(const InstantOptions &options, const FemOptions &elements, const PairRun &run)
  {
    options.find_times(*run.model.only_transmission(), run.end_time);
    InstantPressure::check(run.model,
                           elements,
                           choose_pressure_depth(options.depth, run.model, run.hertz));
  }

  PressureWriter::PressureWriter(const OutputFolder   &folder,
                                 const InstantOptions &options,
                                 const FemOptions     &elements,
                                 const PairRun        &run,
                                 FlankReader           read_flanks,
                                 Log                  &log)
    : times_(options.find_times(*run.model.only_transmission(), run.end_time))
    , read_flanks_(std::move(read_flanks))
    , log_(log)
    , pressure_(run.model,
                elements,
                choose_pressure_depth(options.depth, run.model, run.hertz),
                options.cells,
                folder.communicator())
    , tables_(run.model, run.outlines, PressureRows::instants)
    , teeth_file_(folder, "pressure.csv", tables_.teeth())
    , cells_file_(folder, "pressure_field.csv", tables_.cells())
  {
    log.line("pressures on their own grids at ", times_.size(), " instants");
  }

  bool PressureWriter::due(const State &state) const
  {
    // In the step that is nearest.
    return done_ < times_.size() && times_[done_] <= state.time + .5 * state.dt;
  }

  void PressureWriter::observe(const Model &model, const State &state)
  {
    if (!due(state))
      return;
    while (due(state))
      ++done_;
    const auto                       start = WallClock::now();
    const std::vector<ToothPressure> teeth = find_pressures(model, state);
    const double                     at    = model.only_transmission()->meshes(state.time);
    tables_.add({at, state.measured.transmission_error / arcsecond, state.time}, teeth);
    teeth_file_.append_new_rows(tables_.teeth());
    cells_file_.append_new_rows(tables_.cells());
    double largest = 0;
    for (const ToothPressure &tooth : teeth)
      largest = std::max(largest, tooth.grid.pressures[tooth.grid.largest()]);
    log_.line("pressure on its own grid after ",
              at,
              " mesh cycles: ",
              teeth.size(),
              " teeth, largest ",
              largest,
              " MPa, ",
              seconds_since(start),
              " s");
  }

  std::vector<ToothPressure> PressureWriter::find_pressures(const Model &model, const State &state)
  {
    pressure_.place(read_flanks_(state));
    std::vector<ToothPressure> teeth;
    for (const ToothContact &tooth : state.measured.teeth)
      {
        // The other side of the teeth rattles at most.
        if (tooth.contact != 0)
          continue;
        // A run is not given up for what is only looked at.
        try
          {
            teeth.push_back(
              pressure_.solve(tooth.slave_group, tooth.master_group, tooth.normal_force));
          }
        catch (const NumericalError &error)
          {
            log_.warning("no pressure on its own grid after ",
                         model.only_transmission()->meshes(state.time),
                         " mesh cycles, teeth ",
                         tooth.slave_group,
                         " and ",
                         tooth.master_group,
                         ", ",
                         tooth.force.norm(),
                         " N: ",
                         error.what());
          }
      }
    return teeth;
  }

  std::string PressureWriter::part_name() const
  {
    return "pressures";
  }

  void PressureWriter::serialize(ByteStream &stream)
  {
    stream.pass_required_part("instants", [this](ByteStream &part) { part.pass(done_); });
    stream.pass_required_part("teeth",
                              [this](ByteStream &part) { tables_.teeth().serialize_rows(part); });
    stream.pass_required_part("cells",
                              [this](ByteStream &part) { tables_.cells().serialize_rows(part); });
    if (stream.reads())
      {
        teeth_file_.rewrite(tables_.teeth());
        cells_file_.rewrite(tables_.cells());
      }
  }

  void PressureWriter::finish(const Model &, const State &)
  {
    teeth_file_.finish(tables_.teeth());
    cells_file_.finish(tables_.cells());
    if (done_ < times_.size())
      log_.line(times_.size() - done_, " instants for pressures lie after the end");
  }
} // namespace vfife
