// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/constraints/held_direction.h>
#include <vfife/model/load_shares.h>

#include <numeric>

namespace vfife
{
  std::vector<double> compute_load_shares(const Load &load, const Body &body)
  {
    // Of an acceleration a node takes its mass [t]; shares of other loads have no unit and sum
    // to 1.
    if (load.kind == LoadKind::acceleration)
      return masses_of(body, load.nodes);
    if (load.kind == LoadKind::pressure &&
        find_boundary_faces(body, load.nodes, load.faces).empty())
      throw InputError("load \"" + load.name + "\": the nodes contain no face of body \"" +
                       body.name() +
                       "\". Select all nodes of the faces on which the pressure acts");
    return compute_area_shares(body, load.nodes, load.faces);
  }

  std::vector<double> compute_area_shares(const Body                      &body,
                                          const std::vector<unsigned int> &nodes,
                                          const SelectedFaces             &selected)
  {
    std::vector<double> shares = compute_nodal_areas(body, nodes, selected);
    double              sum    = std::accumulate(shares.begin(), shares.end(), 0.);
    // Single nodes or lines of nodes have no area.
    if (!(sum > 0))
      {
        shares.assign(nodes.size(), 1.);
        sum = shares.size();
      }
    for (double &share : shares)
      share /= sum;
    return shares;
  }

  std::vector<double> masses_of(const Body &body, const std::vector<unsigned int> &nodes)
  {
    std::vector<double> masses;
    for (const unsigned int node : nodes)
      masses.push_back(body.node_masses()[node]);
    return masses;
  }

  std::vector<Vector3> find_undeformed_places(const Body                      &body,
                                              const std::vector<unsigned int> &nodes)
  {
    std::vector<Vector3> places;
    for (const unsigned int node : nodes)
      places.push_back(body.placement(body.node_positions()[node]));
    return places;
  }

  std::vector<double> compute_torque_shares(const Torque &torque, const Body &body)
  {
    std::vector<double> shares;
    double              moment = 0;
    for (std::size_t i = 0; i < torque.nodes.size(); ++i)
      {
        const Vector3 arm =
          body.placement(body.node_positions()[torque.nodes[i]]) - body.axis.point;
        const double radius = body.axis.direction.cross(arm).norm();
        const bool   turns  = radius > on_axis_distance;
        shares.push_back(turns ? torque.areas[i] : 0.);
        moment += shares.back() * radius;
      }
    if (!(moment > 0))
      throw InputError("torque \"" + torque.name + "\": the nodes contain no face of body \"" +
                       body.name() + "\" away from the axis. Select faces with a lever arm");
    for (double &share : shares)
      share /= moment;
    return shares;
  }

  std::vector<BoundaryFace> find_boundary_faces(const Body                      &body,
                                                const std::vector<unsigned int> &nodes,
                                                const SelectedFaces             &of)
  {
    std::vector<BoundaryFace> faces;
    std::vector<std::uint8_t> selected(body.n_nodes(), 0);
    for (const unsigned int node : nodes)
      selected[node] = 1;
    for (const auto &cell : body.mesh().triangulation.active_cell_iterators())
      {
        if (!cell->at_boundary())
          continue;
        const auto &corner_nodes = body.elements()[cell->active_cell_index()];
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary())
              continue;
            // Corners of face f = 2 d + side in turn: in the plane of the directions d + 1, d + 2
            // of the reference cube, counter-clockwise about + d; the other way round on side 0.
            const unsigned int d = f / 2, side = f % 2, u = 1u << ((d + 1) % 3),
                               v = 1u << ((d + 2) % 3), base = side << d;
            //   base + v o-----o base + u + v
            //            |     |             + d towards the reader: out of the body on side 1
            //       base o-----o base + u
            std::array<unsigned int, 4> corners = {{base, base + u, base + u + v, base + v}};
            if (side == 0)
              std::swap(corners[1], corners[3]);
            BoundaryFace face{cell->active_cell_index(), f, {}};
            bool         inside = true;
            for (unsigned int i = 0; i < 4; ++i)
              {
                face.nodes[i] = corner_nodes[corners[i]];
                inside        = inside && selected[face.nodes[i]] != 0;
              }
            if (inside && is_one_of(of, face.nodes))
              faces.push_back(face);
          }
      }
    return faces;
  }
} // namespace vfife
