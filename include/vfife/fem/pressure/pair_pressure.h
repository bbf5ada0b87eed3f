// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_pair_pressure_h
#define vfife_fem_pressure_pair_pressure_h

#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/fem/pressure/flank_pair.h>

namespace vfife
{
  class PenaltyCalibration;

  /** Pressures of a pair at a position. */
  struct PairPressures
  {
    std::vector<ToothPressure> teeth; ///< that carry
    /** What the driven member is ahead of its place in the penalty's equilibrium, in the drive
     * direction [rad]. */
    double lead = 0;
  };

  /**
   * Pressures of a gear pair in equilibrium that neither its mesh nor its penalty makes: the teeth
   * share the torque anew, with the flexibility of the finite elements away from the flanks and
   * that of elastic layers near them (doc/theory/pressure-grid.md). Bearings
   * keep their linear stiffness.
   */
  class PairPressure
  {
  public:
    /** @p depth: of the layers, at least [mm]; @p cells_across the width of a contact. The
     * compliance must be that of the equilibria that solve() is called with, and outlive the
     * object. */
    PairPressure(Compliance &compliance, double depth, unsigned int cells_across);

    /** At the last position of @p equilibrium, with its @p result. Collective. Throws InputError
     * for bodies with one element across a tooth, NumericalError where no pressures are found.
     * The @p calibration, if any, gets what was found. */
    PairPressures solve(const PairEquilibrium       &equilibrium,
                        const PairEquilibriumResult &result,
                        PenaltyCalibration          *calibration = nullptr);

  private:
    void        place(const PairEquilibrium &equilibrium, const PairEquilibriumResult &result);
    ContactLoad make_load(const PairEquilibrium       &equilibrium,
                          const PairEquilibriumResult &result) const;

    Compliance  &compliance_;
    const Model &model_;
    unsigned int cells_across_;
    FlankPair    flanks_;
    PointPlaces  places_;
  };
} // namespace vfife

#endif
