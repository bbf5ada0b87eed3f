// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/element_integrals.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/output/files/mode_writer.h>
#include <vfife/study/conventional/field_grid.h>

namespace vfife
{
  FieldGrid::FieldGrid(const FemSpace &space, const FemSpace::Part &part)
    : body_(space.model().bodies[part.body])
    , space_(space.degree() > 1 ? &space : nullptr)
    , part_(part)
  {
    if (space_)
      places_ = take(space.points().front().data(), 3);
  }

  FieldGrid::FieldGrid(const Body &body)
    : body_(body)
    , space_(nullptr)
    , part_{0, 0, 0, body.n_nodes(), 0, 0}
  {
  }

  Vector3 FieldGrid::reference(const unsigned int point) const
  {
    if (point < part_.n_nodes)
      return body_.node_positions()[point];
    const RigidMotion &placement = body_.placement;
    return placement.rotation.transpose() *
           (Eigen::Map<const Vector3>(places_.data() + 3 * std::size_t(point)) -
            placement.translation);
  }

  VtuGrid FieldGrid::make_grid() const
  {
    if (!space_)
      return vfife::make_grid(body_);
    VtuGrid grid;
    grid.degree = space_->degree();
    grid.points.assign(places_.begin(), places_.end());
    for (unsigned int e = part_.first_element; e < part_.first_element + part_.n_elements; ++e)
      for (unsigned int a = 0; a < space_->points_per_element(); ++a)
        grid.cells.push_back(space_->element_points(e)[a] - part_.first_point);
    return grid;
  }

  std::vector<double> FieldGrid::take(const double *values, const unsigned int n) const
  {
    const double *const first = values + n * std::size_t(part_.first_point);
    std::vector<double> taken(first, first + n * std::size_t(n_points()));
    if (!space_ || space_->degree() < 3)
      return taken;
    // Edges and faces that elements share have the same values from each of them.
    const Eigen::MatrixXd &even = even_places(space_->degree());
    Eigen::MatrixXd        own(n, space_->points_per_element());
    for (unsigned int e = part_.first_element; e < part_.first_element + part_.n_elements; ++e)
      {
        const unsigned int *points = space_->element_points(e);
        for (Eigen::Index a = 0; a < own.cols(); ++a)
          own.col(a) = Eigen::Map<const Eigen::VectorXd>(values + n * std::size_t(points[a]), n);
        const Eigen::MatrixXd moved = own * even;
        for (Eigen::Index a = 0; a < own.cols(); ++a)
          Eigen::Map<Eigen::VectorXd>(taken.data() + n * std::size_t(points[a] - part_.first_point),
                                      n) = moved.col(a);
      }
    return taken;
  }
} // namespace vfife
