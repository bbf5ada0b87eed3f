// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "two_levels.h"

#include <vfife/base/process/communicator.h>

#include <deal.II/lac/full_matrix.h>

namespace vfife
{
  namespace
  {
    /** Of the trilinear cells, K + sigma M with straight edges. */
    dealii::FullMatrix<double> compute_trilinear_matrix(const DistributedSpace  &space,
                                                        const DofLevel::Element &element,
                                                        const MassKind           mass,
                                                        const double             sigma)
    {
      const ElementNodes X        = space.trilinear().element_nodes(element);
      const Material    &material = space.body().material(element.place.element);
      Eigen::MatrixXd    K        = compute_fem_stiffness(X, material, FemElement::full);
      if (sigma != 0.)
        K += sigma * expand_coefficients(compute_mass_coefficients(X, material.density, mass),
                                         Matrix3::Identity());
      dealii::FullMatrix<double> matrix(K.rows(), K.cols());
      for (Eigen::Index i = 0; i < K.rows(); ++i)
        for (Eigen::Index j = 0; j < K.cols(); ++j)
          matrix(i, j) = K(i, j);
      return matrix;
    }
  } // namespace

  TwoLevels::TwoLevels(const ElasticOperator  &fine,
                       const DistributedSpace &space,
                       const Model            &model,
                       const unsigned int      body,
                       const ConstraintLines  &lines,
                       const MassKind          mass,
                       const double            sigma)
    : fine_(fine)
    , communicator_(space.communicator())
    , supports_(model, body, space.trilinear())
    , one_level_(space.level().degree() == 1)
  {
    const DofLevel &trilinear = space.trilinear();
    coarse_                   = std::make_unique<MultigridSolver>(
      trilinear.dofs(),
      supports_.lines(),
      [&](const auto &cell) {
        return compute_trilinear_matrix(space, trilinear.make_element(cell), mass, sigma);
      },
      supports_.unknowns_of(trilinear.make_rigid_motions(space.body().axis.point)),
      communicator_);
    coarse_rest_ = trilinear.make_vector();
    correction_  = trilinear.make_vector();
    if (one_level_)
      return;
    transfer_.reinit_polynomial_transfer(space.level().dofs(),
                                         trilinear.dofs(),
                                         lines,
                                         supports_.lines());
    rest_ = fine.make_unknowns();

    DistributedVector inverse = fine.stiffness_diagonal();
    if (sigma != 0.)
      inverse.add(sigma, fine.mass_diagonal());
    for (double &value : inverse)
      value = 1. / value;
    Smoother::AdditionalData data;
    data.preconditioner = std::make_shared<dealii::DiagonalMatrix<DistributedVector>>();
    data.preconditioner->reinit(inverse);
    data.constraints.copy_from(lines);
    // The upper part of the spectrum, above a twentieth of the largest eigenvalue.
    data.degree              = 4;
    data.smoothing_range     = 20.;
    data.eig_cg_n_iterations = 15;
    smoother_.initialize(fine, data);
  }

  void TwoLevels::solve_coarse(DistributedVector &x, const DistributedVector &b) const
  {
    const Columns right_side(communicator_, {owned_part(b)});
    Columns       solution(communicator_, right_side.n_rows(), 1);
    coarse_->cycle().apply(right_side, solution);
    copy_owned(solution[0].data(), x);
    supports_.clear_dependent(x);
  }

  void TwoLevels::vmult(DistributedVector &x, const DistributedVector &b) const
  {
    if (one_level_)
      {
        solve_coarse(x, b);
        return;
      }
    smoother_.vmult(x, b);
    fine_.vmult(rest_, x);
    rest_.sadd(-1., 1., b);
    coarse_rest_ = 0.;
    transfer_.restrict_and_add(coarse_rest_, rest_);
    solve_coarse(correction_, coarse_rest_);
    transfer_.prolongate_and_add(x, correction_);
    smoother_.step(x, b);
  }
} // namespace vfife
