// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/model/model.h>
#include <vfife/output/observers/probe_writer.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    using Here = const ProbeSample &;

    /** All columns in the order of the file; displacements are in um. */
    SampleColumns<ProbeSample> list_columns()
    {
      SampleColumns<ProbeSample> columns;
      columns.add_text(column::probe, [](Here here) { return here.name; });
      for (const ProbeQuantity &quantity : list_probe_quantities(column::cylindrical_axes))
        {
          const bool is_length = quantity.kind == ProbeQuantityKind::displacement;
          columns.add(quantity.name,
                      is_length ? "um" : quantity.unit,
                      [value = quantity.value, factor = is_length ? 1e3 : 1.](Here here) {
                        return factor * value(here.value);
                      });
        }
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
