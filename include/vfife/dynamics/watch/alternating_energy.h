// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_alternating_energy_h
#define vfife_dynamics_watch_alternating_energy_h

#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  class Communicator;
  struct Model;

  /**
   * sum m |v+ - v- - the body's mean of it|^2/8 [mJ] of the velocities @p before and @p after an
   * instant. As v+ - v- = a dt, a vibration of the circular frequency omega has (omega dt/2)^2 of
   * its elastic energy there: less than all of it in a stable run, more where central differences
   * let a mode grow, which their own energy, with m v+ . v-/2, does not see: it is conserved.
   * @p masses [t] of this rank's nodes. Collective.
   */
  double compute_alternating_energy(const Model               &model,
                                    const std::vector<double> &masses,
                                    const Partition           &partition,
                                    const NodeField           &before,
                                    const NodeField           &after,
                                    const Communicator        &communicator);
} // namespace vfife

#endif
