// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "dual_means.h"

#include <vfife/contact/search/local_search.h>
#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/fem/statics/node_averages.h>
#include <vfife/fem/system/element_integrals.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/load_shares.h>

namespace vfife
{
  Vector2 place_on_facet(const std::array<Vector3, 4> &x, const Vector3 &at)
  {
    // The same normal everywhere.
    const FacetState facet{{x[0], x[1] - x[0], x[3] - x[0], x[0] - x[1] + x[2] - x[3]},
                           {(x[2] - x[0]).cross(x[3] - x[1]).normalized(),
                            Vector3::Zero(),
                            Vector3::Zero(),
                            Vector3::Zero()}};
    Projection       place;
    project_on_facet(facet, 0, at, place);
    return Vector2(place.xi, place.eta).cwiseMax(0.).cwiseMin(1.);
  }

  NodeAverages::NodeAverages(const FemSpace &space)
  {
    DualMeans means;
    for (const auto &[part, faces] : find_divided_faces(space))
      for (const BoundaryFace &face : faces)
        {
          std::array<unsigned int, 4> nodes;
          std::array<Vector3, 4>      corners;
          for (unsigned int k = 0; k < 4; ++k)
            {
              nodes[k]   = part->first_point + face.nodes[k];
              corners[k] = space.points()[nodes[k]];
            }
          DualMeans::Quadrilateral facet;
          for (const auto &[points, X] : points_of_face(space, *part, face))
            for (const FacePoint &at : compute_face_points(X))
              {
                const Vector2 place = place_on_facet(corners, X * at.N);
                const auto    phi   = bilinear_weights(place[0], place[1]);
                facet.add(at.normal.norm(),
                          Eigen::Map<const Eigen::Vector4d>(phi.data()),
                          points,
                          at.N);
              }
          means.add(facet, nodes);
        }
    means_ = means.find();
  }

  PointWeights NodeAverages::of(const unsigned int point) const
  {
    const auto found = means_.find(point);
    return found != means_.end() ? found->second : PointWeights{{point, 1.}};
  }
} // namespace vfife
