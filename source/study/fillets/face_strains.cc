// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/body.h>
#include <vfife/study/fillets/face_strains.h>

#include <Eigen/LU>

#include <algorithm>

namespace vfife
{
  Vector3 direction_along_face(const Body &body, const std::array<unsigned int, 4> &facet)
  {
    const std::vector<Vector3> &x = body.node_positions();
    return x[facet[1]] - x[facet[0]] + x[facet[2]] - x[facet[3]];
  }

  std::vector<Eigen::MatrixXd>
  list_face_strains(const ElementNodes &X, const Vector3 &along, const unsigned int degree)
  {
    std::vector<Eigen::MatrixXd> operators;
    for (const Eigen::MatrixXd &gradients : face_gradients(degree))
      {
        const Eigen::Matrix<double, 3, 2> tangents = X * gradients.transpose();
        const Vector3               normal = tangents.col(0).cross(tangents.col(1)).normalized();
        Eigen::Matrix<double, 3, 2> axes;
        axes.col(0) = (along - along.dot(normal) * normal).normalized();
        axes.col(1) = normal.cross(axes.col(0));
        // Derivatives of the shape functions along both axes.
        const Eigen::MatrixXd slopes =
          gradients.transpose() * (axes.transpose() * tangents).inverse();
        Eigen::MatrixXd strain(3, 3 * X.cols());
        for (Eigen::Index a = 0; a < X.cols(); ++a)
          {
            strain.block<1, 3>(0, 3 * a) = slopes(a, 0) * axes.col(0).transpose();
            strain.block<1, 3>(1, 3 * a) = slopes(a, 1) * axes.col(1).transpose();
            strain.block<1, 3>(2, 3 * a) =
              .5 * (slopes(a, 1) * axes.col(0) + slopes(a, 0) * axes.col(1)).transpose();
          }
        operators.push_back(std::move(strain));
      }
    return operators;
  }

  void WorstStrain::add(const SurfaceTensor &strain)
  {
    const PrincipalStresses stresses =
      compute_principal_stresses(compute_surface_stress(strain, material_));
    const double size = std::max(stresses.first, -stresses.third);
    if (size <= largest_)
      return;
    largest_ = size;
    strain_  = strain;
  }
} // namespace vfife
