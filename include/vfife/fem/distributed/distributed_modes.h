// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_distributed_distributed_modes_h
#define vfife_fem_distributed_distributed_modes_h

#include <vfife/fem/modes/rotating_body.h>
#include <vfife/mesh/mesh_fields.h>

#include <memory>

namespace vfife
{
  /**
   * Vibrations of one body at rest on a mesh that is distributed to the ranks: LOBPCG without a
   * matrix, with two levels as preconditioner (doc/theory/fem.md). Modes are not counted. What of a
   * model it does not take, check_distributed() refuses.
   */
  class DistributedModes
  {
  public:
    /** Collective. */
    DistributedModes(const Model        &model,
                     unsigned int        body,
                     const FemOptions   &options,
                     const Communicator &communicator);
    ~DistributedModes();

    /** Collective. Throws InputError for more modes than the mesh has, NumericalError where the
     * solver fails. */
    ModesAtSpeed find_modes();

    unsigned int n_iterations() const;

    /** The shapes, once found: largest displacement of a node of the body 1 mm. */
    MeshFields fields() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
  };
} // namespace vfife

#endif
