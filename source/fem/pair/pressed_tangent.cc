// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "pressed_tangent.h"

namespace vfife
{
  PressedTangent::PressedTangent(std::vector<PressedPair::Spring> springs,
                                 PressedSprings                   others,
                                 const Eigen::Index               n_rows,
                                 const double                     arm)
    : springs_(std::move(springs))
    , others_(std::move(others))
    , n_rows_(n_rows)
    , arm_(arm)
    , by_turn_(springs_.size())
  {
    // The nodes' rows are the first ones.
    const Eigen::Index        first_other = n_rows - others_.stiffness.rows();
    std::vector<unsigned int> place(first_other / 3, 0);
    for (const PressedPair::Spring &spring : springs_)
      for (const auto &[node, direction] : spring.nodes)
        place[node] = 1;
    for (unsigned int k = 0; k < place.size(); ++k)
      if (place[k] == 1)
        {
          place[k] = rows_.size();
          for (unsigned int c = 0; c < 3; ++c)
            rows_.push_back(3 * k + c);
        }
    for (unsigned int i = 0; i < springs_.size(); ++i)
      for (const auto &[node, direction] : springs_[i].nodes)
        for (unsigned int c = 0; c < 3; ++c)
          entries_.push_back({place[node] + c, i, direction[c]});
    for (Eigen::Index k = first_other; k < n_rows; ++k)
      rows_.push_back(k);
    for (Eigen::Index i = 0; i < n_springs(); ++i)
      by_turn_[i] = springs_[i].by_turn / arm;
  }

  void PressedTangent::factorize(Eigen::MatrixXd flexibility, const double turn_stiffness)
  {
    flexibility_    = std::move(flexibility);
    turn_stiffness_ = turn_stiffness;
    // [D^-1 + B^T A B, -b; b^T, k], the turn counted as a way at the arm: what the springs give
    // way by themselves and the compliance A of the bodies, and the balance of torques. Of other
    // rows, 1 + D A instead, since D may be singular, and what their forces do about the axis.
    const Eigen::Index n = n_forces(), n_others = n - n_springs();
    Eigen::MatrixXd    answers = Eigen::MatrixXd::Zero(rows_.size(), n);
    for (const Entry &entry : entries_)
      answers.col(entry.spring) += entry.value * flexibility_.col(entry.row);
    answers.rightCols(n_others) = flexibility_.rightCols(n_others);

    symmetric_ = n_others == 0;
    if (symmetric_)
      {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
        for (const Entry &entry : entries_)
          matrix.row(entry.spring) += entry.value * answers.row(entry.row);
        for (Eigen::Index i = 0; i < n; ++i)
          matrix(i, i) += 1. / springs_[i].stiffness;
        factor_.compute(matrix);
        turned_ = factor_.solve(by_turn_);
        return;
      }
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
    for (Eigen::Index i = 0; i < n; ++i)
      {
        matrix.col(i) = respond(answers.col(i));
        matrix(n, i) *= -1.;
        matrix(i, i) += i < n_springs() ? 1. / springs_[i].stiffness : 1.;
      }
    matrix.col(n).head(n_springs()) = -by_turn_;
    matrix.row(n).head(n_springs()) += by_turn_.transpose();
    matrix.col(n).segment(n_springs(), n_others) = -others_.by_turn / arm_;
    matrix(n, n) += turn_stiffness_;
    system_.compute(matrix);
  }

  Eigen::VectorXd PressedTangent::respond(const Eigen::Ref<const Eigen::VectorXd> &u) const
  {
    const Eigen::Index n_others = others_.stiffness.rows();
    Eigen::VectorXd    x        = Eigen::VectorXd::Zero(n_forces() + 1);
    for (const Entry &entry : entries_)
      x[entry.spring] += entry.value * u[entry.row];
    if (n_others > 0)
      {
        const auto d                     = u.tail(n_others);
        x.segment(n_springs(), n_others) = others_.stiffness * d;
        x[n_forces()]                    = others_.by_turn.dot(d) / arm_;
      }
    return x;
  }

  Eigen::VectorXd PressedTangent::spread(const Eigen::VectorXd &f) const
  {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(n_rows_);
    for (const Entry &entry : entries_)
      force[rows_[entry.row]] += f[entry.spring] * entry.value;
    const Eigen::Index n_others = others_.stiffness.rows();
    force.tail(n_others) += f.tail(n_others);
    return force;
  }

  Eigen::VectorXd PressedTangent::at_rows(const Eigen::VectorXd &x) const
  {
    Eigen::VectorXd values(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i)
      values[i] = x[rows_[i]];
    return values;
  }

  Eigen::VectorXd PressedTangent::find_imbalance(const Eigen::VectorXd &force,
                                                 const Eigen::VectorXd &deflection) const
  {
    return flexibility_ * at_rows(force) - at_rows(deflection);
  }

  std::pair<Eigen::VectorXd, double> PressedTangent::solve(const Eigen::VectorXd &u,
                                                           const double           torque) const
  {
    Eigen::VectorXd right = respond(u);
    if (symmetric_)
      {
        // x - turned y = S^-1 h,  b^T x + k y = torque/arm
        const Eigen::VectorXd x = factor_.solve(right.head(n_forces()));
        const double          k = turn_stiffness_ + by_turn_.dot(turned_);
        const double          y = k > 0 ? (torque / arm_ - by_turn_.dot(x)) / k : 0.;
        return {spread(-(x + y * turned_)), y / arm_};
      }
    right[n_forces()]       = torque / arm_ - right[n_forces()];
    const Eigen::VectorXd x = system_.solve(right);
    return {spread(-x.head(n_forces())), x[n_forces()] / arm_};
  }
} // namespace vfife
