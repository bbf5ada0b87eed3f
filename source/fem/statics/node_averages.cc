// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/fem/statics/node_averages.h>
#include <vfife/fem/system/element_integrals.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/load_shares.h>

#include <algorithm>
#include <array>

namespace vfife
{
  namespace
  {
    using Corners = Eigen::Matrix<double, 3, 4>;

    /** The place (xi, eta) of a facet with these corners that is nearest to @p x: Gauss and
     * Newton. */
    Vector2 find_place(const Corners &corners, const Vector3 &x)
    {
      Vector2 place(.5, .5);
      for (unsigned int i = 0; i < 20; ++i)
        {
          const auto    N   = bilinear_weights(place[0], place[1]);
          const Vector3 off = x - corners * Eigen::Map<const Eigen::Vector4d>(N.data());
          Eigen::Matrix<double, 3, 2> slopes;
          slopes.col(0) = (1. - place[1]) * (corners.col(1) - corners.col(0)) +
                          place[1] * (corners.col(2) - corners.col(3));
          slopes.col(1) = (1. - place[0]) * (corners.col(3) - corners.col(0)) +
                          place[0] * (corners.col(2) - corners.col(1));
          const Vector2 step = (slopes.transpose() * slopes).inverse() * (slopes.transpose() * off);
          place += step;
          if (step.norm() < 1e-12)
            break;
        }
      return place.cwiseMax(0.).cwiseMin(1.);
    }
  } // namespace

  Vector3 compute_mean(const PointWeights &weights, const std::vector<double> &u)
  {
    Vector3 mean = Vector3::Zero();
    for (const auto &[point, weight] : weights)
      mean += weight * Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(point));
    return mean;
  }

  NodeAverages::NodeAverages(const FemSpace &space)
  {
    for (const ContactPair &pair : space.model().contacts)
      {
        add_surface(space, pair.slave_body, pair.slave_surface);
        add_surface(space, pair.master_body, pair.master_surface);
      }
  }

  void
  NodeAverages::add_surface(const FemSpace &space, const unsigned int body, const std::string &name)
  {
    const FemSpace::Part *part = space.find_part(body);
    if (part == nullptr || (space.degree() == 1 && !space.is_refined(*part)))
      return;
    const Body                                            &own     = space.model().bodies[body];
    const FacetSurface                                    &surface = own.mesh().surfaces.at(name);
    std::map<unsigned int, std::map<unsigned int, double>> sums; // by node and point
    std::map<unsigned int, double>                         areas;
    for (const BoundaryFace &face : find_boundary_faces(own, surface.nodes, faces_of(surface)))
      {
        Corners corners;
        for (unsigned int k = 0; k < 4; ++k)
          corners.col(k) = space.points()[part->first_point + face.nodes[k]];
        // Integrals over the facet of phi_i, phi_i phi_j and phi_i N_a, phi the bilinear functions.
        Eigen::Vector4d                         of_one      = Eigen::Vector4d::Zero();
        Eigen::Matrix4d                         of_products = Eigen::Matrix4d::Zero();
        std::map<unsigned int, Eigen::Vector4d> of_shapes;
        for (const auto &points : space.points_on_face(*part, face.element, face.number))
          {
            ElementNodes X(3, points.size());
            for (std::size_t i = 0; i < points.size(); ++i)
              X.col(i) = space.points()[points[i]];
            for (const FacePoint &at : compute_face_points(X))
              {
                const Vector2         place = find_place(corners, X * at.N);
                const auto            N     = bilinear_weights(place[0], place[1]);
                const Eigen::Vector4d phi   = Eigen::Map<const Eigen::Vector4d>(N.data());
                const double          area  = at.normal.norm();
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
        means_[part->first_point + node].emplace_back(point, share / areas.at(node));
  }

  PointWeights NodeAverages::of(const unsigned int point) const
  {
    const auto found = means_.find(point);
    return found != means_.end() ? found->second : PointWeights{{point, 1.}};
  }
} // namespace vfife
