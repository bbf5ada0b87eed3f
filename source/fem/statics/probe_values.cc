// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/statics/probe_values.h>
#include <vfife/model/body_frame.h>

namespace vfife
{
  ProbeValue compute_probe_value(const Probe               &probe,
                                 const Discretization      &discretization,
                                 const std::vector<double> &displacements,
                                 const std::vector<Stress> &stresses)
  {
    ProbeValue                        value;
    const Discretization::Part *const part = discretization.find_part(probe.body);
    if (part == nullptr)
      return value;
    const Body        &body  = discretization.model().bodies[probe.body];
    const Matrix3      frame = body.placement.rotation;
    const std::size_t  row   = 3 * std::size_t(part->first_point + probe.node);
    const Vector3      moved = Eigen::Map<const Vector3>(displacements.data() + row);
    const Stress      &local = stresses[body.first_node + probe.node];
    const Matrix3      axes  = compute_cylindrical_axes(body, body.node_positions()[probe.node]);
    Eigen::Map<Stress> stress(value.stress.data());
    value.von_mises    = von_mises(local);
    value.displacement = moved;
    stress             = turn_stress(local, frame);
    // From the fixed frame into the body frame, then into r, theta, z there.
    if (!probe.fixed_axes)
      {
        value.displacement = axes.transpose() * (frame.transpose() * moved);
        stress             = turn_stress(stress, axes);
      }
    return value;
  }
} // namespace vfife
