// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_node_stresses_h
#define vfife_output_measures_node_stresses_h

#include <vfife/element/frame_kind.h>
#include <vfife/element/stiffness.h>

#include <array>
#include <vector>

namespace vfife
{
  class Communicator;
  struct Model;
  struct State;

  /**
   * Averages of the elements' nodal stresses at each node of the model, over the elements of all
   * ranks (collective; the result is as long as the model on every rank): rr tt zz rt tz zr [MPa]
   * in the axes of compute_cylindrical_axes(). The state's positions must be those of @p kind's and
   * @p frame's run.
   */
  std::vector<std::array<double, 6>> compute_node_stresses(const Model        &model,
                                                           const State        &state,
                                                           StiffnessKind       kind,
                                                           FrameKind           frame,
                                                           const Communicator &communicator);
} // namespace vfife

#endif
