// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "dof_level.h"

#include <vfife/base/process/communicator.h>

#include <deal.II/dofs/dof_accessor.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>

namespace vfife
{
  DofLevel::DofLevel(const DistributedMesh &mesh,
                     const unsigned int     degree,
                     const Communicator    &communicator)
    : mesh_(mesh)
    , degree_(degree)
    , communicator_(communicator)
    , dofs_(mesh.triangulation())
  {
    const dealii::FE_Q<3>     scalar(degree);
    const dealii::FESystem<3> element(scalar, 3);
    dofs_.distribute_dofs(element);
    for (const unsigned int j : dealii::FETools::lexicographic_to_hierarchic_numbering<3>(degree))
      {
        unit_points_.push_back(scalar.get_unit_support_points()[j]);
        numbers_.push_back({{element.component_to_system_index(0, j),
                             element.component_to_system_index(1, j),
                             element.component_to_system_index(2, j)}});
      }
    relevant_ = dealii::DoFTools::extract_locally_relevant_dofs(dofs_);
    hanging_  = make_lines();
    dealii::DoFTools::make_hanging_node_constraints(dofs_, hanging_);
    hanging_.close();
  }

  DistributedVector DofLevel::make_vector() const
  {
    return DistributedVector(owned(), relevant_, communicator_.mpi());
  }

  ConstraintLines DofLevel::make_lines() const
  {
#if DEAL_II_VERSION_GTE(9, 6, 0)
    return ConstraintLines(owned(), relevant_);
#else
    return ConstraintLines(relevant_);
#endif
  }

  DofLevel::Element
  DofLevel::make_element(const dealii::Triangulation<3>::active_cell_iterator &cell) const
  {
    Element element{{&mesh_.triangulation(), cell->level(), cell->index(), &dofs_},
                    mesh_.place_of(cell),
                    {}};
    std::vector<dealii::types::global_dof_index> dofs(3 * numbers_.size());
    element.cell->get_dof_indices(dofs);
    for (const auto &of_point : numbers_)
      element.points.push_back({{dofs[of_point[0]], dofs[of_point[1]], dofs[of_point[2]]}});
    return element;
  }

  void DofLevel::for_elements(const std::function<void(const Element &)> &act,
                              const bool                                  ghosts) const
  {
    for (const auto &cell : mesh_.triangulation().active_cell_iterators())
      if (cell->is_locally_owned() || (ghosts && cell->is_ghost()))
        act(make_element(cell));
  }

  void DofLevel::set_places(const std::function<ElementNodes(const Element &)> &places_of)
  {
    places_ = make_vector();
    for_elements([&](const Element &element) {
      const ElementNodes X = places_of(element);
      for (std::size_t a = 0; a < element.points.size(); ++a)
        for (unsigned int c = 0; c < 3; ++c)
          if (owned().is_element(element.points[a][c]))
            places_(element.points[a][c]) = X(c, a);
    });
    hanging_.distribute(places_);
    places_.update_ghost_values();
  }

  ElementNodes DofLevel::element_nodes(const Element &element) const
  {
    return gather(element, places_);
  }

  std::vector<DistributedVector> DofLevel::make_rigid_motions(const Vector3 &centre) const
  {
    std::vector<DistributedVector> motions(6, make_vector());
    for_elements([&](const Element &element) {
      for (const PointDofs &dofs : element.points)
        if (owned().is_element(dofs[0]))
          for (unsigned int d = 0; d < 3; ++d)
            {
              motions[d](dofs[d]) = 1.;
              const Vector3 turn  = Vector3::Unit(d).cross(value_at(dofs, places_) - centre);
              for (unsigned int c = 0; c < 3; ++c)
                motions[3 + d](dofs[c]) = turn[c];
            }
    });
    return motions;
  }

  std::vector<double> owned_part(const DistributedVector &vector)
  {
    return std::vector<double>(vector.begin(), vector.begin() + vector.locally_owned_size());
  }

  void copy_owned(const double *const values, DistributedVector &vector)
  {
    std::copy_n(values, vector.locally_owned_size(), vector.begin());
  }

  ElementNodes gather(const DofLevel::Element &element, const DistributedVector &values)
  {
    ElementNodes of_points(3, element.points.size());
    for (std::size_t a = 0; a < element.points.size(); ++a)
      of_points.col(a) = value_at(element.points[a], values);
    return of_points;
  }

  Vector3 value_at(const PointDofs &dofs, const DistributedVector &values)
  {
    return Vector3(values(dofs[0]), values(dofs[1]), values(dofs[2]));
  }
} // namespace vfife
