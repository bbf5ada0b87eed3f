// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/model/constraints/node_constraints.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Values are read from decimal texts: round-off of their products with directions. */
    constexpr double value_tolerance = 1e-9;

    std::string text_of(const Vector3 &vector)
    {
      std::string text;
      for (const double component : vector)
        // Four digits tell a reader which place or direction is meant.
        text += (text.empty() ? "" : ", ") + number_text(std::round(1e4 * component) / 1e4 + 0.);
      return "(" + text + ")";
    }
  } // namespace

  NodeConstraints::NodeConstraints(const Body &body, const Vector3 &place)
    : body_(&body)
    , place_(place)
  {
  }

  void NodeConstraints::add(const Constraint &constraint)
  {
    constraints_.push_back(&constraint);
    for (const HeldDirection &held : find_held_directions(constraint, *body_, place_))
      {
        // n = sum_j row_j q_j + rest: twice, since once leaves round-off over a small rest.
        Vector3 rest = held.direction, row = Vector3::Zero();
        for (unsigned int pass = 0; pass < 2; ++pass)
          for (unsigned int j = 0; j < n_held_; ++j)
            {
              const double along = axes_.col(j).dot(rest);
              row[j] += along;
              rest -= along * axes_.col(j);
            }
        const double length = rest.norm();
        int          own    = -1;
        if (n_held_ < 3 && length > parallel_angle)
          {
            own            = static_cast<int>(n_held_);
            row[own]       = length;
            axes_.col(own) = rest / length;
            ++n_held_;
          }
        held_.push_back(held);
        rows_.push_back(row);
        rest_.push_back(own < 0 ? length : 0.);
        own_axis_.push_back(own);
      }
  }

  void NodeConstraints::check() const
  {
    // 1. Turning with a body at its speed is a displacement that grows for ever: it agrees with
    // other equations for all times or for none.
    std::vector<double> rates;
    for (const HeldDirection &held : held_)
      rates.push_back(held.rate);
    solve(rates, "mm/s");

    // 2. All nodes of a rigid hub share one rotation, which no other constraint may take away from
    // some of them.
    const auto hub =
      std::find_if(constraints_.begin(), constraints_.end(), [](const Constraint *constraint) {
        return constraint->kind == ConstraintKind::rigid_hub;
      });
    if (hub == constraints_.end())
      return;
    const unsigned int of_hub =
      std::count_if(held_.begin(), held_.end(), [&](const HeldDirection &held) {
        return held.constraint == *hub;
      });
    for (const Constraint *other : constraints_)
      if (other != *hub && (other->kind == ConstraintKind::rigid_hub || n_held_ > of_hub))
        throw InputError("Model/Constraint " + other->name + "/nodes",
                         "constraints \"" + (*hub)->name + "\" and \"" + other->name +
                           "\" are incompatible at the node " + text_of(place_) + " of body \"" +
                           body_->name() + "\": the nodes of the rigid hub \"" + (*hub)->name +
                           "\" share one rotation. Hold at most their radius and axial position");
  }

  std::vector<HeldDirection> NodeConstraints::independent() const
  {
    std::vector<HeldDirection> directions;
    for (std::size_t k = 0; k < held_.size(); ++k)
      if (own_axis_[k] >= 0)
        directions.push_back(held_[k]);
    return directions;
  }

  Matrix3 NodeConstraints::axes() const
  {
    Matrix3 axes = axes_;
    if (n_held_ == 0)
      return Matrix3::Identity();
    if (n_held_ == 1)
      axes.col(1) = Vector3(axes.col(0)).unitOrthogonal();
    if (n_held_ < 3)
      axes.col(2) = Vector3(axes.col(0)).cross(Vector3(axes.col(1)));
    return axes;
  }

  const Constraint *NodeConstraints::turning() const
  {
    // Radius and axial position are held, and nothing else: a hub comes first.
    const Constraint *turning = nullptr;
    for (const Constraint *constraint : constraints_)
      if (constraint->kind == ConstraintKind::rigid_hub ||
          (constraint->kind == ConstraintKind::free_rotation && turning == nullptr))
        turning = constraint;
    return n_held_ == 2 ? turning : nullptr;
  }

  Vector3 NodeConstraints::compute_displacement(const Factor &factor) const
  {
    std::vector<double> values;
    for (const HeldDirection &held : held_)
      values.push_back(held.value == 0 ? 0. : held.value * factor(*held.constraint));
    return solve(values, "mm");
  }

  std::vector<std::pair<const Constraint *, Vector3>>
  NodeConstraints::share(const Vector3 &force, const Vector3 &place) const
  {
    Eigen::Matrix3Xd directions(3, held_.size());
    for (std::size_t k = 0; k < held_.size(); ++k)
      directions.col(k) = present_direction(held_[k], body_->axis, place);
    const Eigen::VectorXd                               shares = share_force(directions, force);
    std::vector<std::pair<const Constraint *, Vector3>> parts;
    Vector3                                             rest = force;
    for (std::size_t k = 0; k < held_.size(); ++k)
      {
        parts.emplace_back(held_[k].constraint, shares[k] * directions.col(k));
        rest -= parts.back().second;
      }
    // The rest acts along the tangent of a hub.
    const auto hub =
      std::find_if(constraints_.begin(), constraints_.end(), [](const Constraint *constraint) {
        return constraint->kind == ConstraintKind::rigid_hub ||
               constraint->kind == ConstraintKind::free_rotation;
      });
    parts.emplace_back(hub == constraints_.end() ? constraints_.front() : *hub, rest);
    return parts;
  }

  const Constraint &NodeConstraints::leading() const
  {
    for (const ConstraintKind kind : {ConstraintKind::prescribed_rotation,
                                      ConstraintKind::held,
                                      ConstraintKind::rigid_hub,
                                      ConstraintKind::directions})
      for (const Constraint *constraint : constraints_)
        if (constraint->kind == kind)
          return *constraint;
    return *constraints_.front();
  }

  bool NodeConstraints::has_values_to_compare() const
  {
    return held_.size() > n_held_ &&
           std::any_of(held_.begin(), held_.end(), [](const HeldDirection &held) {
             return held.value != 0;
           });
  }

  Vector3 NodeConstraints::solve(const std::vector<double> &values, const char *unit) const
  {
    // Coordinates y in the axes, u = Q y: row_k . y = g_k of the independent equations in turn, as
    // each has entries in the axes up to its own. The others have to hold then.
    Vector3 y    = Vector3::Zero();
    double  size = 0;
    for (const double value : values)
      size = std::max(size, std::abs(value));
    for (std::size_t k = 0; k < held_.size(); ++k)
      if (const int own = own_axis_[k]; own >= 0)
        y[own] = (values[k] - rows_[k].dot(y)) / rows_[k][own];
      else if (std::abs(values[k] - rows_[k].dot(y)) > (value_tolerance + rest_[k]) * size)
        refuse(k, values, unit);
    return axes_ * y;
  }

  void NodeConstraints::refuse(const std::size_t          k,
                               const std::vector<double> &values,
                               const char                *unit) const
  {
    // The other one: the earlier equation whose direction is nearest to this one's.
    std::size_t other = 0;
    double      best  = -1;
    for (std::size_t j = 0; j < k; ++j)
      if (const double near = std::abs(held_[j].direction.dot(held_[k].direction)); near > best)
        {
          best  = near;
          other = j;
        }
    const auto say = [&](const std::size_t j) {
      return "\"" + held_[j].constraint->name + "\" prescribes " + number_text(values[j]) + " " +
             unit + " along " + text_of(held_[j].direction);
    };
    throw InputError("Model/Constraint " + held_[k].constraint->name + "/nodes",
                     "constraints \"" + held_[other].constraint->name + "\" and \"" +
                       held_[k].constraint->name + "\" contradict each other at the node " +
                       text_of(place_) + " of body \"" + body_->name() + "\": " + say(other) +
                       ", " + say(k));
  }

  std::map<unsigned int, NodeConstraints> combine_constraints(const Model       &model,
                                                              const unsigned int body)
  {
    std::map<unsigned int, NodeConstraints> nodes;
    const Body                             &of = model.bodies[body];
    for (const Constraint &constraint : model.constraints)
      if (constraint.body == body)
        for (const unsigned int i : constraint.nodes)
          nodes.try_emplace(i, of, of.placement(of.node_positions()[i]))
            .first->second.add(constraint);
    for (const auto &[node, constraints] : nodes)
      constraints.check();
    return nodes;
  }

  Matrix3 free_directions(const std::map<unsigned int, NodeConstraints> &constraints,
                          const unsigned int                             node)
  {
    const auto found = constraints.find(node);
    if (found == constraints.end() || found->second.turning() != nullptr)
      return Matrix3::Identity();
    const Matrix3 axes = found->second.axes();
    const auto    free = axes.rightCols(3 - found->second.n_held());
    return free * free.transpose();
  }

  Eigen::VectorXd share_force(const Eigen::Matrix3Xd &directions, const Vector3 &force)
  {
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3Xd> factors;
    factors.setThreshold(parallel_angle);
    return factors.compute(directions).solve(force);
  }
} // namespace vfife
