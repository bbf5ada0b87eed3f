// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/bearing/mean_motion.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/load_shares.h>

#include <array>
#include <map>

namespace vfife
{
  namespace
  {
    /** The points of a face with their parts of a constant traction on it: int N dA / A of a flat
     * face. */
    PointShares face_shares(const Discretization       &discretization,
                            const Discretization::Part &part,
                            const BoundaryFace         &face)
    {
      // Along a line the functions integrate to 1/2, 1/2 or, with the middle, to
      // 1/6, 4/6, 1/6 (Simpson): products are 1/4 of a face, or 1/36, 4/36, 16/36 of
      // it at corners, edges and middle.
      // Points of an element are numbered with x fastest; a face lies at one end of its normal
      // direction and is run through along the two others.
      const unsigned int  n         = discretization.element() == FemElement::quadratic ? 3 : 2;
      const double        line[][3] = {{.5, .5, 0.}, {1. / 6, 4. / 6, 1. / 6}};
      const double *const weights   = line[n - 2];
      const unsigned int *points = discretization.element_points(part.first_element + face.element);
      const unsigned int  direction = face.number / 2, side = face.number % 2;
      PointShares         shares;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            std::array<unsigned int, 3> at;
            at[direction]           = side * (n - 1);
            at[(direction + 1) % 3] = i;
            at[(direction + 2) % 3] = j;
            shares.emplace_back(points[at[0] + n * (at[1] + n * at[2])], weights[i] * weights[j]);
          }
      return shares;
    }

    /** Of a face at its undeformed place, out of the body [mm^2]. */
    Vector3 vector_area(const BoundaryFace         &face,
                        const Discretization       &discretization,
                        const Discretization::Part &part)
    {
      const auto place = [&](const unsigned int corner) {
        return discretization.points()[part.first_point + face.nodes[corner]];
      };
      return compute_vector_area(place(0), place(1), place(2), place(3));
    }

    /** As compute_load_shares(), with the points of quadratic elements between the nodes. */
    PointShares point_shares(const Load                 &load,
                             const Discretization       &discretization,
                             const Discretization::Part &part)
    {
      // A pressure needs no shares, but is refused without a face.
      const Body &body = discretization.model().bodies[load.body];
      if (load.kind != LoadKind::acceleration && load.kind != LoadKind::pressure)
        return point_area_shares(body, load.nodes, load.faces, discretization, part);
      const std::vector<double> nodal = compute_load_shares(load, body);
      PointShares               shares;
      for (std::size_t i = 0; i < load.nodes.size(); ++i)
        shares.emplace_back(part.first_point + load.nodes[i], nodal[i]);
      return shares;
    }
  } // namespace

  PointShares point_area_shares(const Body                      &body,
                                const std::vector<unsigned int> &nodes,
                                const SelectedFaces             &selected,
                                const Discretization            &discretization,
                                const Discretization::Part      &part)
  {
    std::vector<BoundaryFace> faces;
    if (discretization.element() == FemElement::quadratic)
      faces = find_boundary_faces(body, nodes, selected);
    PointShares shares;
    if (faces.empty())
      {
        const std::vector<double> nodal = compute_area_shares(body, nodes, selected);
        for (std::size_t i = 0; i < nodes.size(); ++i)
          shares.emplace_back(part.first_point + nodes[i], nodal[i]);
        return shares;
      }
    // Each face by its part of the whole area, then by its points, which faces share.
    double sum = 0;
    for (const BoundaryFace &face : faces)
      sum += vector_area(face, discretization, part).norm();
    std::map<unsigned int, double> of_points;
    for (const BoundaryFace &face : faces)
      {
        const double of_all = vector_area(face, discretization, part).norm() / sum;
        for (const auto &share : face_shares(discretization, part, face))
          of_points[share.first] += of_all * share.second;
      }
    return PointShares(of_points.begin(), of_points.end());
  }

  void add_load_forces(const Load                 &load,
                       const Discretization       &discretization,
                       const Discretization::Part &part,
                       const double                factor,
                       std::vector<double>        &forces)
  {
    const auto add = [&](const unsigned int point, const Vector3 &force) {
      Eigen::Map<Vector3>(forces.data() + 3 * std::size_t(point)) += factor * force;
    };
    const std::vector<Vector3> &places = discretization.points();
    const PointShares           shares = point_shares(load, discretization, part);
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
             find_boundary_faces(discretization.model().bodies[load.body], load.nodes, load.faces))
          {
            // Small displacements: the pressure keeps the direction of the undeformed face.
            const Vector3 area = vector_area(face, discretization, part);
            for (const auto &share : face_shares(discretization, part, face))
              add(share.first, -share.second * load.pressure * area);
          }
        break;
      case LoadKind::spring: // see find_springs()
        break;
      }
  }

  std::vector<std::pair<unsigned int, Matrix3>> find_springs(const Load           &load,
                                                             const Discretization &discretization)
  {
    std::vector<std::pair<unsigned int, Matrix3>> springs;
    const Discretization::Part                   *part = discretization.find_part(load.body);
    if (part == nullptr)
      return springs;
    if (discretization.sector_angle() > 0)
      throw InputError("spring \"" + load.name +
                       "\": springs to the ground need the whole body, not one sector of it");
    for (const auto &share : point_shares(load, discretization, *part))
      springs.emplace_back(share.first, Matrix3((share.second * load.vector).asDiagonal()));
    return springs;
  }

  std::vector<std::pair<unsigned int, Matrix3>> find_springs(const Discretization &discretization)
  {
    std::vector<std::pair<unsigned int, Matrix3>> springs;
    for (const Load &load : discretization.model().loads)
      if (load.kind == LoadKind::spring)
        for (const auto &spring : find_springs(load, discretization))
          springs.push_back(spring);
    return springs;
  }
} // namespace vfife
