// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
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
} // namespace vfife
