// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/element_integrals.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/load_shares.h>
#include <vfife/study/fillets/face_strains.h>
#include <vfife/study/fillets/facet_readings.h>

namespace vfife
{
  std::vector<PointReading> read_facet(const FemSpace                    &sector,
                                       const std::array<unsigned int, 4> &facet)
  {
    const FemSpace::Part     &part  = sector.parts().front();
    const Body               &body  = sector.model().bodies[part.body];
    const Matrix3            &R     = body.placement.rotation;
    const Vector3             along = R * direction_along_face(body, facet);
    std::vector<PointReading> readings;
    for (const BoundaryFace &face : find_boundary_faces(body, {facet.begin(), facet.end()}))
      for (const auto &[points, X] : points_of_face(sector, part, face))
        {
          for (const Eigen::MatrixXd &strain : list_face_strains(X, along, sector.degree()))
            for (Eigen::Index k = 0; k < strain.rows(); ++k)
              {
                readings.emplace_back();
                for (std::size_t a = 0; a < points.size(); ++a)
                  readings.back().emplace_back(points[a],
                                               R.transpose() *
                                                 strain.block<1, 3>(k, 3 * a).transpose());
              }
        }
    return readings;
  }

  PointReading read_traction(const FemSpace &sector, const std::array<unsigned int, 4> &facet)
  {
    const FemSpace::Part &part = sector.parts().front();
    const Body           &body = sector.model().bodies[part.body];
    const Matrix3         back = body.placement.rotation.transpose();
    const auto            faces =
      find_boundary_faces(body, std::vector<unsigned int>(facet.begin(), facet.end()));
    PointReading reading;
    for (const BoundaryFace &face : faces)
      {
        const unsigned int              e        = part.first_element + face.element;
        const Material                 &material = sector.material(e);
        const std::vector<ElementPoint> points   = compute_element_points(sector.element_nodes(e));
        // Means of quadratic functions over the 2 x 2 Gauss points are those over the face:
        // Simpson's rule. Stresses at the face's points are extrapolated from the element's.
        constexpr std::array<double, 3> simpson = {{1. / 6., 4. / 6., 1. / 6.}};
        const std::vector<unsigned int> on_face = numbers_on_face(2, face.number);
        Eigen::VectorXd                 mean    = Eigen::VectorXd::Zero(points.size());
        for (unsigned int p = 0; p < on_face.size(); ++p)
          mean += simpson[p % 3] * simpson[p / 3] * point_extrapolation(2).col(on_face[p]);
        const std::vector<FacePoint> of_face =
          compute_face_points(points_of_face(sector, part, face).front().second);
        const Vector3 normal = of_face[of_face.size() / 2].normal.normalized();
        for (unsigned int a = 0; a < sector.points_per_element(); ++a)
          {
            // n.(lambda tr(e) 1 + 2 mu e).n
            Vector3 weight = Vector3::Zero();
            for (std::size_t q = 0; q < points.size(); ++q)
              {
                const Vector3 g = points[q].gradients.col(a);
                weight +=
                  mean[q] * (material.lambda() * g + 2. * material.mu() * normal.dot(g) * normal);
              }
            reading.emplace_back(sector.element_points(e)[a],
                                 back * weight / static_cast<double>(faces.size()));
          }
      }
    return reading;
  }
} // namespace vfife
