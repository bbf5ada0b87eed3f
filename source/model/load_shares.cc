// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/load_shares.h>

#include <Eigen/LU>

#include <numeric>

namespace vfife
{
  std::vector<double> compute_load_shares(const Load &load, const Body &body)
  {
    std::vector<double> shares;
    if (load.kind == LoadKind::acceleration)
      {
        // Of an acceleration a node takes its mass [t]; shares of other loads have no unit and sum
        // to 1.
        for (const unsigned int node : load.nodes)
          shares.push_back(body.node_masses()[node]);
        return shares;
      }
    shares     = compute_nodal_areas(body, load.nodes);
    double sum = std::accumulate(shares.begin(), shares.end(), 0.);
    // Single nodes or lines of nodes: equal shares, where the load has no need of a face.
    if (!(sum > 0))
      {
        if (load.kind == LoadKind::pressure)
          throw InputError("load \"" + load.name + "\": its nodes carry no face of body \"" +
                           body.name() + "\" that the pressure could act on");
        shares.assign(load.nodes.size(), 1.);
        sum = shares.size();
      }
    for (double &share : shares)
      share /= sum;
    return shares;
  }

  std::vector<BoundaryFace> find_boundary_faces(const Body                      &body,
                                                const std::vector<unsigned int> &nodes)
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
            if (inside)
              faces.push_back(face);
          }
      }
    return faces;
  }

  Vector3
  compute_vector_area(const Vector3 &a, const Vector3 &b, const Vector3 &c, const Vector3 &d)
  {
    // Half the cross product of the diagonals.
    return 0.5 * (c - a).cross(d - b);
  }

  void MomentSums::add(const double share, const Vector3 &place)
  {
    // With A the share: [0] sum A, [1..3] sum A x, [4..12] sum A x x^T about the origin. No centre
    // is needed while summing, so that ranks add up their sums in one reduction.
    const Matrix3 second = share * place * place.transpose();
    values[0] += share;
    for (unsigned int c = 0; c < 3; ++c)
      values[1 + c] += share * place[c];
    for (unsigned int c = 0; c < 9; ++c)
      values[4 + c] += second.data()[c];
  }

  std::pair<Vector3, Vector3> MomentSums::solve(const Vector3     &moment,
                                                const std::string &load) const
  {
    // About the centre (Steiner), r = x - centre: J = tr(S) I - S with S = sum A r r^T. The forces
    // A w x r with J w = M have the moment sum A r x (w x r) = J w = M.
    const Vector3 centre = Vector3(values[1], values[2], values[3]) / values[0];
    const Matrix3 second =
      Eigen::Map<const Matrix3>(values.data() + 4) - values[0] * centre * centre.transpose();
    const Matrix3                   inertia = second.trace() * Matrix3::Identity() - second;
    const Eigen::FullPivLU<Matrix3> factors(inertia);
    if (!factors.isInvertible())
      throw InputError("load \"" + load + "\": its nodes lie on a line and cannot carry a moment");
    return {centre, factors.solve(moment)};
  }
} // namespace vfife
