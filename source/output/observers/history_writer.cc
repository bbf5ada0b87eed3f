// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/observers/history_writer.h>

namespace vfife
{
  namespace
  {
    constexpr double degree = pi / 180;

    /** Momenta and probes, which in a gear pair have files and figures of their own. */
    void add_model_columns(const Model &model, Table &table)
    {
      for (const char *axis : {"x", "y", "z"})
        table.add_column(std::string("momentum ") + axis, "N s");
      for (const char *axis : {"x", "y", "z"})
        table.add_column(std::string("angular momentum ") + axis, "N mm s");
      for (const Probe &probe : model.probes)
        {
          const std::vector<std::string> axes = probe.fixed_axes
                                                  ? std::vector<std::string>{"x", "y", "z"}
                                                  : std::vector<std::string>{"r", "theta", "z"};
          for (const std::string &axis : axes)
            table.add_column(probe.name + " displacement " + axis, "mm");
          for (unsigned int c = 0; c < 6; ++c)
            table.add_column(probe.name + " stress " +
                               (c < 3 ? axes[c] : axes[c - 3] + " " + axes[(c - 2) % 3]),
                             "MPa");
          table.add_column(probe.name + " von mises", "MPa");
        }
    }

    void add_model_cells(const Measurements &now, std::vector<Table::Cell> &row)
    {
      row.insert(row.end(), now.momentum.data(), now.momentum.data() + 3);
      row.insert(row.end(), now.angular_momentum.data(), now.angular_momentum.data() + 3);
      for (const ProbeValue &value : now.probes)
        {
          row.insert(row.end(), value.displacement.data(), value.displacement.data() + 3);
          row.insert(row.end(), value.stress.begin(), value.stress.end());
          row.emplace_back(value.von_mises);
        }
    }

    Table make_table(const Model &model)
    {
      Table table;
      table.add_column("time", "s");
      if (model.transmission)
        {
          table.add_column(model.bodies[model.transmission->driver].name() + " angle", "deg");
          table.add_column(model.bodies[model.transmission->driven].name() + " angle", "deg");
          table.add_column("dte", "arcsec");
          table.add_column("rim dte", "arcsec");
        }
      table.add_column("contact force total", "N");
      if (model.transmission)
        {
          table.add_column("contact torque on the " +
                             model.bodies[model.transmission->driven].name(),
                           "N m");
          table.add_column("teeth in contact", "-");
        }
      table.add_column("largest penetration", "um");
      for (const char *energy : {"kinetic energy",
                                 "relative kinetic energy",
                                 "strain energy",
                                 "contact energy",
                                 "work of the drive",
                                 model.transmission ? "work of the torques" : "work of the loads",
                                 "damping loss",
                                 "mesh damping loss",
                                 "contact loss"})
        table.add_column(energy, "mJ");
      table.add_column("energy error", "-");
      if (!model.transmission)
        add_model_columns(model, table);
      return table;
    }
  } // namespace

  HistoryWriter::HistoryWriter(const OutputFolder &folder,
                               const Model        &model,
                               const std::uint64_t steps_between)
    : steps_between_(steps_between)
    , table_(make_table(model))
    , file_(folder, "history.csv", table_)
  {
  }

  bool HistoryWriter::due(const State &state) const
  {
    return state.step % steps_between_ == 0;
  }

  void HistoryWriter::observe(const Model &model, const State &state)
  {
    // The last state of a run is shown even off the grid of samples, where it would break the equal
    // intervals.
    if (!due(state))
      return;
    const Measurements      &now = state.measured;
    std::vector<Table::Cell> row = {state.time};
    if (model.transmission)
      row.insert(row.end(),
                 {now.driver_angle / degree,
                  now.driven_angle / degree,
                  now.transmission_error / arcsecond,
                  now.rim_transmission_error / arcsecond});
    row.emplace_back(now.contact_force);
    if (model.transmission)
      row.insert(row.end(), {1e-3 * now.contact_torque, now.teeth_in_contact});
    row.emplace_back(1e3 * now.largest_penetration);
    row.insert(row.end(),
               {now.energy.kinetic,
                now.energy.kinetic_relative,
                now.energy.strain,
                now.energy.contact,
                now.energy.drive_work,
                now.energy.torque_work,
                now.energy.damping_loss,
                now.energy.mesh_damping_loss,
                now.energy.contact_loss,
                now.energy.error()});
    if (!model.transmission)
      add_model_cells(now, row);
    table_.add_row(row);
    file_.append_new_rows(table_);
  }

  void HistoryWriter::exchange(ByteStream &stream)
  {
    table_.exchange_rows(stream);
    file_.append_new_rows(table_); // a run that goes on writes them again
    file_.flush();
  }

  void HistoryWriter::finish(const Model &, const State &)
  {
    file_.flush();
  }

  const Table &HistoryWriter::table() const
  {
    return table_;
  }
} // namespace vfife
