// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_operator_pack_layout_h
#define vfife_dynamics_operator_pack_layout_h

#include <vfife/dynamics/operator/congruence.h>
#include <vfife/model/partition.h>

#include <vector>

namespace vfife
{
  class Body;
  struct Model;

  /** The elements of one body on this rank, in packs of eight lanes. */
  struct BodyPacks
  {
    std::vector<std::uint32_t> elements; ///< of the body, on this rank, sorted
    CongruenceClasses          classes;  ///< of these elements

    /** Rows of `elements`, [pack][lane], or Partition::absent in unused lanes. */
    std::vector<std::uint32_t> shared_packs; ///< lanes of one congruence class
    std::vector<std::uint32_t> shared_class; ///< class of each shared pack
    std::vector<std::uint32_t> own_packs;    ///< lanes with constants of their own

    /** Packs at the beginning of each kind that touch nodes of other ranks; later ones do not. */
    std::size_t n_shared_at_border = 0, n_own_at_border = 0;
  };

  /** Whether a body's sectors (teeth) stay whole on so many ranks: with at least four of them a
   * rank. */
  bool keeps_sectors(const Body &body, unsigned int n_ranks);

  /**
   * Rank that computes each element of the model: whole sectors of a body in contiguous shares, or,
   * of a body with few sectors for so many ranks, shares of equal size by recursive bisection
   * across the longest extent (Berger and Bokhari 1987), whose borders are short. Bodies are dealt
   * in alternating order so that the remainders even out.
   */
  std::vector<std::uint32_t> assign_elements(const Model &model, unsigned int n_ranks);

  /**
   * Congruent elements into packs, those that touch nodes of other ranks first. Among these and the
   * others packs are sorted by their first element: for a gear that is chunk of eight teeth by
   * chunk, template element by template element, so that the lanes' nodes lie side by side. @p
   * share_constants false: all elements have constants of their own.
   */
  std::vector<BodyPacks> make_packs(const Model                      &model,
                                    const std::vector<std::uint32_t> &rank_of_element,
                                    unsigned int                      rank,
                                    bool                              share_constants = true);

  /** Numbers this rank's nodes in the order in which the packs first touch them, body by body;
   * owned: the lowest rank that touches the node. */
  Partition make_partition(const Model                      &model,
                           const std::vector<BodyPacks>     &packs,
                           const std::vector<std::uint32_t> &rank_of_element,
                           unsigned int                      rank);
} // namespace vfife

#endif
