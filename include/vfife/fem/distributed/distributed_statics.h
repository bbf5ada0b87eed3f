// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_distributed_distributed_statics_h
#define vfife_fem_distributed_distributed_statics_h

#include <vfife/fem/statics/nodal_solution.h>
#include <vfife/mesh/mesh_fields.h>

#include <functional>
#include <memory>

namespace vfife
{
  /**
   * Small displacements of one body at rest on a mesh that is distributed to the ranks: conjugate
   * gradients without a matrix, with two levels as preconditioner (doc/theory/fem.md). What of a
   * model it does not take, check_distributed() refuses.
   */
  class DistributedStatics
  {
  public:
    /** Throws InputError where the body can move rigidly. Collective. */
    DistributedStatics(const Model        &model,
                       unsigned int        body,
                       const FemOptions   &options,
                       const Communicator &communicator);
    ~DistributedStatics();

    /** Of the loads their parts or their time. Collective; throws NumericalError where the solver
     * fails. */
    NodalSolution solve(const StaticLoads &loads);

    /** Place and displacement [mm] of each point of this rank's cells, once solved. */
    void for_points(const std::function<void(const Vector3 &, const Vector3 &)> &act) const;

    /** The displacements, once solved. */
    MeshFields fields() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
  };
} // namespace vfife

#endif
