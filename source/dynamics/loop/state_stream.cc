// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loop/state_stream.h>
#include <vfife/model/state.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Passes the vectors of a field by node of the model. */
    void pass_vectors(ByteStream         &stream,
                      const Partition    &partition,
                      const Communicator &communicator,
                      NodeField          &field)
    {
      std::vector<double> all(3 * partition.local_node.size(), 0.);
      const auto          place = [&](const std::uint32_t local) {
        return Eigen::Map<Vector3>(all.data() +
                                   3 * static_cast<std::size_t>(partition.global_node[local]));
      };
      if (!stream.reads())
        {
          for (const std::uint32_t i : partition.owned_nodes())
            place(i) = field.value(i);
          communicator.sum(all); // one owner a node: adding the others' zeros changes no digit
        }
      stream.pass_known(all);
      const auto is_finite = [](const double number) { return std::isfinite(number); };
      if (stream.reads())
        stream.require(std::all_of(all.begin(), all.end(), is_finite),
                       "a coordinate or velocity is not finite");
      if (stream.reads())
        for (const std::uint32_t i : partition.nodes())
          field.set(i, place(i));
    }

    /** A run goes on from time and step of its beginning in equal steps. */
    void check_times(const ByteStream &stream, const RunBeginning &beginning, const State &state)
    {
      stream.require(std::isfinite(state.dt) && state.dt > 0 && state.step >= beginning.step,
                     "the time step is not valid");
      const double steps = static_cast<double>(state.step - beginning.step);
      stream.require(std::abs(state.time - beginning.time - steps * state.dt) <=
                       1e-9 * (std::abs(state.time) + state.dt),
                     "the time does not match the step");
    }
  } // namespace

  void pass_state(ByteStream         &stream,
                  const Communicator &communicator,
                  RunBeginning       &beginning,
                  State              &state)
  {
    stream.pass(beginning.step, beginning.time, state.time, state.step, state.dt);
    check_times(stream, beginning, state);
    stream.pass_known(state.body_motion);
    pass_vectors(stream, *state.partition, communicator, state.position);
    pass_vectors(stream, *state.partition, communicator, state.velocity);
  }
} // namespace vfife
