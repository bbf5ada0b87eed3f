// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/model/model.h>
#include <vfife/output/observers/probe_writer.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    using Here         = const ProbeSample &;
    using ProbeColumns = SampleColumns<ProbeSample>;

    /** All columns in the order of the file. */
    ProbeColumns list_columns()
    {
      ProbeColumns columns;
      const auto   displacements = column::displacements(column::cylindrical_axes);
      const auto   stresses      = column::stresses(column::cylindrical_axes);
      columns.add_text(column::probe, [](Here here) { return here.name; });
      for (unsigned int c = 0; c < 3; ++c)
        columns.add(displacements[c], "um", [c](Here here) {
          return 1e3 * here.value.displacement[c];
        });
      columns.add(column::von_mises, "MPa", [](Here here) { return here.value.von_mises; });
      for (unsigned int c = 0; c < 6; ++c)
        columns.add(stresses[c], "MPa", [c](Here here) { return here.value.stress[c]; });
      return columns;
    }
  } // namespace

  ProbeWriter::ProbeWriter(const OutputFolder &folder, const std::uint64_t steps_between)
    : SampledTable(folder, "probes.csv", list_columns(), steps_between)
  {
  }

  void ProbeWriter::add_rows(const Model &model, const State &state)
  {
    const std::vector<ProbeValue> &values = state.measured.probes;
    // A row a probe and sample.
    for (std::size_t p = 0; p < std::min(model.probes.size(), values.size()); ++p)
      add_row(state, {model.probes[p].name, values[p]});
  }
} // namespace vfife
