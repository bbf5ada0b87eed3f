// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_operator_congruence_h
#define vfife_dynamics_operator_congruence_h

#include <cstdint>
#include <vector>

namespace vfife
{
  class Body;

  /**
   * Elements of a body that are rotated and shifted copies of each other, of one ElementKind (same
   * local node order): all teeth of a gear, the cells of a structured block. They share stiffness,
   * mass and stable step.
   */
  struct CongruenceClasses
  {
    std::vector<std::uint32_t> class_of;       ///< for each of the given elements
    std::vector<std::uint32_t> representative; ///< element of the body for each class
    std::vector<std::uint32_t> size;           ///< number of elements in each class
  };

  /**
   * Compares the elements' node coordinates in their own triads to 1e-8 of their size. Rounding may
   * split a class in rare cases; this costs storage, not correctness.
   */
  CongruenceClasses find_congruence_classes(const Body                       &body,
                                            const std::vector<std::uint32_t> &elements);
} // namespace vfife

#endif
