// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What the bodies of a ReducedPair answer to forces, and the bearings that they hang in.
#include "reduced_pair_parts.h"

#include <vfife/model/state.h>
#include <vfife/reduced/body_rings.h>

#include <Eigen/Geometry>

#include <cmath>

namespace vfife
{
  using Eigen::MatrixXd;
  using Eigen::VectorXd;

  std::vector<std::size_t> list_bearings(const Model &model, const unsigned int body)
  {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < model.bearings.size(); ++i)
      if (model.bearings[i].body == body)
        places.push_back(i);
    return places;
  }

  BearingSprings make_bearing_springs(const Model &model, const std::vector<ReducedBody> &bodies)
  {
    const Eigen::Index   n = 6 * model.bearings.size();
    std::vector<Vector3> centres(model.bearings.size());
    MatrixXd             linear = MatrixXd::Zero(n, n);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        // Along the axes of the body's frame, as rows of 3 x 3 blocks.
        const ReducedBody::Rings &rings  = bodies[b].rings;
        const auto               &placed = model.bodies[b].placement;
        const auto                places = list_bearings(model, b);
        for (std::size_t i = 0; i < 2 * places.size(); ++i)
          {
            if (i % 2 == 0)
              centres[places[i / 2]] = placed(rings.centres[i / 2]);
            for (std::size_t k = 0; k < 2 * places.size(); ++k)
              linear.block<3, 3>(6 * places[i / 2] + 3 * (i % 2), 6 * places[k / 2] + 3 * (k % 2)) =
                placed.rotation * rings.stiffness.block<3, 3>(3 * i, 3 * k) *
                placed.rotation.transpose();
          }
      }
    return {model, centres, linear, model.only_transmission()->arm};
  }

  VectorXd ReducedPair::Answers::answer(const VectorXd &force)
  {
    VectorXd u = VectorXd::Zero(force.size());
    for (std::size_t b = 0; b < rows_.size(); ++b)
      {
        // Few nodes are under pressure: only their columns.
        const std::vector<Eigen::Index> &places = pair_.members_[b]->places;
        VectorXd                         own    = VectorXd::Zero(places.size());
        for (std::size_t k = 0; k < places.size(); ++k)
          if (force[places[k]] != 0.)
            own += force[places[k]] * rows_[b]->flexibility().col(k);
        for (std::size_t k = 0; k < places.size(); ++k)
          u[places[k]] = own[k];
      }
    return u;
  }

  MatrixXd ReducedPair::Answers::flexibility(const std::vector<unsigned int> &rows)
  {
    // Bodies do not move each other.
    MatrixXd flexibility = MatrixXd::Zero(rows.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      {
        const auto [of_column, column] = pair_.owners_[rows[k]];
        for (std::size_t i = 0; i < rows.size(); ++i)
          if (const auto [of_row, row] = pair_.owners_[rows[i]]; of_row == of_column)
            flexibility(i, k) = rows_[of_row]->flexibility()(row, column);
      }
    return flexibility;
  }

  BearingSprings::Response ReducedPair::Answers::evaluate_bearings(const VectorXd &u) const
  {
    return pair_.springs_.evaluate(u.tail(6 * pair_.springs_.size()),
                                   pair_.pair_.rotations(),
                                   pair_.pair_.kinematic_turns());
  }

  void ReducedPair::Answers::add_forces(const VectorXd &u, PressedForces &sum) const
  {
    if (const Eigen::Index n = 6 * pair_.springs_.size(); n > 0)
      evaluate_bearings(u).add_to(sum, u.size() - n);
  }

  PressedSprings
  ReducedPair::Answers::find_springs(const VectorXd &u, const bool turning, const bool own) const
  {
    PressedSprings     springs;
    const Eigen::Index n = 6 * pair_.springs_.size();
    springs.stiffness    = MatrixXd::Zero(n, n);
    springs.by_turn      = VectorXd::Zero(n);
    if (n > 0 && own)
      evaluate_bearings(u).add_to(springs, turning);
    return springs;
  }

  PressedState ReducedPair::settle(Answers &answers, const VectorXd &base)
  {
    PressedState now;
    now.force = now.deflection = VectorXd::Zero(base.size());
    if (springs_.size() == 0)
      return now;
    now.touching = false;
    now.unit     = std::abs(load_) / model_.only_transmission()->arm;
    now.acting   = pair_.evaluate(answers, base, 0., false);
    pair_.balance(answers, base, TurnLoad{}, options_.tolerance, now);
    return now;
  }

  void ReducedPair::set_bearings(const VectorXd &u)
  {
    if (springs_.size() == 0)
      return;
    springs_.set_dampers({}, 0.);
    bearings_                               = answers_->evaluate_bearings(u);
    now_.force.tail(bearings_.force.size()) = bearings_.force;
    now_.acting.torque                      = now_.acting.contact_torque + bearings_.torque;
    now_.deflection                         = answers_->answer(now_.force);
  }

  void ReducedPair::check_reach(const std::vector<NodeOfBody> &nodes, const VectorXd &u) const
  {
    if (springs_.size() == 0)
      return;
    std::vector<Vector3>      sums(members_.size(), Vector3::Zero());
    std::vector<unsigned int> n(members_.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        sums[nodes[i].first] += pair_.rotations()[nodes[i].first] * u.segment<3>(3 * i);
        ++n[nodes[i].first];
      }
    Vector3 apart = Vector3::Zero();
    for (unsigned int b = 0; b < sums.size(); ++b)
      if (n[b] > 0)
        apart += (b == 0 ? 1. : -1.) / n[b] * sums[b];
    const std::string excess = describe_excess(apart.norm(), pair_.depth_limit());
    if (!excess.empty())
      pair_.fail(excess, "");
  }

  MeanMotion::Motion ReducedPair::measure_ring(const unsigned int b, const std::string &name) const
  {
    const Member                     &member = *members_[b];
    const unsigned int                ring   = member.body.rings.find(name);
    const Eigen::Matrix<double, 6, 1> motion = member.rows.read_ring(
      ring, member.spin, member.coordinates(), rows_of(member, now_.force), member.axial);
    const Matrix3 &R    = pair_.rotations()[b];
    const Vector3  turn = R * motion.tail<3>();
    const Body    &body = model_.bodies[b];
    // A ring beside the axis goes around it.
    const Vector3 from_axis = body.placement(member.body.rings.centres[ring]) - body.axis.point;
    MeanMotion::Motion placed;
    placed.displacement = R * motion.head<3>() + R * from_axis - from_axis;
    placed.rotation     = R;
    if (turn.norm() > 0)
      placed.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * R;
    return placed;
  }

  void ReducedPair::measure_bearings(Measurements &measured) const
  {
    measured.bearings = bearings_.states;
    // Dampers have their mean force of the last step.
    if (springs_.has_dampers() && step_ > 0)
      for (std::size_t i = 0; i < measured.bearings.size(); ++i)
        measured.bearings[i].load += .5 * (damped_.states[i].load - bearings_.states[i].load);
  }

  double ReducedPair::measure_drive_torque() const
  {
    const Member &driver = *members_[model_.only_transmission()->driver];
    double        torque = driver.inertia * driver.axial.acceleration - now_.acting.driver_torque;
    if (!driver.in_bearings())
      return torque;
    // What turns the shaft's end.
    torque = 0;
    for (const Coupling &coupling : model_.couplings)
      if (coupling.body == model_.only_transmission()->driver)
        {
          const auto [way, rate] = driver.twist(coupling, rows_of(driver, now_.force));
          torque -= coupling.stiffness * way + coupling.damping * rate;
        }
    return torque;
  }

  void ReducedPair::add_damping(const BearingSprings::Response &before)
  {
    const unsigned int driver = model_.only_transmission()->driver;
    for (std::size_t i = 0; i < damped_.states.size(); ++i)
      {
        const Vector5 force = .5 * (damped_.states[i].load - bearings_.states[i].load);
        energy_.damping_loss -=
          force.dot(bearings_.states[i].displacement - before.states[i].displacement);
      }
    energy_.drive_work -= .5 * (damped_.torques[driver] - bearings_.torques[driver]) *
                          members_[driver]->rate * options_.step;
  }
} // namespace vfife
