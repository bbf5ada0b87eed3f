// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "elastic_operator.h"

#include <vfife/base/process/communicator.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>

namespace vfife
{
  namespace
  {
    // Numbers of the lines in MatrixFree, and of its rules.
    constexpr unsigned int of_supports = 0, of_hanging = 1;
    constexpr unsigned int gauss = 0, lobatto = 1;
  } // namespace

  ElasticOperator::ElasticOperator(const DistributedSpace    &space,
                                   const DistributedSupports &supports,
                                   const MassKind             mass)
    : supports_(supports)
    , sums_rows_(mass == MassKind::lumped && space.level().degree() == 1)
    , mass_rule_(mass == MassKind::lumped && space.level().degree() > 1 ? lobatto : gauss)
  {
    const DofLevel                    &level  = space.level();
    const unsigned int                 degree = level.degree();
    std::vector<dealii::Quadrature<1>> rules  = {dealii::QGauss<1>(n_gauss(degree))};
    if (mass_rule_ == lobatto)
      rules.push_back(dealii::QGaussLobatto<1>(degree + 1));
    dealii::MatrixFree<3, double>::AdditionalData data;
    data.tasks_parallel_scheme = dealii::MatrixFree<3, double>::AdditionalData::none;
    data.mapping_update_flags =
      dealii::update_gradients | dealii::update_values | dealii::update_JxW_values;
    const std::vector<const dealii::DoFHandler<3> *> dofs(2, &level.dofs());
    const std::vector<const ConstraintLines *>       lines = {&supports.lines(), &level.hanging()};
    data_.reinit(space.mapping(), dofs, lines, rules, data);
    for (const dealii::types::global_dof_index i : supports.dependent())
      dependent_.push_back(level.owned().index_within_set(i));
    data_.initialize_dof_vector(of_mass_, of_supports);
    find_moduli();
  }

  void ElasticOperator::find_moduli()
  {
    const DistributedMesh &mesh = supports_.level().mesh();
    moduli_.resize(data_.n_cell_batches());
    for (unsigned int batch = 0; batch < data_.n_cell_batches(); ++batch)
      for (unsigned int lane = 0; lane < data_.n_active_entries_per_cell_batch(batch); ++lane)
        {
          const auto      element     = mesh.place_of(data_.get_cell_iterator(batch, lane)).element;
          const Material &material    = mesh.body().material(element);
          moduli_[batch].lambda[lane] = material.lambda();
          moduli_[batch].mu[lane]     = material.mu();
          moduli_[batch].density[lane] = material.density;
        }
  }

  DistributedVector ElasticOperator::make_unknowns() const
  {
    DistributedVector vector;
    data_.initialize_dof_vector(vector, of_supports);
    return vector;
  }

  void ElasticOperator::add_stiffness(Cells &cells) const
  {
    const Moduli &moduli = moduli_[cells.get_current_cell_index()];
    cells.evaluate(dealii::EvaluationFlags::gradients);
    for (unsigned int q = 0; q < cells.n_q_points; ++q)
      {
        // 2 mu eps + lambda tr(eps) 1
        const auto   strain   = cells.get_symmetric_gradient(q);
        auto         stress   = 2. * moduli.mu * strain;
        const Number pressure = moduli.lambda * dealii::trace(strain);
        for (unsigned int d = 0; d < 3; ++d)
          stress[d][d] += pressure;
        cells.submit_symmetric_gradient(stress, q);
      }
    cells.integrate(dealii::EvaluationFlags::gradients);
  }

  void ElasticOperator::add_mass(Cells &cells) const
  {
    const Number           density = moduli_[cells.get_current_cell_index()].density;
    const unsigned int     n       = 3 * cells.dofs_per_component;
    std::array<Number, 24> u;
    if (sums_rows_)
      {
        // sum_b m_ab = rho int N_a dV
        std::copy_n(cells.begin_dof_values(), n, u.begin());
        dealii::Tensor<1, 3, Number> ones;
        for (unsigned int c = 0; c < 3; ++c)
          ones[c] = density;
        for (unsigned int q = 0; q < cells.n_q_points; ++q)
          cells.submit_value(ones, q);
        cells.integrate(dealii::EvaluationFlags::values);
        for (unsigned int i = 0; i < n; ++i)
          cells.begin_dof_values()[i] *= u[i];
        return;
      }
    cells.evaluate(dealii::EvaluationFlags::values);
    for (unsigned int q = 0; q < cells.n_q_points; ++q)
      cells.submit_value(density * cells.get_value(q), q);
    cells.integrate(dealii::EvaluationFlags::values);
  }

  void ElasticOperator::loop(const Part               part,
                             const unsigned int       lines,
                             DistributedVector       &y,
                             const DistributedVector &x) const
  {
    data_.template cell_loop<DistributedVector, DistributedVector>(
      [&](const auto &data, auto &out, const auto &in, const auto &range) {
        Cells cells(data, lines, rule_of(part));
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            cells.reinit(batch);
            cells.read_dof_values(in);
            if (part == Part::mass)
              add_mass(cells);
            else
              add_stiffness(cells);
            cells.distribute_local_to_global(out);
          }
      },
      y,
      x,
      true);
  }

  void ElasticOperator::vmult(DistributedVector &y, const DistributedVector &x) const
  {
    apply_stiffness(y, x);
    if (shift_ == 0.)
      return;
    apply_mass(of_mass_, x);
    y.add(shift_, of_mass_);
  }

  void ElasticOperator::apply_stiffness(DistributedVector &y, const DistributedVector &x) const
  {
    loop(Part::stiffness, of_supports, y, x);
    for (const unsigned int i : dependent_)
      y.local_element(i) = x.local_element(i);
  }

  void ElasticOperator::apply_mass(DistributedVector &y, const DistributedVector &x) const
  {
    loop(Part::mass, of_supports, y, x);
  }

  DistributedVector ElasticOperator::forces_of(const Part part, const DistributedVector &u) const
  {
    DistributedVector x, forces;
    data_.initialize_dof_vector(x, of_hanging);
    data_.initialize_dof_vector(forces, of_hanging);
    x.copy_locally_owned_data_from(u);
    loop(part, of_hanging, forces, x);
    return forces;
  }

  DistributedVector ElasticOperator::stiffness_forces(const DistributedVector &u) const
  {
    return forces_of(Part::stiffness, u);
  }

  DistributedVector ElasticOperator::mass_forces(const DistributedVector &u) const
  {
    return forces_of(Part::mass, u);
  }

  DistributedVector ElasticOperator::diagonal(const Part part, const double of_dependent) const
  {
    // Not by MatrixFreeTools::compute_diagonal(), which in deal.II 9.4.1 writes beyond its memory
    // where an element has several components. Of lines with several entries the squares of the
    // weights count, without the products between them: a smoother needs no more.
    const DofLevel        &level = supports_.level();
    const ConstraintLines &lines = supports_.lines();
    DistributedVector      sums  = level.make_vector();
    Cells                  cells(data_, of_supports, rule_of(part));
    const unsigned int     n_points = cells.dofs_per_component;
    std::vector<Number>    entries(3 * n_points);
    for (unsigned int batch = 0; batch < data_.n_cell_batches(); ++batch)
      {
        cells.reinit(batch);
        for (unsigned int i = 0; i < entries.size(); ++i)
          {
            for (unsigned int j = 0; j < entries.size(); ++j)
              cells.begin_dof_values()[j] = j == i ? 1. : 0.;
            if (part == Part::mass)
              add_mass(cells);
            else
              add_stiffness(cells);
            entries[i] = cells.begin_dof_values()[i];
          }
        for (unsigned int lane = 0; lane < data_.n_active_entries_per_cell_batch(batch); ++lane)
          {
            const auto points = level.make_element(data_.get_cell_iterator(batch, lane)).points;
            for (unsigned int i = 0; i < entries.size(); ++i)
              {
                const auto   dof   = points[i % n_points][i / n_points];
                const double entry = entries[i][lane];
                if (!lines.is_constrained(dof))
                  sums(dof) += entry;
                else
                  for (const auto &[on, weight] : *lines.get_constraint_entries(dof))
                    sums(on) += weight * weight * entry;
              }
          }
      }
    sums.compress(dealii::VectorOperation::add);
    DistributedVector diagonal = make_unknowns();
    diagonal.copy_locally_owned_data_from(sums);
    for (const unsigned int i : dependent_)
      diagonal.local_element(i) = of_dependent;
    return diagonal;
  }

  DistributedVector ElasticOperator::stiffness_diagonal() const
  {
    return diagonal(Part::stiffness, 1.);
  }

  DistributedVector ElasticOperator::mass_diagonal() const
  {
    return diagonal(Part::mass, 0.);
  }
} // namespace vfife
