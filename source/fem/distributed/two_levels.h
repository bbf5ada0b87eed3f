// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_fem_distributed_two_levels_h
#define vfife_source_fem_distributed_two_levels_h

#include "elastic_operator.h"

#include <vfife/fem/solvers/multigrid_solver.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include <memory>

namespace vfife
{
  /**
   * About the inverse of an ElasticOperator: Chebyshev's polynomial of its diagonal before and
   * after a correction by trilinear elements, for which one cycle of algebraic multigrid is done.
   * Of trilinear elements that cycle alone. Symmetric. All functions are collective.
   */
  class TwoLevels
  {
  public:
    /** Of K + sigma M, which @p fine has and must outlive this. Throws InputError where deal.II has
     * no algebraic multigrid. */
    TwoLevels(const ElasticOperator  &fine,
              const DistributedSpace &space,
              const Model            &model,
              unsigned int            body,
              const ConstraintLines  &lines,
              MassKind                mass,
              double                  sigma);

    void vmult(DistributedVector &x, const DistributedVector &b) const;

  private:
    using Smoother = dealii::PreconditionChebyshev<ElasticOperator,
                                                   DistributedVector,
                                                   dealii::DiagonalMatrix<DistributedVector>>;

    /** One cycle for b on the trilinear elements. */
    void solve_coarse(DistributedVector &x, const DistributedVector &b) const;

    const ElasticOperator           &fine_;
    const Communicator              &communicator_;
    DistributedSupports              supports_; ///< of the trilinear elements
    std::unique_ptr<MultigridSolver> coarse_;
    bool                             one_level_;

    dealii::MGTwoLevelTransfer<3, DistributedVector> transfer_;
    Smoother                                         smoother_;
    mutable DistributedVector                        rest_, coarse_rest_, correction_;
  };
} // namespace vfife

#endif
