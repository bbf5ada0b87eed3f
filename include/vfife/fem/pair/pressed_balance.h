// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pressed_balance_h
#define vfife_fem_pair_pressed_balance_h

#include <vfife/fem/pair/pressed_pair.h>

#include <functional>
#include <string>
#include <utility>

namespace vfife
{
  class PressedTangent;

  /** The equilibrium of a pressed pair under a load: Newton's method on the springs of the contact
   * points with a line search on the potential energy. */
  class PressedBalance
  {
  public:
    /** Displacements are @p base and the bodies' answer. All but @p load must outlive the object.
     */
    PressedBalance(PressedPair           &pair,
                   PressedBodies         &bodies,
                   const Eigen::VectorXd &base,
                   const TurnLoad        &load)
      : pair_(pair)
      , bodies_(bodies)
      , base_(base)
      , load_(load)
    {
    }

    /**
     * Finds the equilibrium from @p now. @p tolerance: of PressedState::residual(). Where a point
     * between two facets is pressed by one and the other in turn, the best one will do: below 1e-3
     * after PressedState::patience iterations where contact may be lost, else below 1e-5 after 60.
     * Returns the iterations; throws NumericalError, naming position and history of residuals, and
     * what @p explain says where that is not empty.
     */
    unsigned int find(double                              tolerance,
                      PressedState                       &now,
                      const std::function<std::string()> &explain = nullptr);

    /** Change of forces at the rows (first) and of the turn (second) at the equilibrium @p now when
     * the displacements without contact change by @p change and the torque by @p torque. */
    std::pair<Eigen::VectorXd, double>
    find_slope(const PressedState &now, const Eigen::VectorXd &change, double torque);

  private:
    /** Without @p own, bodies have those springs that are in their answers. */
    PressedTangent linearize(const PressedState &now, bool own);
    /** Goes from @p now towards @p full. */
    void search_line(const PressedState &full, PressedState &now);

    PressedPair           &pair_;
    PressedBodies         &bodies_;
    const Eigen::VectorXd &base_;
    TurnLoad               load_;
  };
} // namespace vfife

#endif
