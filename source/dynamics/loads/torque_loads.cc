// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/loads/torque_loads.h>
#include <vfife/model/load_shares.h>

#include <algorithm>

namespace vfife
{
  TorqueLoads::TorqueLoads(const Model &model, const Partition &partition)
  {
    for (const Torque &torque : model.torques)
      {
        const Body &body = model.bodies[torque.body];
        Load        load{body.axis, torque.value, torque.ramp_time, torque.history, {}};
        // Nodes with this load keep their radius (free rotation, rigid hub), or nearly so: the
        // undeformed one counts.
        const std::vector<double> shares = compute_torque_shares(torque, body);
        for (std::size_t i = 0; i < torque.nodes.size(); ++i)
          {
            const std::uint32_t local = partition.local_node[body.first_node + torque.nodes[i]];
            if (local != Partition::absent && shares[i] > 0)
              load.nodes.push_back({local, partition.owned[local] != 0, shares[i]});
          }
        loads_.push_back(std::move(load));
      }
  }

  void TorqueLoads::add(Load            &load,
                        const double     torque,
                        const NodeField &positions,
                        NodeField       &forces) const
  {
    for (Node &node : load.nodes)
      {
        // F_i = T A_i t_i / sum_j A_j r_j, t_i the tangent at the present place
        const Vector3 r       = positions.value(node.local) - load.axis.point;
        const Vector3 tangent = load.axis.direction.cross(r).normalized();
        node.force            = (torque * node.share) * tangent;
        forces.add(node.local, node.force);
      }
  }

  void TorqueLoads::add_forces(const double time, const NodeField &positions, NodeField &forces)
  {
    for (Load &load : loads_)
      add(load,
          load.value * load.history.value(time) *
            (load.ramp_time > 0 ? std::min(1., time / load.ramp_time) : 1.),
          positions,
          forces);
  }

  void TorqueLoads::add_part(const double part, const NodeField &positions, NodeField &forces)
  {
    for (Load &load : loads_)
      add(load, part * load.value, positions, forces);
  }

  double TorqueLoads::half_power(const NodeField &velocities) const
  {
    double power = 0;
    for (const Load &load : loads_)
      for (const Node &node : load.nodes)
        // Twice a step, with v- and v+: the sum of both is the power with (v- + v+)/2.
        if (node.owned)
          power += 0.5 * node.force.dot(velocities.value(node.local));
    return power;
  }
} // namespace vfife
