// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method of PairEquilibrium.
#include "pair_equilibrium_parts.h"

#include <vfife/model/tooth_contact.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Unbalanced forces over contact forces, and torque over the load's. */
    constexpr double       tolerance          = 1e-9;
    constexpr unsigned int largest_iterations = 60;
    /** Halvings of a Newton step. */
    constexpr unsigned int largest_halvings = 8;
    /** Round-off of the potential energy over its largest part. */
    constexpr double energy_round_off = 1e-11;
  } // namespace

  PairEquilibrium::Tangent PairEquilibrium::linearize()
  {
    const unsigned int driven = model_.transmission->driven;
    const Axis        &axis   = model_.bodies[driven].axis;
    // Of each point under pressure: h changes by d . (dx_s - dy), d on the slave's node weights and
    // -d on the master's (at most 4 + 4 nodes), turned back into the axes of time zero; and by the
    // turn of the driven body by b = sum of weight d . (a x (x - c)) over its nodes.
    Tangent             tangent;
    std::vector<double> inverse, by_turn;
    tangent.arm = model_.transmission->arm;
    // Every spring as directions at the watched points, in the axes of time zero, with the way that
    // a turn of the driven body makes along them.
    for (const auto &pair : pairs_)
      for (const ContactSpring &spring : pair->contact.springs())
        {
          auto  &nodes  = tangent.springs.emplace_back();
          double turned = 0;

          const auto add = [&](const Surface                     &surface,
                               const std::array<unsigned int, 4> &corners,
                               const std::array<double, 4>       &weights,
                               const double                       sign,
                               const unsigned int                 first) {
            for (unsigned int k = 0; k < 4; ++k)
              {
                const Vector3                   f = sign * weights[k] * spring.direction;
                const Eigen::Map<const Vector3> x(surface.positions.data() + 3 * corners[k]);
                nodes[first + k] = {surface.place[corners[k]],
                                    rotations_[surface.body].transpose() * f};
                if (surface.body == driven)
                  turned += f.dot(axis.direction.cross(x - axis.point));
              }
          };
          const Surface &slave  = spring.swapped ? pair->master : pair->slave;
          const Surface &master = spring.swapped ? pair->slave : pair->master;
          add(slave, spring.slave_nodes, spring.slave_weights, 1., 0);
          add(master, spring.master_nodes, spring.master_weights, -1., 4);
          inverse.push_back(1. / spring.stiffness);
          by_turn.push_back(turned);
        }
    const std::size_t n       = inverse.size();
    tangent.inverse_stiffness = Eigen::Map<Eigen::VectorXd>(inverse.data(), n);
    tangent.by_turn           = Eigen::Map<Eigen::VectorXd>(by_turn.data(), n);

    // [D^-1 + B^T A B, -b; b^T, 0], the turn counted as a way at the arm: what the springs give
    // way by themselves and the compliance A of the bodies, and the balance of torques.
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
    for (std::size_t i = 0; i < n; ++i)
      {
        const Eigen::VectorXd one =
          tangent.spread(Eigen::VectorXd::Unit(n, i), 3 * compliance_.watched().size());
        matrix.col(i).head(n) = tangent.project(apply_compliance(one));
        matrix(i, i) += tangent.inverse_stiffness[i];
      }
    matrix.col(n).head(n) = -tangent.by_turn / tangent.arm;
    matrix.row(n).head(n) = tangent.by_turn.transpose() / tangent.arm;
    tangent.system.compute(matrix);
    return tangent;
  }

  void PairEquilibrium::search_line(const Eigen::VectorXd &base,
                                    const double           load,
                                    const Iterate         &full,
                                    Iterate               &now)
  {
    // A whole step that halves the residual is taken as it is: the contact's forces leave out terms
    // of second order (doc/contact.md, Force along the facet), and next to the equilibrium the
    // potential may gain more by these than it loses by the step.
    const double start = now.potential(load), residual = now.residual(load);
    const double scale = 0.5 * std::abs(now.force.dot(now.deflection)) + now.trial.energy +
                         std::abs(load * (full.turn - now.turn));
    // Half the step until the potential energy does not grow and something is still pressed.
    double  step = 1;
    Iterate next;
    for (unsigned int i = 0;; ++i, step *= 0.5)
      {
        // Deflections belong to forces linearly, so that both are cut by the same part.
        next.force         = now.force + step * (full.force - now.force);
        next.deflection    = now.deflection + step * (full.deflection - now.deflection);
        next.turn          = now.turn + step * (full.turn - now.turn);
        next.trial         = evaluate(base + next.deflection, next.turn);
        const bool presses = next.trial.energy > 0;
        if ((i == 0 && presses && next.residual(load) <= 0.5 * residual) ||
            (presses && next.potential(load) <= start + energy_round_off * scale) ||
            i == largest_halvings)
          break;
      }
    now = next;
  }

  void PairEquilibrium::balance(const Eigen::VectorXd &base,
                                const double           load,
                                Iterate               &now,
                                PairEquilibriumResult &result)
  {
    std::ostringstream history;
    for (;; ++result.iterations)
      {
        const double torque = now.trial.torque + load;
        result.residual     = now.residual(load);
        history << " " << result.residual;
        if (result.residual < tolerance)
          return;
        if (result.iterations >= largest_iterations || now.trial.energy <= 0 ||
            !std::isfinite(result.residual))
          fail("Newton's method does not converge", history.str());

        // Springs answer with y = D (B^T dv + b dpsi), dv = A F~ - v, F~ = F - B y; b^T y = M + T
        // balances the torque. Eliminating dv gives the system of linearize().
        const Tangent         tangent   = linearize();
        const Eigen::VectorXd imbalance = apply_compliance(now.trial.force) - now.deflection;
        const auto            change    = tangent.solve(imbalance, torque);
        Iterate               full;
        full.force      = now.trial.force + tangent.spread(change.first, base.size());
        full.deflection = apply_compliance(full.force);
        full.turn       = now.turn + change.second;
        search_line(base, load, full, now);
      }
  }

  PairEquilibriumResult PairEquilibrium::solve(const double driver_turn, const double load_factor)
  {
    PairEquilibriumResult result;
    result.driver_turn = driver_turn;
    result.touch_turn  = find_touch(driver_turn);

    // u_s + part of u_T: spin and the traction of the torque
    // What the bodies do without contact; Newton's method adds the deflection by contact forces.
    const Eigen::VectorXd base =
      at_watched(compliance_.spun()) + load_factor * at_watched(compliance_.twisted());
    Iterate now = press_rigid(base, load(load_factor));
    balance(base, load(load_factor), now, result);
    report(now, load_factor, result);
    return result;
  }

  PairEquilibriumResult PairEquilibrium::press(const double               driver_turn,
                                               const std::vector<double> &free,
                                               const double               torque)
  {
    PairEquilibriumResult result;
    result.driver_turn = driver_turn;
    set_position(driver_turn);
    find_candidates();
    const Eigen::VectorXd base = at_watched(free);
    if (pressed_ != nullptr)
      pressed_->trial = evaluate(base + pressed_->deflection, pressed_->turn);
    // The last equilibrium is the start while it still presses, else rigid flanks are pressed anew.
    if (pressed_ == nullptr || !(pressed_->trial.energy > 0))
      pressed_ = std::make_unique<Iterate>(press_rigid(base, torque));
    balance(base, torque, *pressed_, result);
    result.turn          = pressed_->turn;
    result.displacements = compliance_.solve(spread(pressed_->force));
    for (std::size_t i = 0; i < free.size(); ++i)
      result.displacements[i] += free[i];
    return result;
  }

  void PairEquilibrium::report(const Iterate         &now,
                               const double           load_factor,
                               PairEquilibriumResult &result)
  {
    result.turn           = now.turn;
    result.contact_torque = model_.transmission->driven_sense * now.trial.torque;
    for (const auto &pair : pairs_)
      for (const GroupPairResult &group : pair->contact.results())
        if (group.normal_force > 0)
          result.teeth.push_back(make_tooth_contact(model_, pair->definition, group));

    // Per unit of the load factor the bodies twist further, and the springs answer.
    const Tangent         tangent = linearize();
    const auto            change  = tangent.solve(at_watched(compliance_.twisted()), load(1.));
    const Eigen::VectorXd slope   = tangent.spread(change.first, now.force.size());
    result.turn_slope             = change.second;
    for (std::size_t i = 0; i < tangent.springs.size(); ++i)
      {
        ContactTie tie{tangent.springs[i], 1. / tangent.inverse_stiffness[i]};
        for (auto &point : tie.points)
          point.first = compliance_.watched()[point.first];
        result.ties.push_back(tie);
      }

    // Two solutions for the fields of all points, not only the watched ones.
    result.displacements      = compliance_.solve(spread(now.force));
    result.displacement_slope = compliance_.solve(spread(slope));
    for (std::size_t i = 0; i < result.displacements.size(); ++i)
      {
        result.displacements[i] += compliance_.spun()[i] + load_factor * compliance_.twisted()[i];
        result.displacement_slope[i] += compliance_.twisted()[i];
      }
  }

  double mean_rotation(const Discretization            &discretization,
                       const unsigned int               body,
                       const std::vector<unsigned int> &nodes,
                       const std::vector<double>       &displacements)
  {
    const Body        &b     = discretization.model().bodies[body];
    const unsigned int first = discretization.find_part(body)->first_point;
    double             sum = 0, mass = 0;
    for (const unsigned int node : nodes)
      {
        const Vector3 arm =
          b.axis.direction.cross(discretization.points()[first + node] - b.axis.point);
        const Eigen::Map<const Vector3> u(displacements.data() + 3 * std::size_t(first + node));
        // u_theta / r of each node; "arm" is a x (x - c), of length r.
        sum += b.node_masses()[node] * u.dot(arm) / arm.squaredNorm();
        mass += b.node_masses()[node];
      }
    return sum / mass;
  }
} // namespace vfife
