// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_node_springs_h
#define vfife_contact_node_springs_h

#include <vfife/contact/pass/contact_pass.h>

#include <array>
#include <vector>

namespace vfife
{
  /** The points of a contact as springs on the nodes of its surfaces, and the mass per area that
   * bears them. */
  class NodeSprings
  {
  public:
    /** Slave's and master's values by surface node. */
    using OfSurfaces = std::array<std::vector<double>, 2>;

    /** Refers to the @p passes of a contact: one, or two with swapped roles. */
    explicit NodeSprings(const std::vector<ContactPass> &passes)
      : passes_(passes)
    {
    }

    /** Undeformed tributary areas [mm^2]. */
    const std::vector<double> &slave_areas() const
    {
      return passes_.front().slave().node_areas();
    }
    const std::vector<double> &master_areas() const
    {
      return passes_.front().master().node_areas();
    }

    /** Area of points that a node carries at most [mm^2]: eps times it is the stiffness of the
     * springs there. That of a coarse slave can exceed a node's tributary area. */
    OfSurfaces carried_areas() const;

    /** Largest penalty at each node over that of the contact [-]. */
    OfSurfaces stiffness() const;

    /** Least m/A [t/mm^2] over the nodes with tributary area; masses [t] by surface node. Throws
     * InputError on another number of masses. */
    double mass_per_area(const std::vector<double> &slave_masses,
                         const std::vector<double> &master_masses) const;

    /** m/A [t/mm^2] with which the springs add at most 2 eps A/m to the square of the highest
     * circular frequency wherever the surfaces lie to each other, by the carried areas. */
    double carried_mass_per_area(const std::vector<double> &slave_masses,
                                 const std::vector<double> &master_masses) const;

  private:
    const std::vector<ContactPass> &passes_;
  };
} // namespace vfife

#endif
