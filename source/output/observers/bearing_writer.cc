// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/bearing_writer.h>

namespace vfife
{
  BearingWriter::BearingWriter(const OutputFolder &folder, const std::uint64_t steps_between)
    : SampledTable(folder, "bearings.csv", list_bearing_columns(), steps_between)
  {
  }

  void BearingWriter::add_rows(const Model &model, const State &state)
  {
    for (std::size_t b = 0; b < model.bearings.size(); ++b)
      add_row(state, {model.bearings[b].name, state.measured.bearings.at(b)});
  }

  void write_bearing_curves(const OutputFolder &folder, const std::vector<Bearing> &bearings)
  {
    const Table curves = make_bearing_curves(bearings);
    if (curves.n_rows() > 0)
      write_csv(folder, "bearing_curves.csv", curves);
  }

  MisalignmentWriter::MisalignmentWriter(const OutputFolder &folder,
                                         const Model        &model,
                                         const std::uint64_t steps_between,
                                         RingMotions         motion_of)
    : SampledTable(folder, "misalignment.csv", list_mounting_columns(), steps_between)
    , folder_(folder)
    , mounting_(model)
    , motion_of_(std::move(motion_of))
  {
  }

  void MisalignmentWriter::add_rows(const Model &, const State &state)
  {
    add_row(state,
            motion_of_ ? mounting_.measure(motion_of_)
                       : mounting_.measure(state, folder_.communicator()));
  }
} // namespace vfife
