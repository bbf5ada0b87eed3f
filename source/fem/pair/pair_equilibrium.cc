// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "pair_bodies.h"

#include <vfife/base/errors.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/fem/pair/pressed_balance.h>
#include <vfife/model/pair_measures.h>

#include <cmath>
#include <set>

namespace vfife
{
  namespace
  {
    /** Of the secant towards the turn at which unloaded bearings and flanks agree. */
    constexpr unsigned int bearing_steps = 60;
    /** Unbalanced forces over contact forces, and torque over the load's. */
    constexpr double tolerance = 1e-9;

    void add_to(std::vector<double> &sum, const std::vector<double> &u)
    {
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += u[i];
    }
  } // namespace

  PairEquilibrium::PairEquilibrium(const Model               &model,
                                   Compliance                &compliance,
                                   const std::vector<double> &driver_turns)
    : model_(model)
    , compliance_(compliance)
    , pair_(model)
  {
    const unsigned int driven = model.only_transmission()->driven;
    if (!compliance.turns_freely(driven))
      throw InputError(
        "body \"" + model.bodies[driven].name() +
        "\" is driven by a torque, but a constraint holds its rotation about its axis");

    // The nodes that may touch at any position asked for: only at them displacements by unit
    // forces are kept.
    const FemSpace        &d = compliance.space();
    std::set<unsigned int> points;
    for (const double turn : driver_turns)
      {
        pair_.set_position(turn);
        pair_.find_candidates();
        for (const auto &[body, node] : pair_.candidates())
          points.insert(d.find_part(body)->first_point + node);
      }
    bodies_ = std::make_unique<PairBodies>(model,
                                           compliance,
                                           std::vector<unsigned int>(points.begin(), points.end()),
                                           pair_);
    std::vector<PressedPair::Node> nodes;
    for (const unsigned int point : compliance_.watched())
      {
        const FemSpace::Part *part = nullptr;
        for (const FemSpace::Part &one : d.parts())
          if (point >= one.first_point &&
              point < one.first_point + model.bodies[one.body].n_nodes())
            part = &one;
        nodes.push_back({part->body, point - part->first_point});
      }
    pair_.set_nodes(nodes);
  }

  PairEquilibrium::~PairEquilibrium() = default;

  double PairEquilibrium::load(const double load_factor) const
  {
    return load_factor * torque_on(model_, model_.only_transmission()->driven);
  }

  std::string PairEquilibrium::find_excess(const Eigen::VectorXd &u) const
  {
    // Pairs of teeth are looked for where undeformed bodies have them. What bearings move them by
    // is the mean over a flank's nodes.
    if (!bodies_->has_bearings())
      return "";
    const auto [apart, limit] = pair_.find_excursion(u);
    return describe_excess(apart, limit);
  }

  void PairEquilibrium::check_reach(const Eigen::VectorXd &u) const
  {
    const std::string excess = find_excess(u);
    if (!excess.empty())
      pair_.fail(excess, "");
  }

  unsigned int
  PairEquilibrium::balance(const Eigen::VectorXd &base, const double load, PressedState &now)
  {
    return PressedBalance(pair_, *bodies_, base, TurnLoad{load}).find(tolerance, now, [&]() {
      return find_excess(base + now.deflection);
    });
  }

  PressedState PairEquilibrium::settle(const Eigen::VectorXd &base, const double turn)
  {
    PressedState now;
    now.force = now.deflection = Eigen::VectorXd::Zero(base.size());
    now.turn                   = turn;
    now.touching               = false;
    now.unit                   = std::abs(load(1.)) / model_.only_transmission()->arm;
    if (!bodies_->has_bearings())
      return now;
    now.acting = pair_.evaluate(*bodies_, base, turn, false);
    balance(base, 0., now);
    return now;
  }

  PressedState PairEquilibrium::find_unloaded(const Eigen::VectorXd &base)
  {
    // Bearings that are not alike all around take the body elsewhere when it has turned to the
    // touch, by far less than the way there.
    double turn = 0;
    for (unsigned int i = 0; i < bearing_steps; ++i)
      {
        PressedState now   = settle(base, turn);
        const double touch = pair_.find_touch(base + now.deflection, load(1.) < 0 ? -1. : 1.);
        const bool   found =
          std::abs(touch - turn) * model_.only_transmission()->arm <= PressedPair::touch_tolerance;
        now.turn = turn = touch;
        if (found || !bodies_->has_bearings())
          return now;
      }
    pair_.fail("the equilibrium of the unloaded bearings did not converge", "");
  }

  PairEquilibriumResult PairEquilibrium::solve(const double driver_turn, const double load_factor)
  {
    PairEquilibriumResult result;
    result.driver_turn = driver_turn;
    pair_.set_position(driver_turn);
    pair_.find_candidates();
    const Eigen::VectorXd spun     = compliance_.at_rows(compliance_.spun());
    const PressedState    unloaded = find_unloaded(spun);
    result.touch_turn              = unloaded.turn;
    result.touch_displacements     = compliance_.spun();
    if (bodies_->has_bearings())
      add_to(result.touch_displacements, compliance_.solve(compliance_.spread(unloaded.force)));

    // u_s + part of u_T: spin and the traction of the torque
    // What the bodies do without contact; Newton's method adds the deflection by contact forces.
    const Eigen::VectorXd base = spun + load_factor * compliance_.at_rows(compliance_.twisted());
    PressedState          now  = pair_.press_rigid(*bodies_, base, load(load_factor), unloaded);
    result.iterations          = balance(base, load(load_factor), now);
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
    pair_.set_position(driver_turn);
    pair_.find_candidates();
    const Eigen::VectorXd base = compliance_.at_rows(free);
    if (pressed_ != nullptr)
      pair_.set_turn(pressed_->turn);
    const double load = torque - bodies_->set_known(compliance_.at_rows(known));
    if (pressed_ != nullptr)
      pressed_->acting =
        pair_.evaluate(*bodies_, base + pressed_->deflection, pressed_->turn, true);
    // The last equilibrium is the start while it still presses, else rigid flanks are pressed anew.
    if (pressed_ == nullptr || !pressed_->presses())
      {
        PressedState apart;
        apart.force = apart.deflection = Eigen::VectorXd::Zero(base.size());
        pressed_ =
          std::make_unique<PressedState>(pair_.press_rigid(*bodies_, base, load, std::move(apart)));
      }
    result.iterations = balance(base, load, *pressed_);
    check_reach(base + pressed_->deflection);
    result.residual      = pressed_->residual(TurnLoad{load}, model_.only_transmission()->arm);
    result.turn          = pressed_->turn;
    result.displacements = free;
    add_to(result.displacements, compliance_.solve(compliance_.spread(pressed_->force)));
    return result;
  }

  void PairEquilibrium::report(const Eigen::VectorXd &base,
                               const PressedState    &now,
                               const double           load_factor,
                               PairEquilibriumResult &result)
  {
    const TurnLoad acting{load(load_factor)};
    result.turn           = now.turn;
    result.residual       = now.residual(acting, model_.only_transmission()->arm);
    result.contact_torque = model_.only_transmission()->driven_sense * now.acting.contact_torque;
    result.teeth          = pair_.teeth();
    result.contact_forces = pair_.contact_forces();

    // Per unit of the load factor the bodies twist further, and the springs answer.
    const Eigen::VectorXd u = base + now.deflection;
    result.bearings         = bodies_->bearing_states(u);
    result.bearing_tangent  = bodies_->bearing_tangent(u);
    const auto slope        = PressedBalance(pair_, *bodies_, base, acting)
                         .find_slope(now, compliance_.at_rows(compliance_.twisted()), load(1.));
    result.turn_slope = slope.second;
    for (const PressedPair::Spring &spring : pair_.find_springs())
      {
        ContactTie tie;
        tie.stiffness = spring.stiffness;
        for (const auto &[row, direction] : spring.nodes)
          for (const auto &[point, weight] : compliance_.weights(row))
            tie.points.emplace_back(point, weight * direction);
        result.ties.push_back(std::move(tie));
      }

    // Two solutions for the fields of all points, not only the watched ones.
    result.displacements      = compliance_.solve(compliance_.spread(now.force));
    result.displacement_slope = compliance_.solve(compliance_.spread(slope.first));
    for (std::size_t i = 0; i < result.displacements.size(); ++i)
      {
        result.displacements[i] += compliance_.spun()[i] + load_factor * compliance_.twisted()[i];
        result.displacement_slope[i] += compliance_.twisted()[i];
      }
  }

  double mean_rotation(const FemSpace                  &space,
                       const unsigned int               body,
                       const std::vector<unsigned int> &nodes,
                       const std::vector<double>       &displacements)
  {
    const Body        &b     = space.model().bodies[body];
    const unsigned int first = space.find_part(body)->first_point;
    double             sum = 0, mass = 0;
    for (const unsigned int node : nodes)
      {
        const Vector3 arm = b.axis.direction.cross(space.points()[first + node] - b.axis.point);
        const Eigen::Map<const Vector3> u(displacements.data() + 3 * std::size_t(first + node));
        // u_theta / r of each node; "arm" is a x (x - c), of length r.
        sum += b.node_masses()[node] * u.dot(arm) / arm.squaredNorm();
        mass += b.node_masses()[node];
      }
    return sum / mass;
  }

  double
  lead_of_driven(const FemSpace &space, const double turn, const std::vector<double> &displacements)
  {
    const Transmission &t = *space.model().only_transmission();
    const double        driven =
      t.driven_sense * (turn + mean_rotation(space, t.driven, t.driven_bore, displacements));
    // A driver without bore turns as prescribed.
    return t.driver_bore.empty()
             ? driven
             : driven - t.ratio() * t.driver_sense *
                          mean_rotation(space, t.driver, t.driver_bore, displacements);
  }
} // namespace vfife
