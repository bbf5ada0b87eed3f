// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/statics/adaptive_refinement.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>

#include <algorithm>
#include <numeric>

namespace vfife
{
  namespace
  {
    using DofCell = dealii::DoFHandler<3>::active_cell_iterator;

    DofCell dof_cell(const FemSpace &space, const unsigned int e, const dealii::DoFHandler<3> &dofs)
    {
      const auto cell = space.cell(e);
      return {&dofs.get_triangulation(), cell->level(), cell->index(), &dofs};
    }
  } // namespace

  std::vector<double> estimate_errors(const FemSpace            &space,
                                      const std::vector<double> &displacements)
  {
    const unsigned int        degree = space.degree();
    const dealii::FESystem<3> element(dealii::FE_Q<3>(degree), 3);
    const bool is_curved = degree > 1 && space.options().geometry == FemGeometry::curved;
    const dealii::MappingQ<3> mapping(is_curved ? degree : 1);
    const auto          numbers = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(degree);
    std::vector<double> indicators(space.n_elements());
    for (const FemSpace::Part &part : space.parts())
      {
        const unsigned int    last = part.first_element + part.n_elements;
        const auto           &mesh = space.cell(part.first_element)->get_triangulation();
        dealii::DoFHandler<3> dofs(mesh);
        dofs.distribute_dofs(element);
        dealii::Vector<double>                       u(dofs.n_dofs());
        dealii::Vector<float>                        of_cells(mesh.n_active_cells());
        std::vector<dealii::types::global_dof_index> of_cell(element.n_dofs_per_cell());
        for (unsigned int e = part.first_element; e < last; ++e)
          {
            dof_cell(space, e, dofs)->get_dof_indices(of_cell);
            for (unsigned int a = 0; a < numbers.size(); ++a)
              for (unsigned int c = 0; c < 3; ++c)
                u[of_cell[element.component_to_system_index(c, numbers[a])]] =
                  displacements[3 * std::size_t(space.element_points(e)[a]) + c];
          }
        dealii::KellyErrorEstimator<3>::estimate(
          mapping, dofs, dealii::QGauss<2>(degree + 1), {}, u, of_cells);
        for (unsigned int e = part.first_element; e < last; ++e)
          indicators[e] = of_cells[space.cell(e)->active_cell_index()];
      }
    return indicators;
  }

  FemSpaceOptions::Division
  mark_elements(const FemSpace &space, const std::vector<double> &indicators, const double part)
  {
    std::vector<unsigned int> order(indicators.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](const unsigned int one, const unsigned int two) {
      return indicators[one] > indicators[two];
    });
    double whole = 0, held = 0;
    for (const double indicator : indicators)
      whole += indicator * indicator;
    FemSpaceOptions::Division division;
    for (std::size_t i = 0; i < order.size() && held < part * whole; ++i)
      {
        const FemSpace::Part &here = space.part_of_element(order[i]);
        division[here.body].push_back(order[i] - here.first_element);
        held += indicators[order[i]] * indicators[order[i]];
      }
    return division;
  }
} // namespace vfife
