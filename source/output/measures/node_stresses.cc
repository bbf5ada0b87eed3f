// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/element/stress.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/measures/node_stresses.h>

namespace vfife
{
  namespace
  {
    /** Six sums of stresses and the number of elements in them. */
    constexpr unsigned int n_records = 7;

    /**
     * Adds the element's nodal stresses [MPa], in the axes of the body frame, to the
     * records of its nodes.
     */
    void add_element_stresses(const Body          &body,
                              const unsigned int   element,
                              const State         &state,
                              const StiffnessKind  kind,
                              const FrameKind      frame,
                              std::vector<double> &records)
    {
      const HexahedronNodes X     = body.element_nodes(element);
      const auto           &nodes = body.elements()[element];
      HexahedronNodes       x;
      for (unsigned int i = 0; i < 8; ++i)
        x.col(i) = state.node_position(state.partition->local_node[body.first_node + nodes[i]]);
      const auto stresses = compute_nodal_stresses(X, x, body.material(), kind, frame);
      for (unsigned int i = 0; i < 8; ++i)
        {
          double *record = &records[n_records * (body.first_node + nodes[i])];
          for (unsigned int c = 0; c < 6; ++c)
            record[c] += stresses(c, i);
          record[6] += 1;
        }
    }
  } // namespace

  std::vector<std::array<double, 6>> compute_node_stresses(const Model        &model,
                                                           const State        &state,
                                                           const StiffnessKind kind,
                                                           const FrameKind     frame,
                                                           const Communicator &communicator)
  {
    std::vector<double> records(n_records * static_cast<std::size_t>(model.n_nodes()), 0.);
    std::size_t         b = 0;
    for (const std::uint32_t e : state.partition->elements)
      {
        // The partition's elements ascend, and so do their bodies.
        while (e >= model.bodies[b].first_element + model.bodies[b].n_elements())
          ++b;
        add_element_stresses(
          model.bodies[b], e - model.bodies[b].first_element, state, kind, frame, records);
      }
    // Nodes between ranks have elements on several of them: sums and counts first, means then.
    communicator.sum(records);

    std::vector<std::array<double, 6>> averages(model.n_nodes());
    for (const Body &body : model.bodies)
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        {
          const double *record = &records[n_records * (body.first_node + i)];
          if (record[6] == 0)
            continue;
          // Averaged along the axes of the body frame, then turned once for each node.
          const Stress turned =
            turn_stress(Eigen::Map<const Stress>(record) / record[6],
                        compute_cylindrical_axes(body, body.node_positions()[i]));
          for (unsigned int c = 0; c < 6; ++c)
            averages[body.first_node + i][c] = turned[c];
        }
    return averages;
  }
} // namespace vfife
