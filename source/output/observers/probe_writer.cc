// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/observers/probe_writer.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    Table make_table()
    {
      Table table;
      table.add_column("time", "s");
      table.add_text_column("probe");
      for (const char *component : {"r", "theta", "z"})
        table.add_column(std::string("displacement ") + component, "um");
      table.add_column("von mises", "MPa");
      for (const char *component : {"r", "theta", "z", "r theta", "theta z", "z r"})
        table.add_column(std::string("stress ") + component, "MPa");
      return table;
    }
  } // namespace

  ProbeWriter::ProbeWriter(const OutputFolder &folder, const std::uint64_t steps_between)
    : steps_between_(steps_between)
    , table_(make_table())
    , file_(folder, "probes.csv", table_)
  {
  }

  bool ProbeWriter::due(const State &state) const
  {
    return state.step % steps_between_ == 0;
  }

  void ProbeWriter::observe(const Model &model, const State &state)
  {
    // The last state of a run is shown even off the grid of samples, where it would break the equal
    // intervals.
    if (!due(state))
      return;
    const std::size_t n = std::min(model.probes.size(), state.measured.probes.size());
    for (std::size_t p = 0; p < n; ++p)
      {
        const ProbeValue        &value = state.measured.probes[p];
        std::vector<Table::Cell> row   = {state.time, model.probes[p].name};
        for (unsigned int c = 0; c < 3; ++c)
          row.emplace_back(1e3 * value.displacement[c]);
        row.emplace_back(value.von_mises);
        row.insert(row.end(), value.stress.begin(), value.stress.end());
        table_.add_row(row);
      }
    file_.append_new_rows(table_);
  }

  void ProbeWriter::exchange(ByteStream &stream)
  {
    table_.exchange_rows(stream);
    file_.append_new_rows(table_); // a run that goes on writes them again
    file_.flush();
  }

  void ProbeWriter::finish(const Model &, const State &)
  {
    file_.flush();
  }

  const Table &ProbeWriter::table() const
  {
    return table_;
  }
} // namespace vfife
