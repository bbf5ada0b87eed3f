// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/observers/teeth_writer.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    bool is_known(const HertzContact &hertz)
    {
      return hertz.largest_pressure(1.) > 0;
    }

    Table make_table(const Model &model, const HertzContact &hertz)
    {
      Table table;
      table.add_column("time", "s");
      table.add_text_column("side");
      const auto &t = model.transmission;
      table.add_column(t ? model.bodies[t->driver].name() + " tooth" : "slave group", "-");
      table.add_column(t ? model.bodies[t->driven].name() + " tooth" : "master group", "-");
      table.add_column("force", "N");
      table.add_column("torque", "N m");
      table.add_column("largest pressure", "MPa");
      table.add_column("area", "mm^2");
      table.add_column("mean pressure", "MPa");
      if (is_known(hertz))
        table.add_column("hertz pressure", "MPa");
      return table;
    }

    /** Whether the slave surface of that side belongs to the driven member. */
    bool is_driven_slave(const Model &model, const std::string &side)
    {
      if (!model.transmission)
        return false;
      const auto pair = std::find_if(model.contacts.begin(),
                                     model.contacts.end(),
                                     [&side](const ContactPair &p) { return p.side == side; });
      return pair != model.contacts.end() && pair->slave_body == model.transmission->driven;
    }
  } // namespace

  TeethWriter::TeethWriter(const OutputFolder &folder,
                           const Model        &model,
                           const std::uint64_t steps_between,
                           const HertzContact &hertz)
    : steps_between_(steps_between)
    , hertz_(hertz)
    , table_(make_table(model, hertz))
    , file_(folder, "teeth.csv", table_)
  {
  }

  bool TeethWriter::due(const State &state) const
  {
    return state.step % steps_between_ == 0;
  }

  void TeethWriter::observe(const Model &model, const State &state)
  {
    // The last state of a run is shown even off the grid of samples, where it would break the equal
    // intervals.
    if (!due(state))
      return;
    for (const ToothContact &contact : state.measured.teeth)
      {
        unsigned int pinion_tooth = contact.slave_group, gear_tooth = contact.master_group;
        if (is_driven_slave(model, contact.side))
          std::swap(pinion_tooth, gear_tooth);
        std::vector<Table::Cell> row = {state.time,
                                        contact.side,
                                        pinion_tooth,
                                        gear_tooth,
                                        contact.force.norm(),
                                        1e-3 * contact.torque,
                                        contact.largest_pressure,
                                        contact.area,
                                        contact.area > 0 ? contact.normal_force / contact.area
                                                         : 0.};
        if (is_known(hertz_))
          row.emplace_back(hertz_.largest_pressure(contact.normal_force));
        table_.add_row(row);
      }
    file_.append_new_rows(table_);
  }

  void TeethWriter::exchange(ByteStream &stream)
  {
    table_.exchange_rows(stream);
    file_.append_new_rows(table_); // a run that goes on writes them again
    file_.flush();
  }

  void TeethWriter::finish(const Model &, const State &)
  {
    file_.flush();
  }

  const Table &TeethWriter::table() const
  {
    return table_;
  }
} // namespace vfife
