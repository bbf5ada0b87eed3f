// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/communicator.h>
#include <vfife/element/stress.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/node_stresses.h>

namespace vfife
{
  namespace
  {
    /** Six sums of stresses and the number of elements in them. */
    constexpr unsigned int n_records = 7;

    /** Stress (xx yy zz xy yz zx) in the axes that are the columns of @p axes. */
    Stress turn_stress(const Stress &s, const Matrix3 &axes)
    {
      Matrix3 tensor;
      tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
      const Matrix3 t = axes.transpose() * tensor * axes;
      Stress        turned;
      turned << t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(2, 0);
      return turned;
    }

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
        x.col(i) = state.node_position(state.partition.local_node[body.first_node + nodes[i]]);
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

  Matrix3 compute_cylindrical_axes(const Body &body, const Vector3 &X)
  {
    const Matrix3 back  = body.placement.rotation.transpose();
    const Vector3 z     = back * body.axis.direction;
    const Vector3 point = back * (body.axis.point - body.placement.translation);
    Vector3       r     = X - point;
    r -= r.dot(z) * z;
    // On the axis (to round-off of the coordinates) r has no direction of its own.
    if (r.norm() <= 1e-12 * (X - point).norm() || r.norm() == 0)
      r = z.unitOrthogonal();
    r.normalize();
    Matrix3 axes;
    axes << r, z.cross(r), z;
    return axes;
  }

  std::vector<std::array<double, 6>> compute_node_stresses(const Model        &model,
                                                           const State        &state,
                                                           const StiffnessKind kind,
                                                           const FrameKind     frame,
                                                           const Communicator &communicator)
  {
    std::vector<double> records(n_records * static_cast<std::size_t>(model.n_nodes()), 0.);
    std::size_t         b = 0;
    for (const std::uint32_t e : state.partition.elements)
      {
        while (e >= model.bodies[b].first_element + model.bodies[b].n_elements())
          ++b;
        add_element_stresses(
          model.bodies[b], e - model.bodies[b].first_element, state, kind, frame, records);
      }
    communicator.sum(records);

    std::vector<std::array<double, 6>> averages(model.n_nodes());
    for (const Body &body : model.bodies)
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        {
          const double *record = &records[n_records * (body.first_node + i)];
          if (record[6] == 0)
            continue;
          const Stress turned =
            turn_stress(Eigen::Map<const Stress>(record) / record[6],
                        compute_cylindrical_axes(body, body.node_positions()[i]));
          for (unsigned int c = 0; c < 6; ++c)
            averages[body.first_node + i][c] = turned[c];
        }
    return averages;
  }
} // namespace vfife
