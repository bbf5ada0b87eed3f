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

    void add_to(std::vector<double> &sum, const std::vector<double> &u)
    {
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += u[i];
    }
  } // namespace

  PairEquilibrium::Tangent PairEquilibrium::linearize(const Eigen::VectorXd &u,
                                                      const bool             touching,
                                                      const bool             with_bearings)
  {
    Tangent tangent;
    tangent.arm = model_.transmission->arm;
    if (touching)
      add_springs(tangent);
    add_rows(u, touching, with_bearings, tangent);

    // [D^-1 + B^T A B, -b; b^T, 0], the turn counted as a way at the arm: what the springs give
    // way by themselves and the compliance A of the bodies, and the balance of torques. Of a
    // bearing, 1 + D A instead, since D may be singular, and what its forces do about the axis.
    const Eigen::Index n_springs = tangent.springs.size(), n = tangent.n_forces();
    Eigen::MatrixXd    matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
    for (Eigen::Index i = 0; i < n; ++i)
      {
        matrix.col(i) =
          tangent.respond(apply_compliance(tangent.spread(Eigen::VectorXd::Unit(n, i), u.size())));
        matrix(n, i) *= -1.;
        matrix(i, i) += i < n_springs ? tangent.inverse_stiffness[i] : 1.;
      }
    if (touching)
      {
        matrix.col(n).head(n_springs) = -tangent.by_turn / tangent.arm;
        matrix.row(n).head(n_springs) += tangent.by_turn.transpose() / tangent.arm;
      }
    else
      matrix(n, n) = 1.;
    matrix.col(n).segment(n_springs, n - n_springs) = -tangent.rows_by_turn / tangent.arm;
    matrix(n, n) += tangent.turn_twice / (tangent.arm * tangent.arm);
    tangent.system.compute(matrix);
    return tangent;
  }

  void PairEquilibrium::add_rows(const Eigen::VectorXd &u,
                                 const bool             touching,
                                 const bool             with_bearings,
                                 Tangent               &tangent) const
  {
    const Eigen::Index first = bearing_row(0), n = u.size() - first;
    tangent.stiffness    = Eigen::MatrixXd::Zero(n, n);
    tangent.rows_by_turn = Eigen::VectorXd::Zero(n);
    if (with_bearings && bearings_->size() > 0)
      {
        const auto         bearings = bearings_->evaluate(bearing_rows(u), rotations_);
        const Eigen::Index size     = bearings.force.size();
        tangent.stiffness.topLeftCorner(size, size) = bearings.stiffness;
        if (touching) // otherwise the turn is given
          {
            tangent.rows_by_turn.head(size) = bearings.by_turn;
            tangent.turn_twice += bearings.turn_twice;
          }
      }
    Eigen::Index row = 6 * bearings_->size();
    for (const StandingMotion &standing : compliance_.standing_motions())
      {
        const Eigen::Index size                       = standing.stiffness.rows();
        tangent.stiffness.block(row, row, size, size) = standing.stiffness;
        row += size;
      }
  }

  void PairEquilibrium::add_springs(Tangent &tangent)
  {
    const unsigned int driven = model_.transmission->driven;
    const Axis        &axis   = model_.bodies[driven].axis;
    // Of each point under pressure: h changes by d . (dx_s - dy), d on the slave's node weights and
    // -d on the master's (at most 4 + 4 nodes), turned back into the axes of time zero; and by the
    // turn of the driven body by b = sum of weight d . (a x (x - c)) over its nodes.
    std::vector<double> inverse, by_turn;
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
    const double scale = 0.5 * std::abs(now.force.dot(now.deflection)) +
                         std::abs(now.trial.energy) + std::abs(load * (full.turn - now.turn));
    // Half the step until the potential energy does not grow and something is still pressed.
    double  step = 1;
    Iterate next = now;
    for (unsigned int i = 0;; ++i, step *= 0.5)
      {
        // Deflections belong to forces linearly, so that both are cut by the same part.
        next.force         = now.force + step * (full.force - now.force);
        next.deflection    = now.deflection + step * (full.deflection - now.deflection);
        next.turn          = now.turn + step * (full.turn - now.turn);
        next.trial         = evaluate(base + next.deflection, next.turn, next.touching);
        const bool presses = next.presses();
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
        if (result.iterations >= largest_iterations || !now.presses() ||
            !std::isfinite(result.residual))
          {
            const std::string excess = find_excess(base + now.deflection);
            fail("Newton's method does not converge" + (excess.empty() ? "" : "; " + excess),
                 history.str());
          }

        // Springs answer with y = D (B^T dv + b dpsi), dv = A F~ - v, F~ = F - B y; b^T y = M + T
        // balances the torque. Eliminating dv gives the system of linearize(). The first step goes
        // by the compliance's own bearings: undisplaced ones may have no stiffness at all.
        const Tangent tangent =
          linearize(base + now.deflection, now.touching, result.iterations > 0);
        const Eigen::VectorXd imbalance = apply_compliance(now.trial.force) - now.deflection;
        const auto            change    = tangent.solve(imbalance, now.touching ? torque : 0.);
        Iterate               full      = now;
        full.force      = now.trial.force + tangent.spread(change.first, base.size());
        full.deflection = apply_compliance(full.force);
        full.turn       = now.turn + change.second;
        search_line(base, load, full, now);
      }
  }

  void PairEquilibrium::check_reach(const Eigen::VectorXd &u) const
  {
    const std::string excess = find_excess(u);
    if (!excess.empty())
      fail(excess, "");
  }

  PairEquilibrium::Iterate PairEquilibrium::settle(const Eigen::VectorXd &base, const double turn)
  {
    Iterate now;
    now.force = now.deflection = Eigen::VectorXd::Zero(base.size());
    now.turn                   = turn;
    now.touching               = false;
    now.unit                   = std::abs(load(1.)) / model_.transmission->arm;
    if (bearings_->size() == 0)
      return now;
    now.trial = evaluate(base, turn, false);
    PairEquilibriumResult unasked;
    balance(base, 0., now, unasked);
    return now;
  }

  PairEquilibriumResult PairEquilibrium::solve(const double driver_turn, const double load_factor)
  {
    PairEquilibriumResult result;
    result.driver_turn = driver_turn;
    set_position(driver_turn);
    find_candidates();
    const Eigen::VectorXd spun     = compliance_.at_rows(compliance_.spun());
    const Iterate         unloaded = find_unloaded(spun);
    result.touch_turn              = unloaded.turn;
    result.touch_displacements     = compliance_.spun();
    if (bearings_->size() > 0)
      add_to(result.touch_displacements, compliance_.solve(compliance_.spread(unloaded.force)));

    // u_s + part of u_T: spin and the traction of the torque
    // What the bodies do without contact; Newton's method adds the deflection by contact forces.
    const Eigen::VectorXd base = spun + load_factor * compliance_.at_rows(compliance_.twisted());
    Iterate               now  = press_rigid(base, load(load_factor), unloaded);
    balance(base, load(load_factor), now, result);
    check_reach(base + now.deflection);
    report(base, now, load_factor, result);
    return result;
  }

  PairEquilibriumResult PairEquilibrium::press(const double               driver_turn,
                                               const std::vector<double> &known,
                                               const std::vector<double> &free,
                                               const double               torque)
  {
    PairEquilibriumResult result;
    result.driver_turn = driver_turn;
    set_position(driver_turn);
    find_candidates();
    const Eigen::VectorXd base = compliance_.at_rows(free), before = compliance_.at_rows(known);
    if (pressed_ != nullptr)
      set_turn(pressed_->turn);
    const double load = torque - bearings_->set_known(bearing_rows(before), rotations_);
    known_rows_       = before.tail(before.size() - bearing_row(bearings_->size()));
    if (pressed_ != nullptr)
      pressed_->trial = evaluate(base + pressed_->deflection, pressed_->turn, true);
    // The last equilibrium is the start while it still presses, else rigid flanks are pressed anew.
    if (pressed_ == nullptr || !pressed_->presses())
      {
        Iterate apart;
        apart.force = apart.deflection = Eigen::VectorXd::Zero(base.size());
        pressed_ = std::make_unique<Iterate>(press_rigid(base, load, std::move(apart)));
      }
    balance(base, load, *pressed_, result);
    check_reach(base + pressed_->deflection);
    result.turn          = pressed_->turn;
    result.displacements = free;
    add_to(result.displacements, compliance_.solve(compliance_.spread(pressed_->force)));
    return result;
  }

  void PairEquilibrium::report(const Eigen::VectorXd &base,
                               const Iterate         &now,
                               const double           load_factor,
                               PairEquilibriumResult &result)
  {
    result.turn           = now.turn;
    result.contact_torque = model_.transmission->driven_sense * now.trial.contact_torque;
    for (const auto &pair : pairs_)
      for (const GroupPairResult &group : pair->contact.results())
        if (group.normal_force > 0)
          result.teeth.push_back(make_tooth_contact(model_, pair->definition, group));

    // Per unit of the load factor the bodies twist further, and the springs answer.
    const Tangent         tangent = linearize(base + now.deflection, true, true);
    const Eigen::VectorXd u       = base + now.deflection;
    result.bearings               = bearings_->evaluate(bearing_rows(u), rotations_).states;
    const auto change = tangent.solve(compliance_.at_rows(compliance_.twisted()), load(1.));
    const Eigen::VectorXd slope = tangent.spread(change.first, now.force.size());
    result.turn_slope           = change.second;
    for (std::size_t i = 0; i < tangent.springs.size(); ++i)
      {
        ContactTie tie{tangent.springs[i], 1. / tangent.inverse_stiffness[i]};
        for (auto &point : tie.points)
          point.first = compliance_.watched()[point.first];
        result.ties.push_back(tie);
      }

    // Two solutions for the fields of all points, not only the watched ones.
    result.displacements      = compliance_.solve(compliance_.spread(now.force));
    result.displacement_slope = compliance_.solve(compliance_.spread(slope));
    for (std::size_t i = 0; i < result.displacements.size(); ++i)
      {
        result.displacements[i] += compliance_.spun()[i] + load_factor * compliance_.twisted()[i];
        result.displacement_slope[i] += compliance_.twisted()[i];
      }
  }
} // namespace vfife
