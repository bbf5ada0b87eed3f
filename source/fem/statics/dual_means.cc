// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "dual_means.h"

#include <vfife/mesh/body_mesh.h>
#include <vfife/model/load_shares.h>
#include <vfife/model/model.h>

#include <Eigen/LU>

#include <tuple>

namespace vfife
{
  void DualMeans::Quadrilateral::add(const double                     area,
                                     const Eigen::Vector4d           &phi,
                                     const std::vector<unsigned int> &points,
                                     const Eigen::VectorXd           &N)
  {
    of_one_ += area * phi;
    of_products_ += area * phi * phi.transpose();
    for (std::size_t i = 0; i < points.size(); ++i)
      of_shapes_.try_emplace(points[i], Eigen::Vector4d::Zero()).first->second += area * N[i] * phi;
  }

  void DualMeans::add(const Quadrilateral               &quadrilateral,
                      const std::array<unsigned int, 4> &corners)
  {
    // psi = diag(integral of phi) (integral of phi phi^T)^-1 phi
    const Eigen::Matrix4d dual =
      quadrilateral.of_one_.asDiagonal() * quadrilateral.of_products_.inverse();
    for (const auto &[point, shares] : quadrilateral.of_shapes_)
      for (unsigned int k = 0; k < 4; ++k)
        sums_[corners[k]][point] += dual.row(k).dot(shares);
    for (unsigned int k = 0; k < 4; ++k)
      areas_[corners[k]] += quadrilateral.of_one_[k];
  }

  std::map<unsigned int, PointWeights> DualMeans::find() const
  {
    std::map<unsigned int, PointWeights> means;
    for (const auto &[corner, shares] : sums_)
      for (const auto &[point, share] : shares)
        means[corner].emplace_back(point, share / areas_.at(corner));
    return means;
  }

  std::vector<std::pair<const FemSpace::Part *, std::vector<BoundaryFace>>>
  find_divided_faces(const FemSpace &space)
  {
    // All surfaces of a body together: they may have nodes in common.
    std::map<unsigned int, FaceSet> faces;
    const Model                    &model = space.model();
    for (const ContactPair &pair : model.contacts)
      for (const auto &[body, name] : {std::tie(pair.slave_body, pair.slave_surface),
                                       std::tie(pair.master_body, pair.master_surface)})
        faces[body].merge(faces_of(model.bodies[body].mesh().surfaces.at(name)));
    std::vector<std::pair<const FemSpace::Part *, std::vector<BoundaryFace>>> found;
    for (const auto &[body, of_body] : faces)
      if (const FemSpace::Part *part = space.find_part(body);
          part != nullptr && (space.degree() > 1 || space.is_refined(*part)))
        {
          std::vector<unsigned int> nodes;
          for (const auto &face : of_body)
            nodes.insert(nodes.end(), face.begin(), face.end());
          found.emplace_back(part, find_boundary_faces(model.bodies[body], nodes, of_body));
        }
    return found;
  }
} // namespace vfife
