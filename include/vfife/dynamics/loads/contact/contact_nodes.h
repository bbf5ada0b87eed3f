// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_contact_nodes_h
#define vfife_dynamics_loads_contact_contact_nodes_h

#include <cstdint>
#include <memory>
#include <vector>

namespace vfife
{
  struct ContactOfPair;
  struct ContactSurface;
  struct Model;

  /** All contact pairs of a model. */
  using ContactPairs = std::vector<std::unique_ptr<ContactOfPair>>;

  /** A node of a surface. */
  struct ContactNode
  {
    ContactSurface *surface;
    unsigned int    number; ///< of the surface
  };

  /** The nodes of the surfaces of all contact pairs: slave and master of each pair in turn. */
  struct ContactNodes
  {
    using Ranks = std::vector<std::uint32_t>; ///< ascending

    /** Numbers the nodes of all surfaces (ContactSurface::numbers): a node of two surfaces has one
     * number. */
    ContactNodes(const Model &model, const ContactPairs &pairs, unsigned int n_ranks);

    std::vector<ContactSurface *>                       surfaces;
    std::vector<std::vector<std::vector<unsigned int>>> of_groups; ///< of each surface's groups
    /** Of each surface's nodes the ranks whose elements touch it, the first of which owns it; empty
     * for one rank. */
    std::vector<std::vector<Ranks>> holders;
    unsigned int                    n_numbers = 0;
  };
} // namespace vfife

#endif
