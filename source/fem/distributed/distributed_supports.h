// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_fem_distributed_distributed_supports_h
#define vfife_source_fem_distributed_distributed_supports_h

#include "dof_level.h"

#include <vfife/model/constraints/node_constraints.h>

namespace vfife
{
  /**
   * The constraints of a model on a level: u = T q + g. A held direction n is a line of the
   * component of largest |n|, and two of them are lines of all but the component that is largest
   * along the free direction; q are the other components. What hangs follows its masters, whatever
   * holds it.
   */
  class DistributedSupports
  {
  public:
    struct Point
    {
      PointDofs       dofs;
      Vector3         place; ///< fixed frame [mm]
      NodeConstraints constraints;
    };

    /** Throws InputError for constraints in conflict. */
    DistributedSupports(const Model &model, unsigned int body, const DofLevel &level);

    const DofLevel &level() const
    {
      return level_;
    }
    /** Of T, hanging points included; closed. */
    const ConstraintLines &lines() const
    {
      return lines_;
    }
    /** Owned entries that are no unknowns. */
    const std::vector<dealii::types::global_dof_index> &dependent() const
    {
      return dependent_;
    }
    /** Those that this rank owns and that do not hang. */
    const std::vector<Point> &points() const
    {
      return points_;
    }

    /** g: what constraints prescribe, with entries for all relevant degrees of freedom. Throws
     * InputError where they contradict each other. Collective. */
    DistributedVector compute_prescribed(const NodeConstraints::Factor &factor) const;

    /** T^T of forces in which hanging points have passed theirs on; zero at what is no unknown. */
    void condense(DistributedVector &forces) const;

    /** Zeros at what is no unknown. */
    void clear_dependent(DistributedVector &q) const;

    /** The owned entries of fields, with zeros at what is no unknown. */
    std::vector<std::vector<double>> unknowns_of(std::vector<DistributedVector> fields) const;

  private:
    void find_points();
    void add_lines(const Point &point);

    const Model                                 &model_;
    unsigned int                                 body_;
    const DofLevel                              &level_;
    ConstraintLines                              lines_;
    std::vector<dealii::types::global_dof_index> dependent_;
    std::vector<Point>                           points_;
  };
} // namespace vfife

#endif
