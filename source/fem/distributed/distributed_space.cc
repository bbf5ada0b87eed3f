// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "distributed_space.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <sstream>

namespace vfife
{
  DistributedSpace::DistributedSpace(const Body            &body,
                                     const FemSpaceOptions &options,
                                     const Communicator    &communicator)
    : communicator_(communicator)
    , element_(options.element)
    , mesh_(body, read_local_refinements(options.local_refinement), communicator)
    , level_(mesh_, degree_of(options.element), communicator)
    , trilinear_(mesh_, 1, communicator)
    , mapping_(level_.degree())
  {
    place_trilinear();
    place_points(level_.degree() > 1 ? options.geometry : FemGeometry::straight);
    mapping_.initialize(dealii::MappingQ<3>(1), level_.dofs(), level_.places(), false);
    check_folds();
    find_nodes();
  }

  void DistributedSpace::place_trilinear()
  {
    trilinear_.set_places([this](const DofLevel::Element &element) {
      ElementNodes X(3, 8);
      for (unsigned int v = 0; v < 8; ++v)
        {
          const dealii::Point<3> &x = element.cell->vertex(v);
          X.col(v)                  = body().placement(Vector3(x[0], x[1], x[2]));
        }
      return X;
    });
  }

  void DistributedSpace::place_points(const FemGeometry geometry)
  {
    const unsigned int degree = level_.degree();
    if (geometry == FemGeometry::straight)
      {
        level_.set_places([this](const DofLevel::Element &element) {
          const ElementNodes corners =
            trilinear_.element_nodes(trilinear_.make_element(element.cell));
          ElementNodes X = ElementNodes::Zero(3, element.points.size());
          for (unsigned int a = 0; a < element.points.size(); ++a)
            for (unsigned int v = 0; v < 8; ++v)
              X.col(a) +=
                dealii::GeometryInfo<3>::d_linear_shape_function(level_.unit_points()[a], v) *
                corners.col(v);
          return X;
        });
        return;
      }
    const dealii::MappingQ<3> mapping(degree);
    const dealii::FE_Q<3>     scalar(degree);
    dealii::FEValues<3>       values(mapping,
                               scalar,
                               dealii::Quadrature<3>(level_.unit_points()),
                               dealii::update_quadrature_points);
    level_.set_places([&](const DofLevel::Element &element) {
      values.reinit(dealii::Triangulation<3>::cell_iterator(element.cell));
      ElementNodes X(3, element.points.size());
      for (unsigned int a = 0; a < element.points.size(); ++a)
        {
          const dealii::Point<3> &x = values.quadrature_point(a);
          X.col(a)                  = body().placement(Vector3(x[0], x[1], x[2]));
        }
      return X;
    });
  }

  void DistributedSpace::check_folds() const
  {
    std::string fold;
    level_.for_elements([&](const DofLevel::Element &element) {
      if (!fold.empty())
        return;
      const JacobianPoint least = find_least_jacobian(level_.element_nodes(element));
      if (least.determinant > 0.)
        return;
      const Vector3 place =
        body().placement.rotation.transpose() * (least.place - body().placement.translation);
      std::ostringstream text;
      text << "body \"" << body().name() << "\": element " << element.place.element
           << " is folded where its edges follow the true surfaces: its Jacobian determinant is "
           << least.determinant << " mm^3 at (" << place[0] << ", " << place[1] << ", " << place[2]
           << ") mm. Make the mesh finer there, or set Fem/geometry = straight.";
      fold = text.str();
    });
    for (const std::string &of_rank : communicator_.all_gather(fold))
      if (!of_rank.empty())
        throw NumericalError(of_rank);
  }

  void DistributedSpace::find_nodes()
  {
    const dealii::types::global_dof_index none = dealii::numbers::invalid_dof_index;
    dofs_of_nodes_.assign(body().n_nodes(), {{none, none, none}});
    level_.for_elements([this](const DofLevel::Element &element) {
      for (std::size_t a = 0; a < element.points.size(); ++a)
        if (level_.owned().is_element(element.points[a][0]))
          {
            const auto nodes = mesh_.nodes_around(element.place, level_.unit_points()[a]);
            if (nodes.size() == 1)
              dofs_of_nodes_[nodes[0]] = element.points[a];
          }
    });
  }

  std::vector<double> DistributedSpace::values_at_nodes(const DistributedVector &u) const
  {
    std::vector<double> values(3 * dofs_of_nodes_.size(), 0.);
    for (std::size_t node = 0; node < dofs_of_nodes_.size(); ++node)
      if (dofs_of_nodes_[node][0] != dealii::numbers::invalid_dof_index)
        for (unsigned int c = 0; c < 3; ++c)
          values[3 * node + c] = u(dofs_of_nodes_[node][c]);
    communicator_.sum(values);
    return values;
  }
} // namespace vfife
