// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of ExplicitSolver and its constraints that checkpoints keep.
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/watch/measurement.h>

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
      stream.pass(all);
      if (stream.reads())
        for (const std::uint32_t i : partition.nodes())
          field.set(i, place(i));
    }
  } // namespace

  void ConstraintMotion::exchange(ByteStream &stream, const Partition &partition)
  {
    std::vector<double> angles; // and rates, by node of the model
    const auto          place = [&](const Node &node) {
      return angles.data() + 2 * static_cast<std::size_t>(partition.global_node[node.local]);
    };
    for (Group &group : groups_)
      {
        if (group.kind != ConstraintKind::free_rotation && group.kind != ConstraintKind::rigid_hub)
          continue;
        angles.assign(2 * partition.local_node.size(), 0.);
        for (const Node &node : group.nodes)
          if (!stream.reads() && node.owned)
            {
              place(node)[0] = node.angle;
              place(node)[1] = node.rate;
            }
        if (!stream.reads())
          communicator_.sum(angles);
        stream.pass(angles);
        for (Node &node : group.nodes)
          {
            node.angle = place(node)[0];
            node.rate  = place(node)[1];
          }
      }
  }

  void ExplicitSolver::allocate()
  {
    rigid_.resize(model_.bodies.size());
    rates_at_start_.resize(model_.bodies.size());
    audit_.assign(model_.bodies.size(), DampingAudit());
    sums_.assign(model_.bodies.size(), BodySums());
    damping_.assign(model_.bodies.size(), BodyDamping());
  }

  void ExplicitSolver::exchange(ByteStream &common, ByteStream *own, State &state)
  {
    common.pass(state.time, state.step, state.dt, first_step_, start_time_, state.body_motion);
    pass_vectors(common, state.partition, communicator_, state.position);
    pass_vectors(common, state.partition, communicator_, state.velocity);
    constraints_.exchange(common, state.partition);
    common.pass(ledger_, ledger_at_start_, audited_steps_, audited_samples_);
    common.pass(largest_approach_, has_touched_);
    if (common.reads())
      allocate();
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        common.pass(rigid_[b].velocity, rigid_[b].omega);
        common.pass(rates_at_start_[b].velocity, rates_at_start_[b].omega);
        common.pass(audit_[b].net_torque, audit_[b].power, audit_[b].rate_difference);
      }
    contact_watch_.exchange(common);
    if (own != nullptr)
      contact_.exchange(*own);
    if (!common.reads())
      return;

    set_step(state.dt);
    goes_on_    = true;
    search_now_ = own == nullptr;
    // What a failure before the next measurement would show.
    observed_                 = state;
    observed_.measured.energy = ledger_;
    measure_transmission(model_, observed_, communicator_);
  }
} // namespace vfife
