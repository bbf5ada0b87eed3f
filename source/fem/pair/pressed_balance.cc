// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "pressed_tangent.h"

#include <vfife/fem/pair/pressed_balance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    constexpr unsigned int largest_iterations = 60;
    /** Where contact may be lost: residual of a balance that will do where no better is found. A
     * point on the edge between two facets may be pressed by either, with forces that differ. */
    constexpr double edge_jump = 1e-3;
    /** The same of an equilibrium, in which all of the load is carried: where Newton's method goes
     * round, a hundred-thousandth of it is let go. */
    constexpr double equilibrium_jump = 1e-5;
    /** Halvings of a Newton step. */
    constexpr unsigned int largest_halvings = 8;
    /** Round-off of the potential energy over its largest part. */
    constexpr double energy_round_off = 1e-11;
  } // namespace

  PressedTangent PressedBalance::linearize(const PressedState &now, const bool own)
  {
    const Eigen::VectorXd u          = base_ + now.deflection;
    const double          arm        = pair_.arm();
    PressedSprings        others     = bodies_.find_springs(u, now.touching, own);
    const double          turn_twice = others.turn_twice;
    PressedTangent tangent(now.touching ? pair_.find_springs() : std::vector<PressedPair::Spring>(),
                           std::move(others),
                           u.size(),
                           arm);
    // A given turn stays as it is, whatever the forces are.
    tangent.factorize(bodies_.flexibility(tangent.rows()),
                      (now.touching ? load_.stiffness + turn_twice : arm * arm) / (arm * arm));
    return tangent;
  }

  void PressedBalance::search_line(const PressedState &full, PressedState &now)
  {
    // A whole step that halves the residual is taken as it is: the contact's forces leave out terms
    // of second order (doc/theory/contact.md, Force along the facet), and next to the equilibrium
    // the potential may gain more by these than it loses by the step.
    const double arm   = pair_.arm();
    const double start = now.potential(load_), residual = now.residual(load_, arm);
    const double scale = 0.5 * std::abs(now.force.dot(now.deflection)) +
                         std::abs(now.acting.energy) +
                         std::abs(load_.torque * (full.turn - now.turn));
    // Half the step until the potential energy does not grow and something is still pressed.
    double       step = 1;
    PressedState next = now;
    for (unsigned int i = 0;; ++i, step *= 0.5)
      {
        // Deflections belong to forces linearly, so that both are cut by the same part.
        next.force      = now.force + step * (full.force - now.force);
        next.deflection = now.deflection + step * (full.deflection - now.deflection);
        next.turn       = now.turn + step * (full.turn - now.turn);
        next.acting = pair_.evaluate(bodies_, base_ + next.deflection, next.turn, next.touching);
        const bool presses = next.presses();
        if ((i == 0 && presses && next.residual(load_, arm) <= 0.5 * residual) ||
            (presses && next.potential(load_) <= start + energy_round_off * scale) ||
            i == largest_halvings)
          break;
      }
    now = std::move(next);
  }

  unsigned int PressedBalance::find(const double                        tolerance,
                                    PressedState                       &now,
                                    const std::function<std::string()> &explain)
  {
    std::ostringstream history;
    PressedState       best;
    double             least = std::numeric_limits<double>::infinity();
    const bool         loses = now.unit > 0; // contact may be lost
    const double       jump  = loses ? edge_jump : equilibrium_jump;
    for (unsigned int i = 0;; ++i)
      {
        const double residual = now.residual(load_, pair_.arm());
        if (now.presses() && std::isfinite(residual))
          history << " " << residual;
        else
          history << " then contact is lost";
        if (residual < tolerance)
          return i;
        if (residual < std::min(least, jump))
          {
            best  = now;
            least = residual;
          }
        if (least < jump && i >= (loses ? now.patience : largest_iterations))
          {
            // The surfaces are left where they have been evaluated.
            now        = std::move(best);
            now.acting = pair_.evaluate(bodies_, base_ + now.deflection, now.turn, now.touching);
            return i;
          }
        if (i >= largest_iterations || !now.presses() || !std::isfinite(residual))
          {
            const std::string excess = explain ? explain() : std::string();
            pair_.fail("Newton's method does not converge" + (excess.empty() ? "" : "; " + excess),
                       history.str());
          }

        // Springs answer with y = D (B^T dv + b dpsi), dv = A F~ - v, F~ = F - B y; b^T y = M + T
        // balances the torque. Eliminating dv gives the system of the tangent. The first step goes
        // by the bodies' own springs: those of undisplaced bearings may have no stiffness at all.
        const PressedTangent tangent = linearize(now, i > 0);
        // All forces that act are at the tangent's rows.
        const auto change =
          tangent.solve(tangent.find_imbalance(now.acting.force, now.deflection),
                        now.touching ? now.acting.torque + load_.at(now.turn) : 0.);
        PressedState full = now;
        full.force        = now.acting.force + change.first;
        full.deflection   = bodies_.answer(full.force);
        full.turn         = now.turn + change.second;
        search_line(full, now);
      }
  }

  std::pair<Eigen::VectorXd, double> PressedBalance::find_slope(const PressedState    &now,
                                                                const Eigen::VectorXd &change,
                                                                const double           torque)
  {
    const PressedTangent tangent = linearize(now, true);
    return tangent.solve(tangent.at_rows(change), torque);
  }
} // namespace vfife
