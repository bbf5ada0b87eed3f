// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method of PressedPair.
#include "pressed_pair_parts.h"

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

  double PressedState::potential(const TurnLoad &load) const
  {
    return 0.5 * force.dot(deflection) + acting.energy + load.potential(turn);
  }

  double PressedState::residual(const TurnLoad &load, const double arm) const
  {
    const double imbalance = (acting.force - force).norm();
    if (!touching)
      return imbalance / unit;
    const double scale = std::max(unit, acting.contact_force);
    return std::max(imbalance / scale,
                    std::abs((acting.torque + load.at(turn)) /
                             (unit > 0 ? scale * arm : load.torque)));
  }

  bool PressedState::presses() const
  {
    return !touching || unit > 0 || acting.contact_energy > 0;
  }

  void PressedPair::Tangent::factorize()
  {
    // [D^-1 + B^T A B, -b; b^T, k], the turn counted as a way at the arm: what the springs give
    // way by themselves and the compliance A of the bodies, and the balance of torques. Of other
    // rows, 1 + D A instead, since D may be singular, and what their forces do about the axis.
    const Eigen::Index n = n_forces(), n_others = n - n_springs();
    Eigen::MatrixXd    answers = Eigen::MatrixXd::Zero(rows.size(), n);
    for (const Entry &entry : entries)
      answers.col(entry.spring) += entry.value * flexibility.col(entry.row);
    answers.rightCols(n_others) = flexibility.rightCols(n_others);

    symmetric = n_others == 0;
    if (symmetric)
      {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
        for (const Entry &entry : entries)
          matrix.row(entry.spring) += entry.value * answers.row(entry.row);
        for (Eigen::Index i = 0; i < n; ++i)
          matrix(i, i) += 1. / springs[i].stiffness;
        factor.compute(matrix);
        turned = factor.solve(by_turn);
        return;
      }
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
    for (Eigen::Index i = 0; i < n; ++i)
      {
        matrix.col(i) = respond(answers.col(i));
        matrix(n, i) *= -1.;
        matrix(i, i) += i < n_springs() ? 1. / springs[i].stiffness : 1.;
      }
    matrix.col(n).head(n_springs()) = -by_turn;
    matrix.row(n).head(n_springs()) += by_turn.transpose();
    matrix.col(n).segment(n_springs(), n_others) = -others.by_turn / arm;
    matrix(n, n) += turn_stiffness;
    system.compute(matrix);
  }

  Eigen::VectorXd PressedPair::Tangent::at_rows(const Eigen::VectorXd &x) const
  {
    Eigen::VectorXd values(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      values[i] = x[rows[i]];
    return values;
  }

  std::pair<Eigen::VectorXd, double> PressedPair::Tangent::solve(const Eigen::VectorXd &u,
                                                                 const double torque) const
  {
    Eigen::VectorXd right = respond(u);
    if (symmetric)
      {
        // x - turned y = S^-1 h,  b^T x + k y = torque/arm
        const Eigen::VectorXd x = factor.solve(right.head(n_forces()));
        const double          k = turn_stiffness + by_turn.dot(turned);
        const double          y = k > 0 ? (torque / arm - by_turn.dot(x)) / k : 0.;
        return {-(x + y * turned), y / arm};
      }
    right[n_forces()]       = torque / arm - right[n_forces()];
    const Eigen::VectorXd x = system.solve(right);
    return {-x.head(n_forces()), x[n_forces()] / arm};
  }

  std::vector<PressedPair::Spring> PressedPair::find_springs() const
  {
    const unsigned int driven = model_.only_transmission()->driven;
    const Axis        &axis   = model_.bodies[driven].axis;
    // Of each point under pressure: h changes by d . (dx_s - dy), d on the slave's node weights and
    // -d on the master's (at most 4 + 4 nodes), turned back into the axes of the rows; and by the
    // turn of the driven body by b = sum of weight d . (a x (x - c)) over its nodes.
    std::vector<Spring> springs;
    for (const auto &pair : pairs_)
      for (const ContactSpring &point : pair->contact.springs())
        {
          Spring &spring   = springs.emplace_back();
          spring.stiffness = point.stiffness;

          const auto add = [&](const Surface                     &surface,
                               const std::array<unsigned int, 4> &corners,
                               const std::array<double, 4>       &weights,
                               const double                       sign,
                               const unsigned int                 first) {
            for (unsigned int k = 0; k < 4; ++k)
              {
                const Vector3                   f = sign * weights[k] * point.direction;
                const Eigen::Map<const Vector3> x(surface.positions.data() + 3 * corners[k]);
                const unsigned int              at = surface.place[corners[k]];
                spring.nodes[first + k]            = {at,
                                                      nodes_[at].axes.transpose() *
                                                        (rotations_[surface.body].transpose() * f)};
                if (surface.body == driven)
                  spring.by_turn += f.dot(axis.direction.cross(x - axis.point));
              }
          };
          const Surface &slave  = point.swapped ? pair->master : pair->slave;
          const Surface &master = point.swapped ? pair->slave : pair->master;
          add(slave, point.slave_nodes, point.slave_weights, 1., 0);
          add(master, point.master_nodes, point.master_weights, -1., 4);
        }
    return springs;
  }

  PressedPair::Tangent PressedPair::linearize(PressedBodies         &bodies,
                                              const Eigen::VectorXd &u,
                                              const TurnLoad        &load,
                                              const bool             touching,
                                              const bool             own) const
  {
    Tangent tangent;
    tangent.arm = model_.only_transmission()->arm;
    if (touching)
      tangent.springs = find_springs();
    tangent.others = bodies.find_springs(u, touching, own);

    // Rows where something acts.
    std::vector<unsigned int> place(nodes_.size(), 0);
    for (const Spring &spring : tangent.springs)
      for (const auto &[node, direction] : spring.nodes)
        place[node] = 1;
    for (unsigned int k = 0; k < place.size(); ++k)
      if (place[k] == 1)
        {
          place[k] = tangent.rows.size();
          for (unsigned int c = 0; c < 3; ++c)
            tangent.rows.push_back(3 * k + c);
        }
    for (unsigned int i = 0; i < tangent.springs.size(); ++i)
      for (const auto &[node, direction] : tangent.springs[i].nodes)
        for (unsigned int c = 0; c < 3; ++c)
          tangent.entries.push_back({place[node] + c, i, direction[c]});
    for (Eigen::Index k = u.size() - tangent.others.stiffness.rows(); k < u.size(); ++k)
      tangent.rows.push_back(k);

    tangent.by_turn.resize(tangent.n_springs());
    for (Eigen::Index i = 0; i < tangent.n_springs(); ++i)
      tangent.by_turn[i] = tangent.springs[i].by_turn / tangent.arm;
    // A given turn stays as it is, whatever the forces are.
    tangent.turn_stiffness =
      (touching ? load.stiffness + tangent.others.turn_twice : tangent.arm * tangent.arm) /
      (tangent.arm * tangent.arm);
    tangent.flexibility = bodies.flexibility(tangent.rows);
    tangent.factorize();
    return tangent;
  }

  void PressedPair::search_line(const PressedBodies   &bodies,
                                const Eigen::VectorXd &base,
                                const TurnLoad        &load,
                                const PressedState    &full,
                                PressedState          &now)
  {
    // A whole step that halves the residual is taken as it is: the contact's forces leave out terms
    // of second order (doc/theory/contact.md, Force along the facet), and next to the equilibrium
    // the potential may gain more by these than it loses by the step.
    const double arm   = model_.only_transmission()->arm;
    const double start = now.potential(load), residual = now.residual(load, arm);
    const double scale = 0.5 * std::abs(now.force.dot(now.deflection)) +
                         std::abs(now.acting.energy) +
                         std::abs(load.torque * (full.turn - now.turn));
    // Half the step until the potential energy does not grow and something is still pressed.
    double       step = 1;
    PressedState next = now;
    for (unsigned int i = 0;; ++i, step *= 0.5)
      {
        // Deflections belong to forces linearly, so that both are cut by the same part.
        next.force         = now.force + step * (full.force - now.force);
        next.deflection    = now.deflection + step * (full.deflection - now.deflection);
        next.turn          = now.turn + step * (full.turn - now.turn);
        next.acting        = evaluate(bodies, base + next.deflection, next.turn, next.touching);
        const bool presses = next.presses();
        if ((i == 0 && presses && next.residual(load, arm) <= 0.5 * residual) ||
            (presses && next.potential(load) <= start + energy_round_off * scale) ||
            i == largest_halvings)
          break;
      }
    now = std::move(next);
  }

  unsigned int PressedPair::balance(PressedBodies                      &bodies,
                                    const Eigen::VectorXd              &base,
                                    const TurnLoad                     &load,
                                    const double                        tolerance,
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
        const double residual = now.residual(load, model_.only_transmission()->arm);
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
            now.acting = evaluate(bodies, base + now.deflection, now.turn, now.touching);
            return i;
          }
        if (i >= largest_iterations || !now.presses() || !std::isfinite(residual))
          {
            const std::string excess = explain ? explain() : std::string();
            fail("Newton's method does not converge" + (excess.empty() ? "" : "; " + excess),
                 history.str());
          }

        // Springs answer with y = D (B^T dv + b dpsi), dv = A F~ - v, F~ = F - B y; b^T y = M + T
        // balances the torque. Eliminating dv gives the system of the tangent. The first step goes
        // by the bodies' own springs: those of undisplaced bearings may have no stiffness at all.
        const Tangent tangent = linearize(bodies, base + now.deflection, load, now.touching, i > 0);
        // All forces that act are at the tangent's rows.
        const Eigen::VectorXd imbalance =
          tangent.flexibility * tangent.at_rows(now.acting.force) - tangent.at_rows(now.deflection);
        const auto change =
          tangent.solve(imbalance, now.touching ? now.acting.torque + load.at(now.turn) : 0.);
        PressedState full = now;
        full.force        = now.acting.force + tangent.spread(change.first, base.size());
        full.deflection   = bodies.answer(full.force);
        full.turn         = now.turn + change.second;
        search_line(bodies, base, load, full, now);
      }
  }

  std::pair<Eigen::VectorXd, double> PressedPair::find_slope(PressedBodies         &bodies,
                                                             const Eigen::VectorXd &u,
                                                             const TurnLoad        &load,
                                                             const Eigen::VectorXd &base,
                                                             const double           torque)
  {
    const Tangent tangent = linearize(bodies, u, load, true, true);
    const auto    change  = tangent.solve(tangent.at_rows(base), torque);
    return {tangent.spread(change.first, u.size()), change.second};
  }
} // namespace vfife
