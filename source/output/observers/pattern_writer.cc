// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/sample_columns.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/pattern_writer.h>

#include <algorithm>
#include <map>

namespace vfife
{
  namespace
  {
    /** A place of a flank: a row of pattern.csv. */
    struct Place
    {
      const std::string &body, &side;
      Vector2            r_z;              ///< [mm]
      double             largest_pressure; ///< [MPa]
    };

    /** All columns in the order of the file. */
    SampleColumns<Place> list_columns()
    {
      SampleColumns<Place> columns;
      columns.add_text("body", [](const Place &place) { return place.body; });
      columns.add_text(column::side, [](const Place &place) { return place.side; });
      columns.add("r", "mm", [](const Place &place) { return place.r_z[0]; });
      columns.add("z", "mm", [](const Place &place) { return place.r_z[1]; });
      columns.add(column::largest_pressure, "MPa", [](const Place &place) {
        return place.largest_pressure;
      });
      return columns;
    }
  } // namespace

  PatternWriter::PatternWriter(const OutputFolder &folder,
                               const Model        &model,
                               const double        start,
                               const std::uint64_t steps_between)
    : folder_(folder)
    , start_(start)
    , steps_between_(steps_between)
  {
    for (const ContactPair &pair : model.contacts)
      {
        flanks_.push_back(make_flank(model, pair.slave_body, pair.slave_surface, pair.side));
        flanks_.push_back(make_flank(model, pair.master_body, pair.master_surface, pair.side));
      }
  }

  PatternWriter::Flank PatternWriter::make_flank(const Model       &model,
                                                 const unsigned int b,
                                                 const std::string &surface,
                                                 const std::string &side)
  {
    // Nodes of all teeth with their areas.
    const Body &body = model.bodies[b];
    Flank       flank;
    flank.body  = b;
    flank.side  = side;
    flank.nodes = body.mesh().surfaces.at(surface).nodes;
    flank.areas = compute_nodal_areas(body, flank.nodes);

    // Node i of the first sector is node i + k n of sector k.
    const unsigned int                   n = nodes_per_sector(body);
    std::map<unsigned int, unsigned int> place_of;
    for (const unsigned int node : flank.nodes)
      {
        const auto [place, is_new] =
          place_of.emplace(node % n, static_cast<unsigned int>(flank.r_z.size()));
        flank.places.push_back(place->second);
        if (is_new)
          {
            const Vector3 &x = body.node_positions()[node];
            // Radius and height are the same on all teeth: a place of the flank, seen on each of
            // them.
            flank.r_z.emplace_back(x.head<2>().norm(), x[2]);
          }
      }
    flank.largest_pressure.assign(flank.r_z.size(), 0.);
    return flank;
  }

  bool PatternWriter::due(const State &state) const
  {
    // Half a step of tolerance for the round-off of the time.
    return state.time > start_ - 0.5 * state.dt && state.step % steps_between_ == 0;
  }

  void PatternWriter::observe(const Model &model, const State &state)
  {
    // The largest pressure so far at each place, of this rank's nodes.
    if (!due(state) || state.contact_force.empty())
      return;
    for (Flank &flank : flanks_)
      for (std::size_t i = 0; i < flank.nodes.size(); ++i)
        {
          const std::uint32_t local =
            state.partition->local_node[model.bodies[flank.body].first_node + flank.nodes[i]];
          if (local == Partition::absent || !(flank.areas[i] > 0))
            continue;
          const double force   = state.contact_force.value(local).norm();
          double      &largest = flank.largest_pressure[flank.places[i]];
          largest              = std::max(largest, force / flank.areas[i]);
        }
  }

  std::string PatternWriter::part_name() const
  {
    return "pattern";
  }

  void PatternWriter::serialize(ByteStream &stream)
  {
    // With the start of the last tooth mesh, so that a run that goes on knows which one it was.
    double start = start_;
    stream.pass(start);
    for (Flank &flank : flanks_)
      {
        std::vector<double> largest = flank.largest_pressure;
        // Each rank has seen its own nodes only.
        if (!stream.reads())
          folder_.communicator().max(largest);
        stream.pass_known(largest);
        // A run that is made longer has another last tooth mesh.
        if (stream.reads() && start == start_)
          flank.largest_pressure = largest;
      }
  }

  void PatternWriter::finish(const Model &model, const State &)
  {
    const SampleColumns<Place> columns = list_columns();
    Table                      table;
    columns.add_to(table);
    for (Flank &flank : flanks_)
      {
        folder_.communicator().max(flank.largest_pressure);
        for (std::size_t i = 0; i < flank.r_z.size(); ++i)
          table.add_row(columns.cells_of({model.bodies[flank.body].name(),
                                          flank.side,
                                          flank.r_z[i],
                                          flank.largest_pressure[i]}));
      }
    write_csv(folder_, "pattern.csv", table);
  }
} // namespace vfife
