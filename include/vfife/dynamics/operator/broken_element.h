// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_operator_broken_element_h
#define vfife_dynamics_operator_broken_element_h

#include <string>

namespace vfife
{
  class Communicator;
  struct ElementMeasures;
  struct Model;
  struct State;

  /**
   * In words for a failure's message: the element of this rank with the least Jacobian relative to
   * the undeformed one in the last measured state, and the first node whose position is no longer
   * finite now.
   */
  std::string find_broken_element(const Model &model, const State &last_measured, const State &now);

  /** In words the inverted element that the measures of a state name, of the lowest rank that has
   * one; empty where no element is inverted. Collective. */
  std::string find_inverted_element(const Model           &model,
                                    const State           &state,
                                    const ElementMeasures &measures,
                                    const Communicator    &communicator);
} // namespace vfife

#endif
