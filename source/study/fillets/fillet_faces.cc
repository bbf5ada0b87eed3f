// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/load_shares.h>
#include <vfife/study/fillets/face_strains.h>
#include <vfife/study/fillets/fillet_faces.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    std::array<unsigned int, 4> sorted(std::array<unsigned int, 4> nodes)
    {
      std::sort(nodes.begin(), nodes.end());
      return nodes;
    }
  } // namespace

  FilletFaces::FilletFaces(const FemSpace &space, const std::deque<MemberFillet> &fillets)
    : space_(&space)
  {
    for (const MemberFillet &member : fillets)
      {
        const FemSpace::Part &part = *space.find_part(member.body);
        const Body           &body = space.model().bodies[member.body];
        for (const BoundaryFace &face : find_boundary_faces(body, member.fillet.list_nodes()))
          faces_[{member.body, sorted(face.nodes)}] =
            space.points_on_face(part, face.element, face.number);
      }
  }

  FilletStrains FilletFaces::of(const std::vector<double> &u) const
  {
    const auto at_node = [this, &u](const unsigned int body, const unsigned int node) {
      const std::size_t point = space_->find_part(body)->first_point + node;
      return Vector3(space_->model().bodies[body].placement.rotation.transpose() *
                     Eigen::Map<const Vector3>(u.data() + 3 * point));
    };
    FilletStrains strains = strains_of_displacements(space_->model(), at_node);
    strains.facet         = [this, &u](const MemberFillet &member,
                               const unsigned int  column,
                               const unsigned int  row,
                               const unsigned int  tooth) {
      return of_facet(member, column, row, tooth, u);
    };
    return strains;
  }

  SurfaceTensor FilletFaces::of_facet(const MemberFillet        &member,
                                      const unsigned int         column,
                                      const unsigned int         row,
                                      const unsigned int         tooth,
                                      const std::vector<double> &u) const
  {
    const auto    nodes = member.fillet.facet(column, row, tooth);
    const Body   &body  = space_->model().bodies[member.body];
    const Vector3 along = body.placement.rotation * direction_along_face(body, nodes);
    WorstStrain   worst(member.fillet.material());
    for (const auto &points : faces_.at({member.body, sorted(nodes)}))
      {
        ElementNodes    X(3, points.size());
        Eigen::VectorXd v(3 * points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
          {
            X.col(i)            = space_->points()[points[i]];
            v.segment<3>(3 * i) = Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(points[i]));
          }
        for (const Eigen::MatrixXd &strain : list_face_strains(X, along, space_->degree()))
          worst.add(member.fillet.without_initial_strain(strain * v, column, row, tooth));
      }
    return worst.strain();
  }
} // namespace vfife
