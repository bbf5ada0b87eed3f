// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "dual_means.h"

#include <vfife/fem/statics/facet_parts.h>
#include <vfife/fem/system/element_integrals.h>
#include <vfife/fem/system/load_forces.h>
#include <vfife/model/load_shares.h>

#include <algorithm>
#include <set>

namespace vfife
{
  namespace
  {
    FacetParts::Corners ascending(FacetParts::Corners corners)
    {
      std::sort(corners.begin(), corners.end());
      return corners;
    }
  } // namespace

  FacetParts::FacetParts(const FemSpace &space)
  {
    if (!space.options().divides_facets)
      {
        means_ = NodeAverages(space).all();
        return;
      }
    const unsigned int n = space.degree() + 1;
    DualMeans          means;
    for (const auto &[part, faces] : find_divided_faces(space))
      for (const BoundaryFace &face : faces)
        {
          Corners facet;
          for (unsigned int k = 0; k < 4; ++k)
            facet[k] = part->first_point + face.nodes[k];
          std::vector<Corners> &own = parts_[ascending(facet)];
          for (const auto &[points, X] : points_of_face(space, *part, face))
            {
              const auto   parts  = compute_face_part_points(X);
              unsigned int number = 0;
              for (unsigned int j = 0; j + 1 < n; ++j)
                for (unsigned int i = 0; i + 1 < n; ++i)
                  {
                    const unsigned int first = i + n * j;
                    own.push_back({{points[first],
                                    points[first + 1],
                                    points[first + n + 1],
                                    points[first + n]}});
                    DualMeans::Quadrilateral quadrilateral;
                    for (const FacePartPoint &at : parts[number++])
                      quadrilateral.add(at.normal.norm(), at.bilinear, points, at.N);
                    means.add(quadrilateral, own.back());
                  }
            }
        }
    means_ = means.find();
  }

  std::vector<FacetParts::Corners> FacetParts::of(const Corners &facet) const
  {
    const auto found = parts_.find(ascending(facet));
    return found != parts_.end() ? found->second : std::vector<Corners>{facet};
  }

  PointWeights FacetParts::mean_of(const unsigned int point) const
  {
    const auto found = means_.find(point);
    return found != means_.end() ? found->second : PointWeights{{point, 1.}};
  }

  std::vector<unsigned int> FacetParts::points_within(const std::vector<unsigned int> &nodes) const
  {
    const std::set<unsigned int> inside(nodes.begin(), nodes.end());
    std::set<unsigned int>       points;
    for (const auto &[facet, parts] : parts_)
      if (std::all_of(facet.begin(), facet.end(), [&](const unsigned int node) {
            return inside.count(node) > 0;
          }))
        for (const Corners &part : parts)
          points.insert(part.begin(), part.end());
    return {points.begin(), points.end()};
  }
} // namespace vfife
