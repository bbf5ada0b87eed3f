// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/loads/contact/contact_system.h>
#include <vfife/dynamics/loads/rigid_walls.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/dynamics/watch/measurement.h>
#include <vfife/element/stress.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/pair_measures.h>

#include <algorithm>

namespace vfife
{
  void
  measure_contact(const ContactSystem &contact, const RigidWalls &walls, Measurements &measured)
  {
    set_teeth(contact.collect_results(), contact.n_contacts(), measured);
    // Walls have no teeth.
    const RigidWalls::Results wall = walls.collect_results();
    measured.contact_forces.insert(measured.contact_forces.end(),
                                   wall.forces.begin(),
                                   wall.forces.end());
    measured.contact_force += wall.force;
    measured.largest_penetration = std::max(measured.largest_penetration, wall.penetration);
  }

  std::vector<ProbeValue> measure_probes(const Model              &model,
                                         const std::vector<Probe> &probes,
                                         const State              &state,
                                         const VfifeOperator      &vfife,
                                         const Communicator       &communicator)
  {
    // 1. The owner brings the position, each rank the stresses of its elements at the node.
    constexpr unsigned int n = 10; // position 3, stress 6, number of elements
    std::vector<double>    sums(n * probes.size(), 0.);
    for (std::size_t p = 0; p < probes.size(); ++p)
      {
        const Probe        &probe = probes[p];
        const Body         &body  = model.bodies[probe.body];
        double             *s     = sums.data() + n * p;
        const std::uint32_t local = state.partition->local_node[body.first_node + probe.node];
        if (local == Partition::absent)
          continue;
        if (state.partition->owned[local])
          std::copy_n(state.node_position(local).data(), 3, s);

        for (const std::uint32_t e : vfife.elements_at(local))
          {
            // The stress of the deformed element at this corner, in axes of the body.
            const auto     &nodes = body.elements()[e - body.first_element];
            HexahedronNodes x;
            unsigned int    corner = 0;
            for (unsigned int i = 0; i < 8; ++i)
              {
                x.col(i) =
                  state.node_position(state.partition->local_node[body.first_node + nodes[i]]);
                if (nodes[i] == probe.node)
                  corner = i;
              }
            const auto stress =
              compute_nodal_stresses(body.stress_free_nodes(e - body.first_element),
                                     x,
                                     body.material(e - body.first_element),
                                     vfife.stiffness(),
                                     vfife.frame());
            Eigen::Map<Stress>(s + 3) += stress.col(corner);
            s[9] += 1.;
          }
      }
    communicator.sum(sums);

    // 2. Displacement in the turning body along r, theta, z; stress averaged over the elements and
    // turned into the same axes. Both along x, y, z where the probe asks for it.
    std::vector<ProbeValue> values;
    for (std::size_t p = 0; p < probes.size(); ++p)
      {
        const Probe  &probe = probes[p];
        const Body   &body  = model.bodies[probe.body];
        const double *s     = sums.data() + n * p;
        const Vector3 x = Eigen::Map<const Vector3>(s), X = body.node_positions()[probe.node];
        const Stress  mean = Eigen::Map<const Stress>(s + 3) / s[9];
        if (probe.fixed_axes)
          {
            values.push_back(make_probe_value(x - body.placement(X), mean, {}));
            continue;
          }
        const Matrix3 axes  = compute_cylindrical_axes(body, X);
        const Vector3 moved = compute_displacement(
          body, probe.node, x, compute_turn(body, state.body_motion[probe.body]));
        values.push_back(make_probe_value(
          axes.transpose() * (body.placement.rotation.transpose() * moved), mean, {axes}));
      }
    return values;
  }
} // namespace vfife
