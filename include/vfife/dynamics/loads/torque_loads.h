// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_torque_loads_h
#define vfife_dynamics_loads_torque_loads_h

#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  /**
   * Torques as tangential forces of constant traction: F_i = T A_i t_i / sum_j A_j r_j, which
   * follow the moving nodes.
   */
  class TorqueLoads
  {
  public:
    TorqueLoads(const Model &model, const Partition &partition);

    /** Adds the forces at @p time to @p forces (all copies of a node); remembers them for
     * half_power(). */
    void add_forces(double time, const NodeField &positions, NodeField &forces);

    /** The same with @p part of the full torque whatever the time. */
    void add_part(double part, const NodeField &positions, NodeField &forces);

    /** Half of the power of the remembered forces with these velocities on this rank [mJ/s]: called
     * before and after the update. */
    double half_power(const NodeField &velocities) const;

  private:
    struct Node
    {
      std::uint32_t local;
      bool          owned;
      double        share; ///< compute_torque_shares() [1/mm]
      Vector3       force = Vector3::Zero();
    };
    struct Load
    {
      Axis              axis;
      double            value, ramp_time;
      ParameterHistory  history;
      std::vector<Node> nodes;
    };

    void add(Load &load, double torque, const NodeField &positions, NodeField &forces) const;

    std::vector<Load> loads_;
  };
} // namespace vfife

#endif
