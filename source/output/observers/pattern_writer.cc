// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/pattern_writer.h>

namespace vfife
{
  PatternWriter::PatternWriter(const OutputFolder &folder,
                               const Model        &model,
                               const double        start,
                               const std::uint64_t steps_between)
    : folder_(folder)
    , start_(start)
    , steps_between_(steps_between)
    , pattern_(model)
  {
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
    pattern_.add([&](const unsigned int body, const unsigned int node) {
      const std::uint32_t local = state.partition->local_node[model.bodies[body].first_node + node];
      return local == Partition::absent ? 0. : state.contact_force.value(local).norm();
    });
  }

  std::string PatternWriter::part_name() const
  {
    return "pattern";
  }

  void PatternWriter::serialize(ByteStream &stream)
  {
    // With the start of the last mesh cycle, so that a run that goes on knows which one it was.
    double start = start_;
    stream.pass(start);
    for (ContactPattern::Flank &flank : pattern_.flanks())
      {
        std::vector<double> largest = flank.largest_pressure;
        // Each rank has seen its own nodes only.
        if (!stream.reads())
          folder_.communicator().max(largest);
        stream.pass_known(largest);
        // A run that is made longer has another last mesh cycle.
        if (stream.reads() && start == start_)
          flank.largest_pressure = largest;
      }
  }

  void PatternWriter::finish(const Model &model, const State &)
  {
    for (ContactPattern::Flank &flank : pattern_.flanks())
      folder_.communicator().max(flank.largest_pressure);
    write_csv(folder_, "pattern.csv", pattern_.table(model));
  }
} // namespace vfife
