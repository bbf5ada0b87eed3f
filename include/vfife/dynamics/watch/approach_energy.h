// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_approach_energy_h
#define vfife_dynamics_watch_approach_energy_h

#include <vfife/dynamics/update_sums.h>

#include <set>
#include <utility>
#include <vector>

namespace vfife
{
  struct Model;

  /**
   * The kinetic energy that impacts between the bodies of a model can convert: what a fully
   * inelastic one takes from each two bodies that may touch, mu |v_a - v_b|^2/2 with the velocities
   * of their centres and mu = 1/(1/m_a + 1/m_b), and the spin of those that fly freely. Bodies in
   * bearings, with held or driven nodes, and walls have an infinite mass and their spin is
   * prescribed: a gear pair has none. Measured between bodies, so it does not depend on the frame.
   */
  class ApproachEnergy
  {
  public:
    explicit ApproachEnergy(const Model &model);

    /** At the state whose sums over all ranks are @p sums, one a body [mJ]. */
    double compute(const std::vector<BodySums> &sums) const;

  private:
    struct FlyingBody
    {
      bool   flies = false;
      double mass  = 0; ///< [t]
    };
    std::vector<FlyingBody>                         bodies_;
    std::set<std::pair<unsigned int, unsigned int>> pairs_; ///< which may touch, each once
    std::set<unsigned int>                          at_walls_;
  };
} // namespace vfife

#endif
