// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/search/local_search.h>
#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/fem/statics/node_averages.h>
#include <vfife/fem/system/element_integrals.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/load_shares.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace vfife
{
  namespace
  {
    /** A facet by its corners, with the same normal everywhere. */
    FacetState make_facet(const std::array<Vector3, 4> &x)
    {
      FacetState facet{{x[0], x[1] - x[0], x[3] - x[0], x[0] - x[1] + x[2] - x[3]},
                       {(x[2] - x[0]).cross(x[3] - x[1]).normalized(),
                        Vector3::Zero(),
                        Vector3::Zero(),
                        Vector3::Zero()}};
      return facet;
    }

    /** The bilinear functions of a facet below or above @p x. */
    Eigen::Vector4d find_weights(const FacetState &facet, const Vector3 &x)
    {
      Projection place;
      project_on_facet(facet, 0, x, place);
      const auto N = bilinear_weights(std::clamp(place.xi, 0., 1.), std::clamp(place.eta, 0., 1.));
      return Eigen::Map<const Eigen::Vector4d>(N.data());
    }
  } // namespace

  NodeAverages::NodeAverages(const FemSpace &space)
  {
    // All surfaces of a body together: they may have nodes in common.
    std::map<unsigned int, FaceSet> faces;
    const Model                    &model = space.model();
    for (const ContactPair &pair : model.contacts)
      for (const auto &[body, name] : {std::tie(pair.slave_body, pair.slave_surface),
                                       std::tie(pair.master_body, pair.master_surface)})
        faces[body].merge(faces_of(model.bodies[body].mesh().surfaces.at(name)));
    for (const auto &[body, of_body] : faces)
      if (const FemSpace::Part *part = space.find_part(body);
          part != nullptr && (space.degree() > 1 || space.is_refined(*part)))
        {
          std::vector<unsigned int> nodes;
          for (const auto &face : of_body)
            nodes.insert(nodes.end(), face.begin(), face.end());
          add_faces(space, *part, find_boundary_faces(model.bodies[body], nodes, of_body));
        }
  }

  void NodeAverages::add_faces(const FemSpace                  &space,
                               const FemSpace::Part            &part,
                               const std::vector<BoundaryFace> &faces)
  {
    std::map<unsigned int, std::map<unsigned int, double>> sums; // by node and point
    std::map<unsigned int, double>                         areas;
    for (const BoundaryFace &face : faces)
      {
        std::array<Vector3, 4> corners;
        for (unsigned int k = 0; k < 4; ++k)
          corners[k] = space.points()[part.first_point + face.nodes[k]];
        const FacetState facet = make_facet(corners);
        // Integrals over the facet of phi_i, phi_i phi_j and phi_i N_a, phi the bilinear functions.
        Eigen::Vector4d                         of_one      = Eigen::Vector4d::Zero();
        Eigen::Matrix4d                         of_products = Eigen::Matrix4d::Zero();
        std::map<unsigned int, Eigen::Vector4d> of_shapes;
        for (const auto &points : space.points_on_face(part, face.element, face.number))
          {
            ElementNodes X(3, points.size());
            for (std::size_t i = 0; i < points.size(); ++i)
              X.col(i) = space.points()[points[i]];
            for (const FacePoint &at : compute_face_points(X))
              {
                const Eigen::Vector4d phi  = find_weights(facet, X * at.N);
                const double          area = at.normal.norm();
                of_one += area * phi;
                of_products += area * phi * phi.transpose();
                for (std::size_t i = 0; i < points.size(); ++i)
                  of_shapes.try_emplace(points[i], Eigen::Vector4d::Zero()).first->second +=
                    area * at.N[i] * phi;
              }
          }
        // psi = diag(integral of phi) (integral of phi phi^T)^-1 phi
        const Eigen::Matrix4d dual = of_one.asDiagonal() * of_products.inverse();
        for (const auto &[point, shares] : of_shapes)
          for (unsigned int k = 0; k < 4; ++k)
            sums[face.nodes[k]][point] += dual.row(k).dot(shares);
        for (unsigned int k = 0; k < 4; ++k)
          areas[face.nodes[k]] += of_one[k];
      }
    for (const auto &[node, shares] : sums)
      for (const auto &[point, share] : shares)
        means_[part.first_point + node].emplace_back(point, share / areas.at(node));
  }

  PointWeights NodeAverages::of(const unsigned int point) const
  {
    const auto found = means_.find(point);
    return found != means_.end() ? found->second : PointWeights{{point, 1.}};
  }
} // namespace vfife
