// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/bearing/mean_motion.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/constraints/held_direction.h>
#include <vfife/model/load_shares.h>

#include <array>
#include <map>

namespace vfife
{
  std::vector<std::pair<std::vector<unsigned int>, ElementNodes>>
  points_of_face(const FemSpace &space, const FemSpace::Part &part, const BoundaryFace &face)
  {
    std::vector<std::pair<std::vector<unsigned int>, ElementNodes>> faces;
    for (const auto &points : space.points_on_face(part, face.element, face.number))
      {
        ElementNodes X(3, points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
          X.col(i) = space.points()[points[i]];
        faces.emplace_back(points, X);
      }
    return faces;
  }

  namespace
  {
    /** Areas [mm^2] of the points on faces of the body, integrals of the shape functions; those of
     * other sectors than the space has are left out. */
    std::map<unsigned int, double> point_areas(const FemSpace                  &space,
                                               const FemSpace::Part            &part,
                                               const std::vector<BoundaryFace> &faces)
    {
      std::map<unsigned int, double> areas;
      for (const BoundaryFace &face : faces)
        if (face.element < space.n_body_elements(part))
          for (const auto &[points, X] : points_of_face(space, part, face))
            for (const FacePoint &at : compute_face_points(X))
              {
                const double area = at.normal.norm();
                for (std::size_t i = 0; i < points.size(); ++i)
                  areas[points[i]] += area * at.N[i];
              }
      return areas;
    }

    /** Masses [t] of the points, integrals of the density times the shape functions; of a point
     * between corners the part of those that are among the nodes. */
    PointWeights point_masses(const std::vector<unsigned int> &nodes,
                              const FemSpace                  &space,
                              const FemSpace::Part            &part)
    {
      const Body       &body = space.model().bodies[part.body];
      std::vector<bool> selected(body.n_nodes(), false);
      for (const unsigned int node : nodes)
        selected[node] = true;
      std::map<unsigned int, double> of_points;
      for (unsigned int e = 0; e < part.n_elements; ++e)
        {
          const unsigned int *points  = space.element_points(part.first_element + e);
          const auto         &corners = body.elements()[space.body_element(part.first_element + e)];
          std::array<bool, 8> of_corners;
          for (unsigned int v = 0; v < 8; ++v)
            of_corners[v] = selected[corners[v]];
          const Eigen::VectorXd masses =
            compute_selected_masses(space.element_nodes(part.first_element + e),
                                    space.material(part.first_element + e).density,
                                    space.degree(),
                                    of_corners);
          for (Eigen::Index a = 0; a < masses.size(); ++a)
            if (masses[a] != 0.)
              of_points[points[a]] += masses[a];
        }
      return PointWeights(of_points.begin(), of_points.end());
    }

    /** As compute_load_shares(), with the points between the nodes. */
    PointWeights point_shares(const Load &load, const FemSpace &space, const FemSpace::Part &part)
    {
      // A pressure needs no shares, but is refused without a face.
      const Body &body = space.model().bodies[load.body];
      if (load.kind != LoadKind::acceleration && load.kind != LoadKind::pressure)
        return point_area_shares(body, load.nodes, load.faces, space, part);
      if (load.kind == LoadKind::acceleration && (space.degree() > 1 || space.is_refined(part)))
        return point_masses(load.nodes, space, part);
      const std::vector<double> nodal = compute_load_shares(load, body);
      PointWeights              shares;
      for (std::size_t i = 0; i < load.nodes.size(); ++i)
        shares.emplace_back(part.first_point + load.nodes[i], nodal[i]);
      return shares;
    }

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
      std::map<unsigned int, double> areas =
        point_areas(space, part, find_boundary_faces(body, torque.nodes));
      // What an image takes, its original takes from the sector before.
      for (const auto &[image, original] : space.images())
        if (const auto found = areas.find(image); found != areas.end())
          {
            areas[original] += found->second;
            areas.erase(found);
          }
      double moment = 0;
      for (const auto &[point, area] : areas)
        moment += area * tangent_at(space, body, point).norm();
      const double n_parts = static_cast<double>(body.n_elements()) / space.n_body_elements(part);
      for (auto &share : areas)
        share.second /= n_parts * moment;
      return areas;
    }
  } // namespace

  PointWeights point_area_shares(const Body                      &body,
                                 const std::vector<unsigned int> &nodes,
                                 const SelectedFaces             &selected,
                                 const FemSpace                  &space,
                                 const FemSpace::Part            &part)
  {
    std::vector<BoundaryFace> faces;
    if (space.degree() > 1 || space.is_refined(part))
      faces = find_boundary_faces(body, nodes, selected);
    PointWeights shares;
    if (faces.empty())
      {
        const std::vector<double> nodal = compute_area_shares(body, nodes, selected);
        for (std::size_t i = 0; i < nodes.size(); ++i)
          shares.emplace_back(part.first_point + nodes[i], nodal[i]);
        return shares;
      }
    std::map<unsigned int, double> of_points = point_areas(space, part, faces);
    double                         sum       = 0;
    for (const auto &share : of_points)
      sum += share.second;
    for (auto &share : of_points)
      share.second /= sum;
    return PointWeights(of_points.begin(), of_points.end());
  }

  void add_load_forces(const Load           &load,
                       const FemSpace       &space,
                       const FemSpace::Part &part,
                       const double          factor,
                       std::vector<double>  &forces)
  {
    const auto add = [&](const unsigned int point, const Vector3 &force) {
      Eigen::Map<Vector3>(forces.data() + 3 * std::size_t(point)) += factor * force;
    };
    const std::vector<Vector3> &places = space.points();
    const PointWeights          shares = point_shares(load, space, part);
    switch (load.kind)
      {
      case LoadKind::force:
      case LoadKind::acceleration:
        for (const auto &share : shares)
          add(share.first, share.second * load.vector);
        break;
      case LoadKind::moment:
        {
          std::vector<double>  areas;
          std::vector<Vector3> of_shares;
          for (const auto &share : shares)
            {
              areas.push_back(share.second);
              of_shares.push_back(places[share.first]);
            }
          const MeanMotion         set(std::move(areas), of_shares, "load \"" + load.name + "\"");
          const MeanMotion::Motion motion = set.at_rest();
          for (std::size_t i = 0; i < shares.size(); ++i)
            add(shares[i].first, set.force(i, motion, Vector3::Zero(), load.vector));
          break;
        }
      case LoadKind::pressure:
        for (const BoundaryFace &face :
             find_boundary_faces(space.model().bodies[load.body], load.nodes, load.faces))
          {
            // Small displacements: the pressure keeps the direction of the undeformed face.
            for (const auto &[points, X] : points_of_face(space, part, face))
              for (const FacePoint &at : compute_face_points(X))
                for (std::size_t i = 0; i < points.size(); ++i)
                  add(points[i], -load.pressure * at.N[i] * at.normal);
          }
        break;
      case LoadKind::spring: // see find_springs()
        break;
      }
  }

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

  std::vector<std::pair<unsigned int, Matrix3>> find_springs(const Load     &load,
                                                             const FemSpace &space)
  {
    std::vector<std::pair<unsigned int, Matrix3>> springs;
    const FemSpace::Part                         *part = space.find_part(load.body);
    if (part == nullptr)
      return springs;
    if (space.sector_angle() > 0)
      throw InputError("spring \"" + load.name +
                       "\": springs to the ground require the whole body, not one sector of it");
    for (const auto &share : point_shares(load, space, *part))
      springs.emplace_back(share.first, Matrix3((share.second * load.vector).asDiagonal()));
    return springs;
  }

  std::vector<std::pair<unsigned int, Matrix3>> find_springs(const FemSpace &space)
  {
    std::vector<std::pair<unsigned int, Matrix3>> springs;
    for (const Load &load : space.model().loads)
      if (load.kind == LoadKind::spring)
        for (const auto &spring : find_springs(load, space))
          springs.push_back(spring);
    return springs;
  }
} // namespace vfife
