// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/torque_forces.h>
#include <vfife/model/constraints/held_direction.h>
#include <vfife/model/load_shares.h>

#include <map>

namespace vfife
{
  namespace
  {
    Vector3 tangent_at(const FemSpace &space, const Body &body, const unsigned int point)
    {
      return body.axis.direction.cross(space.points()[point] - body.axis.point);
    }

    /** A_i / sum A_j r_j of the nodes. */
    std::map<unsigned int, double>
    shares_of_nodes(const Torque &torque, const Body &body, const FemSpace::Part &part)
    {
      const std::vector<double>      shares = compute_torque_shares(torque, body);
      std::map<unsigned int, double> of_points;
      // Of a sector its own nodes.
      for (std::size_t i = 0; i < torque.nodes.size(); ++i)
        if (torque.nodes[i] < part.n_nodes)
          of_points[part.first_point + torque.nodes[i]] = shares[i];
      return of_points;
    }

    /** The same of all points of the faces, A_i the integrals of the shape functions; empty where
     * the nodes have no face. */
    std::map<unsigned int, double> shares_of_points(const Torque         &torque,
                                                    const FemSpace       &space,
                                                    const Body           &body,
                                                    const FemSpace::Part &part)
    {
      // What an image takes, its original takes from the sector before.
      const std::map<unsigned int, unsigned int> originals(space.images().begin(),
                                                           space.images().end());
      std::map<unsigned int, double>             areas;
      double                                     moment = 0;
      for (const BoundaryFace &face : find_boundary_faces(body, torque.nodes))
        {
          if (face.element >= space.n_body_elements(part))
            continue; // of another sector
          for (const auto &points : space.points_on_face(part, face.element, face.number))
            {
              ElementNodes X(3, points.size());
              for (std::size_t i = 0; i < points.size(); ++i)
                X.col(i) = space.points()[points[i]];
              for (const FacePoint &at : compute_face_points(X))
                for (std::size_t i = 0; i < points.size(); ++i)
                  {
                    const double area  = at.normal.norm() * at.N[i];
                    const auto   image = originals.find(points[i]);
                    areas[image == originals.end() ? points[i] : image->second] += area;
                    moment += area * tangent_at(space, body, points[i]).norm();
                  }
            }
        }
      const double n_parts = static_cast<double>(body.n_elements()) / space.n_body_elements(part);
      for (auto &share : areas)
        share.second /= n_parts * moment;
      return areas;
    }
  } // namespace

  void add_torque_forces(const Torque         &torque,
                         const FemSpace       &space,
                         const FemSpace::Part &part,
                         const double          value,
                         std::vector<double>  &forces)
  {
    const Body &body   = space.model().bodies[torque.body];
    auto        shares = shares_of_nodes(torque, body, part);
    if (space.degree() > 1 || space.is_refined(part))
      if (auto of_points = shares_of_points(torque, space, body, part); !of_points.empty())
        shares = std::move(of_points);
    for (const auto &[point, share] : shares)
      {
        const Vector3 tangent = tangent_at(space, body, point);
        if (!(tangent.norm() > on_axis_distance))
          continue;
        const Vector3 force = value * share * tangent.normalized();
        for (unsigned int c = 0; c < 3; ++c)
          forces[3 * std::size_t(point) + c] += force[c];
      }
  }
} // namespace vfife
