// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_contact_report_h
#define vfife_dynamics_loads_contact_contact_report_h

#include <vfife/dynamics/loads/contact/contact_nodes.h>
#include <vfife/model/state.h>

#include <string>
#include <vector>

namespace vfife
{
  class Communicator;

  /** Pairs of surface groups that pressed on each other at the last evaluation, over all ranks.
   * Collective. */
  std::vector<ToothContact> collect_pressed_teeth(const Model        &model,
                                                  const ContactPairs &pairs,
                                                  const Communicator &communicator);

  /** In words: the deepest point of the last evaluation over its pair's limit, with teeth, facets,
   * depth and limit. Collective. */
  std::string describe_deepest_point(const Model        &model,
                                     const ContactPairs &pairs,
                                     const Communicator &communicator);

  /** Sentences about slaves that are clearly coarser than their masters: which surface should be
   * the slave, and what it costs that it is not. */
  std::vector<std::string> describe_coarse_slaves(const Model &model, const ContactPairs &pairs);

  /** Sentences about pairs that are integrated implicitly and whose penalty is so high that impacts
   * leave it rattling at the step @p dt [s]. */
  std::vector<std::string> describe_rattling(const ContactPairs &pairs, double dt);
} // namespace vfife

#endif
