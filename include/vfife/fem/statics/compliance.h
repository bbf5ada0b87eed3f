// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_statics_compliance_h
#define vfife_fem_statics_compliance_h

#include <vfife/fem/fem_options.h>
#include <vfife/fem/solvers/direct_solver.h>
#include <vfife/fem/system/assembly.h>

#include <memory>
#include <vector>

namespace vfife
{
  /**
   * What all bodies of a model do under forces, in axes that turn with them; factorized once. Hubs
   * that turn freely are pinned about the axis: the pin carries nothing where loads have no moment
   * about the axis, and the rotation of such a body is an unknown of whoever asks
   * (PairEquilibrium).
   *
   * In spin the matrix is the tangent K(u0) - Omega^2 S (+ curvature of the hub) at the state of
   * spin u0 (doc/fem.md). All functions are collective; results are equal on all ranks.
   */
  class Compliance
  {
  public:
    /** Throws InputError where a body can move otherwise than by turning on its hub, NumericalError
     * where the speed is too high. */
    Compliance(const Model        &model,
               const FemOptions   &options,
               bool                centrifugal,
               const Communicator &communicator);

    const Discretization &discretization() const
    {
      return discretization_;
    }

    /** Displacements of all points (3 a point) under centrifugal forces alone [mm]; zero without.
     */
    const std::vector<double> &spun() const
    {
      return spun_;
    }
    /** Displacements of all points under the model's torques in full [mm]. */
    const std::vector<double> &twisted() const
    {
      return twisted_;
    }

    /** Displacements of all points [mm] under forces given at all points [N]. */
    std::vector<double> solve(const std::vector<double> &forces) const;

    /** Points at which displacements under unit forces are kept (3 rows a point, in this order).
     * Forgets what is known. */
    void watch(std::vector<unsigned int> points);

    const std::vector<unsigned int> &watched() const
    {
      return watched_;
    }

    /** Solves for unit forces at the @p rows (3 * place in watched() + component) that are not yet
     * known. */
    void prepare(const std::vector<unsigned int> &rows);

    /** Displacements at the watched points under a unit force at @p row, which is prepared. */
    Eigen::Ref<const Eigen::VectorXd> column(unsigned int row) const
    {
      return columns_[row];
    }

    unsigned int n_unknowns() const
    {
      return assembly_->unknowns().n();
    }
    /** Unit forces solved for so far. */
    unsigned int n_prepared() const
    {
      return n_prepared_;
    }
    double memory() const
    {
      return solver_->memory(); ///< of the factors on all ranks [MB]
    }

  private:
    void check_motions() const;
    void factorize(const SparseValues &K);

    const Model                  &model_;
    const Communicator           &communicator_;
    Discretization                discretization_;
    std::unique_ptr<Assembly>     assembly_;
    std::unique_ptr<DirectSolver> solver_;
    std::vector<double>           spun_, twisted_;
    std::vector<unsigned int>     watched_;
    std::vector<Eigen::VectorXd>  columns_; ///< empty: not known
    unsigned int                  n_prepared_ = 0;
  };
} // namespace vfife

#endif
