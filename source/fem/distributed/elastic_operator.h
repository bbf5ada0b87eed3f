// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_fem_distributed_elastic_operator_h
#define vfife_source_fem_distributed_elastic_operator_h

#include "distributed_space.h"
#include "distributed_supports.h"

#include <deal.II/base/aligned_vector.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <vector>

#if DEAL_II_VERSION_GTE(9, 7, 0)
#  include <deal.II/base/enable_observer_pointer.h>
#else
#  include <deal.II/base/subscriptor.h>
#endif

namespace vfife
{
#if DEAL_II_VERSION_GTE(9, 7, 0)
  using ObservedByPreconditioner = dealii::EnableObserverPointer;
#else
  using ObservedByPreconditioner = dealii::Subscriptor;
#endif

  /**
   * Stiffness and mass of a distributed body without a matrix (dealii::MatrixFree): K + sigma M on
   * the unknowns, T^T A T; what is no unknown has ones on the diagonal of K and zeros in M. Linear
   * isotropic elasticity with the points of compute_element_points(). All functions are collective.
   */
  class ElasticOperator : public ObservedByPreconditioner
  {
  public:
    /** All arguments must outlive this. */
    ElasticOperator(const DistributedSpace    &space,
                    const DistributedSupports &supports,
                    MassKind                   mass);

    /** Zeros, for the functions below. */
    DistributedVector make_unknowns() const;

    void set_shift(const double sigma)
    {
      shift_ = sigma;
    }

    /** y = (K + sigma M) x. */
    void vmult(DistributedVector &y, const DistributedVector &x) const;
    void apply_stiffness(DistributedVector &y, const DistributedVector &x) const;
    void apply_mass(DistributedVector &y, const DistributedVector &x) const;

    /** Forces of displacements @p u without any support: what hangs moves as its masters do and
     * passes its force on to them. */
    DistributedVector stiffness_forces(const DistributedVector &u) const;
    DistributedVector mass_forces(const DistributedVector &u) const;

    /** Of K and M; ones and zeros at what is no unknown. */
    DistributedVector stiffness_diagonal() const;
    DistributedVector mass_diagonal() const;

    // What dealii::PreconditionChebyshev names: the number of rows, and entries that it does not
    // ask for where the diagonal is given.
    dealii::types::global_dof_index m() const
    {
      return supports_.level().dofs().n_dofs();
    }
    double el(dealii::types::global_dof_index, dealii::types::global_dof_index) const
    {
      return 0.;
    }

  private:
    using Number = dealii::VectorizedArray<double>;
    /** Of any degree and number of points. */
    using Cells = dealii::FEEvaluation<3, -1, 0, 3, double>;

    struct Moduli
    {
      Number lambda, mu, density;
    };

    enum class Part
    {
      stiffness,
      mass
    };

    void         find_moduli();
    void         add_stiffness(Cells &cells) const;
    void         add_mass(Cells &cells) const;
    unsigned int rule_of(const Part part) const
    {
      return part == Part::mass ? mass_rule_ : 0;
    }
    /** y = T^T A T x with one or the other lines. */
    void
    loop(Part part, unsigned int lines, DistributedVector &y, const DistributedVector &x) const;
    DistributedVector forces_of(Part part, const DistributedVector &u) const;
    DistributedVector diagonal(Part part, double of_dependent) const;

    const DistributedSupports    &supports_;
    bool                          sums_rows_; ///< mass of trilinear elements
    unsigned int                  mass_rule_;
    double                        shift_ = 0;
    dealii::MatrixFree<3, double> data_;
    dealii::AlignedVector<Moduli> moduli_;    ///< of batches of cells
    std::vector<unsigned int>     dependent_; ///< local numbers
    mutable DistributedVector     of_mass_;
  };
} // namespace vfife

#endif
