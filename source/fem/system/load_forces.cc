// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/bearing/mean_motion.h>
#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/load_shares.h>

#include <array>
#include <map>

namespace vfife
{
  namespace
  {
    /** Corners of a face at its undeformed place, in turn seen from outside. */
    std::array<Vector3, 4> corners_of(const BoundaryFace         &face,
                                      const Discretization       &discretization,
                                      const Discretization::Part &part)
    {
      std::array<Vector3, 4> corners;
      for (unsigned int k = 0; k < 4; ++k)
        corners[k] = discretization.points()[part.first_point + face.nodes[k]];
      return corners;
    }

    /** Points along a side of an element's face. */
    unsigned int points_along(const Discretization &discretization)
    {
      return discretization.element() == FemElement::quadratic ? 3 : 2;
    }

    /** The points of a face, those along the side from its corner 0 to 1 fastest. */
    std::vector<unsigned int> face_points(const Discretization       &discretization,
                                          const Discretization::Part &part,
                                          const BoundaryFace         &face)
    {
      // Points of an element are numbered with x fastest; a face lies at one end of its normal
      // direction d and is run through along d + 1 and d + 2, on the lower side the other way round
      // (find_boundary_faces).
      const unsigned int  n      = points_along(discretization);
      const unsigned int *points = discretization.element_points(part.first_element + face.element);
      const unsigned int  direction = face.number / 2, side = face.number % 2;
      const unsigned int  first = (direction + (side == 1 ? 1 : 2)) % 3,
                         second = (direction + (side == 1 ? 2 : 1)) % 3;
      std::vector<unsigned int> of_face;
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            std::array<unsigned int, 3> at;
            at[direction] = side * (n - 1);
            at[first]     = i;
            at[second]    = j;
            of_face.push_back(points[at[0] + n * (at[1] + n * at[2])]);
          }
      return of_face;
    }

    /** Masses [t] of the points of quadratic elements, integrals of the density times the shape
     * functions; of a point between corners the part of those that are among the nodes. */
    PointShares quadratic_masses(const std::vector<unsigned int> &nodes,
                                 const Discretization            &discretization,
                                 const Discretization::Part      &part)
    {
      const Body       &body = discretization.model().bodies[part.body];
      std::vector<bool> selected(body.n_nodes(), false);
      for (const unsigned int node : nodes)
        selected[node] = true;
      std::map<unsigned int, double> of_points;
      for (unsigned int e = 0; e < part.n_elements; ++e)
        {
          const unsigned int   *points = discretization.element_points(part.first_element + e);
          const Eigen::VectorXd masses =
            compute_mass_coefficients(discretization.element_nodes(part.first_element + e),
                                      body.material(e).density,
                                      MassKind::consistent)
              .rowwise()
              .sum();
          for (unsigned int a = 0; a < 27; ++a)
            {
              // The corners between which it lies, by its places 0, 1, 2 along x, y, z.
              const unsigned int at[3]   = {a % 3, a / 3 % 3, a / 9};
              double             corners = 0, inside = 0;
              for (unsigned int v = 0; v < 8; ++v)
                {
                  bool spans = true;
                  for (unsigned int d = 0; d < 3; ++d)
                    spans = spans && (at[d] == 1 || (v >> d & 1u) == at[d] / 2);
                  if (!spans)
                    continue;
                  ++corners;
                  inside += selected[body.elements()[e][v]] ? 1. : 0.;
                }
              if (inside > 0)
                of_points[points[a]] += inside / corners * masses[a];
            }
        }
      return PointShares(of_points.begin(), of_points.end());
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
      if (load.kind == LoadKind::acceleration && discretization.element() == FemElement::quadratic)
        return quadratic_masses(load.nodes, discretization, part);
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
    // The integrals of the shape functions over all faces, which share points.
    double                         sum = 0;
    std::map<unsigned int, double> of_points;
    for (const BoundaryFace &face : faces)
      {
        const auto areas =
          integrate_areas(corners_of(face, discretization, part), points_along(discretization));
        const auto points = face_points(discretization, part, face);
        for (std::size_t i = 0; i < points.size(); ++i)
          {
            of_points[points[i]] += areas[i];
            sum += areas[i];
          }
      }
    for (auto &share : of_points)
      share.second /= sum;
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
            const auto normals = integrate_normals(corners_of(face, discretization, part),
                                                   points_along(discretization));
            const auto points  = face_points(discretization, part, face);
            for (std::size_t i = 0; i < points.size(); ++i)
              add(points[i], -load.pressure * normals[i]);
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
