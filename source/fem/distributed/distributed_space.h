// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_fem_distributed_distributed_space_h
#define vfife_source_fem_distributed_distributed_space_h

#include "dof_level.h"

#include <deal.II/fe/mapping_q_cache.h>

namespace vfife
{
  /** The displacements of a body on a distributed mesh: those of its elements, trilinear ones of
   * the same cells for the solver, and the mapping by the places of the points. */
  class DistributedSpace
  {
  public:
    /** Throws InputError as DistributedMesh does, and NumericalError with element and place where a
     * cell is folded. Collective. */
    DistributedSpace(const Body            &body,
                     const FemSpaceOptions &options,
                     const Communicator    &communicator);

    const Body &body() const
    {
      return mesh_.body();
    }
    const DistributedMesh &mesh() const
    {
      return mesh_;
    }
    FemElement element() const
    {
      return element_;
    }
    const DofLevel &level() const
    {
      return level_;
    }
    const DofLevel &trilinear() const
    {
      return trilinear_;
    }
    const dealii::Mapping<3> &mapping() const
    {
      return mapping_;
    }
    const Communicator &communicator() const
    {
      return communicator_;
    }

    /** Values of @p u at the body's own nodes, 3 a node, on all ranks. Collective. */
    std::vector<double> values_at_nodes(const DistributedVector &u) const;

    /** The degrees of freedom of the nodes that this rank owns, by node; invalid ones elsewhere. */
    const std::vector<PointDofs> &dofs_of_nodes() const
    {
      return dofs_of_nodes_;
    }

  private:
    void place_trilinear();
    void place_points(FemGeometry geometry);
    void check_folds() const;
    void find_nodes();

    const Communicator      &communicator_;
    FemElement               element_;
    DistributedMesh          mesh_;
    DofLevel                 level_, trilinear_;
    dealii::MappingQCache<3> mapping_;
    std::vector<PointDofs>   dofs_of_nodes_;
  };
} // namespace vfife

#endif
