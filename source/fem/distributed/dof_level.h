// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_fem_distributed_dof_level_h
#define vfife_source_fem_distributed_dof_level_h

#include "distributed_mesh.h"

#include <vfife/fem/system/element_integrals.h>

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <functional>
#include <vector>

namespace vfife
{
  using DistributedVector = dealii::LinearAlgebra::distributed::Vector<double>;
  using ConstraintLines   = dealii::AffineConstraints<double>;

  /** The degrees of freedom of the three components of a point. */
  using PointDofs = std::array<dealii::types::global_dof_index, 3>;

  /** Displacements of one degree on a distributed mesh, and the places of their points in the fixed
   * frame: a field of their own space. */
  class DofLevel
  {
  public:
    struct Element
    {
      dealii::DoFHandler<3>::active_cell_iterator cell;
      DistributedMesh::Place                      place;
      std::vector<PointDofs>                      points; ///< lexicographic
    };

    DofLevel(const DistributedMesh &mesh, unsigned int degree, const Communicator &communicator);

    const DistributedMesh &mesh() const
    {
      return mesh_;
    }
    unsigned int degree() const
    {
      return degree_;
    }
    const dealii::DoFHandler<3> &dofs() const
    {
      return dofs_;
    }
    const dealii::IndexSet &owned() const
    {
      return dofs_.locally_owned_dofs();
    }
    /** Owned ones and those of all cells that this rank knows. */
    const dealii::IndexSet &relevant() const
    {
      return relevant_;
    }
    /** Lines of points that hang. */
    const ConstraintLines &hanging() const
    {
      return hanging_;
    }
    /** Unit coordinates of an element's points, lexicographic. */
    const std::vector<dealii::Point<3>> &unit_points() const
    {
      return unit_points_;
    }

    /** Zeros, with entries for all relevant degrees of freedom. */
    DistributedVector make_vector() const;
    /** Without lines. */
    ConstraintLines make_lines() const;

    Element make_element(const dealii::Triangulation<3>::active_cell_iterator &cell) const;
    /** Of this rank's cells; with @p ghosts of all cells that it knows. */
    void for_elements(const std::function<void(const Element &)> &act, bool ghosts = false) const;

    /** Sets the places of the points of this rank's cells; what hangs lies as its line states.
     * Collective. */
    void set_places(const std::function<ElementNodes(const Element &)> &places_of);
    /** Fixed frame; may be called once they are set. */
    const DistributedVector &places() const
    {
      return places_;
    }
    ElementNodes element_nodes(const Element &element) const;

    /** Three displacements and three rotations about @p centre, at owned entries. */
    std::vector<DistributedVector> make_rigid_motions(const Vector3 &centre) const;

  private:
    const DistributedMesh        &mesh_;
    unsigned int                  degree_;
    const Communicator           &communicator_;
    dealii::DoFHandler<3>         dofs_;
    dealii::IndexSet              relevant_;
    ConstraintLines               hanging_;
    std::vector<dealii::Point<3>> unit_points_;
    /** Of the element's degrees of freedom, by point and component. */
    std::vector<std::array<unsigned int, 3>> numbers_;
    DistributedVector                        places_;
  };

  /** Values at the points of an element, a column each. */
  ElementNodes gather(const DofLevel::Element &element, const DistributedVector &values);

  /** The owned entries, and these set from numbers. */
  std::vector<double> owned_part(const DistributedVector &vector);
  void                copy_owned(const double *values, DistributedVector &vector);

  /** Three values of a point. */
  Vector3 value_at(const PointDofs &dofs, const DistributedVector &values);
} // namespace vfife

#endif
