// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_contact_of_pair_h
#define vfife_dynamics_loads_contact_contact_of_pair_h

#include <vfife/contact/contact.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  /** One surface of a contact pair in the explicit loop: its nodes' place in the arrays of this
   * rank, and their motion and forces by surface node. */
  struct ContactSurface
  {
    ContactSurface(unsigned int       body_index,
                   const Body        &body,
                   const std::string &surface_name,
                   const Partition   &partition);

    /** Largest distance of a surface node that this rank owns from where the rigid @p motion of the
     * body would put it [mm]. */
    double largest_deformation(const RigidMotion &motion, const NodeField &positions) const;

    unsigned int                     body;
    const FacetSurface              *facets;
    std::vector<std::uint32_t>       local; ///< local node of each surface node, or absent
    std::vector<double>              mass;  ///< [t]
    std::vector<double>              positions, velocities;
    std::vector<double>              forces;           ///< zero between evaluations
    std::vector<double>              free_velocities;  ///< after the step without contact
    const std::vector<unsigned int> *active = nullptr; ///< surface nodes, of the contact
    std::vector<unsigned int>        numbers;          ///< of each surface node among all pairs
    std::vector<std::uint8_t>        touched;          ///< marks of nodes, zero between evaluations
    std::vector<unsigned int>        owned; ///< surface nodes that this rank counts in sums
  };

  /** A contact pair of the model with its contact. */
  struct ContactOfPair
  {
    /** @p safety: step over the largest stable one, of all else that acts. */
    ContactOfPair(const ContactPair &pair,
                  const Model       &model,
                  const Partition   &partition,
                  double             safety);

    /** Largest stable step [s] where everything else allows @p step. */
    double vote_on_step(double step) const;

    /** Penetration at which a run is given up [mm]. */
    double penetration_limit() const
    {
      return definition.options.penetration_limit * contact.depth_limit();
    }

    bool is_implicit() const
    {
      return definition.options.time == ContactTime::implicit;
    }

    /** Stiffness of points that stick [N/mm^3] which the step @p dt [s] bears. */
    double tangential_limit(double dt) const;

    /** That of the definition; one that follows from the facets has the value of the narrowest. */
    const PenaltyOptions &penalty() const
    {
      return penalty_;
    }

    /** Penalty at the step @p dt [s] over that from which on impacts leave it rattling, at the node
     * where it is largest. */
    double rattling(double dt) const;

    std::array<ContactSurface *, 2> surfaces()
    {
      return {{&slave, &master}};
    }

    const ContactPair &definition;
    ContactSurface     slave, master;
    Contact            contact;
    double             mass_per_area; ///< least of both surfaces [t/mm^2]
    /** The same by the area that nodes can carry from the other side's points. */
    double carried_mass_per_area;

  private:
    double         safety_;
    PenaltyOptions penalty_;
  };
} // namespace vfife

#endif
