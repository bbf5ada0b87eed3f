// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_kernels_kernels_h
#define vfife_element_kernels_kernels_h

// Nothing else: this header is read by files compiled for one instruction set each, and inline code
// of others compiled there could be picked by the linker for machines that cannot run it.
#include <vfife/element/frame_kind.h>

#include <cstddef>
#include <cstdint>

namespace vfife
{
  /** Elements that a pack holds side by side. */
  constexpr unsigned int n_lanes = 8;

  /**
   * Numbers an element gives to the kernels: b of nodes 1 to 7 (21; b of node 0 is minus their
   * sum), pattern coefficients (12), V lambda and 2 V mu (2), H (78), triad (9; read by the
   * three-node frame only). Written by write_constants() of reduced_stiffness.h.
   */
  constexpr unsigned int n_element_constants = 122;

  /** Where H stands among them. */
  constexpr unsigned int start_of_hourglass_constants = 35, n_hourglass_constants = 78;

  /**
   * Hexahedra in packs of eight. Empty lanes of the last pack have all eight nodes at one node
   * whose force and energy nobody reads, and constants of any element (or zeros).
   */
  struct ElementPacks
  {
    std::size_t          n_packs = 0;
    const std::uint32_t *nodes   = nullptr; ///< [pack][node 0..7][lane 0..7]
    /**
     * Shared (constants_row given): [row][n_element_constants], one row for all lanes of a pack:
     * the lanes hold rotated copies of one element. Own: [pack][n_element_constants][lane 0..7].
     */
    const double        *constants     = nullptr;
    const std::uint32_t *constants_row = nullptr; ///< [pack], or nullptr for own constants
    /** Own constants only: H in single precision, [pack][n_hourglass_constants][lane]; @p constants
     * are then without H. */
    const float *hourglass = nullptr;
  };

  /** The element loops compiled for one instruction set and one frame. */
  struct ElementKernels
  {
    const char *name; ///< of the instruction set

    /**
     * Adds the restoring forces [N] of the elements of packs [@p first, @p last) to @p forces:
     * force on the node from the element, so that m a = f. @p positions [mm] and @p forces hold
     * four numbers a node, x y z and one that is neither used nor changed. Lanes are added in
     * order, so the result does not depend on how a range is cut, only on the order of elements.
     * Two calls must not run at once on packs that share nodes.
     */
    void (*add_internal_forces)(const ElementPacks &packs,
                                std::size_t         first,
                                std::size_t         last,
                                const double       *positions,
                                double             *forces);

    /** The same, and sets the strain energy [mJ] of each element, @p energies[pack][lane], and the
     * least det(dx/dxi) of its corners [mm^3], @p jacobians[pack][lane]. */
    void (*measure_internal_forces)(const ElementPacks &packs,
                                    std::size_t         first,
                                    std::size_t         last,
                                    const double       *positions,
                                    double             *forces,
                                    double             *energies,
                                    double             *jacobians);
  };

  /** generic is plain C++ without vectors and runs on every processor. */
  enum class InstructionSet
  {
    generic,
    sse2,
    avx2,
    avx512
  };

  /** "generic", "sse2", "avx2", "avx512". */
  const char *name_of(InstructionSet instruction_set);

  /** Whether this program has these kernels and this processor runs them. */
  bool is_available(InstructionSet instruction_set);

  /**
   * The fastest set available, or the one that the environment variable VFIFE_INSTRUCTION_SET
   * names. Throws InputError when that is no name or not available here.
   */
  InstructionSet best_instruction_set();

  /** Throws InputError when the set is not available here. */
  const ElementKernels &select_kernels(FrameKind frame, InstructionSet instruction_set);
} // namespace vfife

#endif
