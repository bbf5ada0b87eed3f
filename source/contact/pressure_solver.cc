// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/pressure_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Penetrations h = -g: a at t_n - dt/2, b at t_n + dt/2. The mean pressure over the step is
// P(a, b) = (E(b) - E(a))/(b - a), E the law's energy, zero for h < 0; P grows with b, and b falls
// with all pressures.
namespace vfife
{
  namespace
  {
    constexpr unsigned int largest_sweeps = 500;
    /** Last change of a pressure over the largest one. */
    constexpr double tolerance = 1e-9;
    /** Of the penetration: change over a step from which on energies are told apart. */
    constexpr double small_way = 1e-3;
  } // namespace

  PressureSolver::PressureSolver(const double dt, std::vector<Node> nodes)
    : dt_(dt)
    , nodes_(std::move(nodes))
  {
  }

  void PressureSolver::reset(const double dt, const std::vector<Node> &nodes)
  {
    dt_    = dt;
    nodes_ = nodes;
    rows_.clear();
  }

  void PressureSolver::add(const TouchingPoint               &point,
                           const std::array<unsigned int, 4> &slave_nodes,
                           const std::array<unsigned int, 4> &master_nodes,
                           const SurfaceInteraction          &interaction)
  {
    Row row;
    row.law     = &interaction.law;
    row.penalty = interaction.penalty * point.stiffness;
    row.damping = interaction.damping * std::sqrt(point.stiffness);
    row.area    = point.area;
    row.gap     = point.gap;
    double rate = 0.;
    for (unsigned int k = 0; k < 8; ++k)
      {
        row.nodes[k]     = k < 4 ? slave_nodes[k] : master_nodes[k - 4];
        row.slopes[k]    = k < 4 ? Vector3(point.slave_weights[k] * point.normal_slope())
                                 : Vector3(point.master_slope(k - 4));
        const Node &node = nodes_[row.nodes[k]];
        row.responses[k] = node.inverse_mass * row.slopes[k];
        rate += row.slopes[k].dot(node.old_velocity);
        row.give += row.slopes[k].dot(row.responses[k]);
      }
    row.before = -(row.gap - 0.5 * dt_ * rate);
    row.give *= 0.5 * dt_ * dt_ * row.area;
    row.pressure = point.pressure;
    push(row, row.pressure);
    rows_.push_back(row);
  }

  double PressureSolver::end_penetration(const Row &row) const
  {
    double rate = 0.;
    for (unsigned int k = 0; k < 8; ++k)
      rate += row.slopes[k].dot(nodes_[row.nodes[k]].free_velocity);
    return -(row.gap + 0.5 * dt_ * rate);
  }

  void PressureSolver::push(const Row &row, const double pressure)
  {
    // From here on the nodes' velocities are those with the pressures so far.
    for (unsigned int k = 0; k < 8; ++k)
      nodes_[row.nodes[k]].free_velocity += (dt_ * row.area * pressure) * row.responses[k];
  }

  void PressureSolver::evaluate_law()
  {
    // Mean pressure and its slope to b. Where both ends are near each other, by Simpson's rule,
    // which has no difference of near energies; it is exact for the linear law.
    pressed_.clear();
    for (const Row &row : rows_)
      {
        const double a = std::max(row.before, 0.), b = std::max(row.after, 0.);
        pressed_.push_back({a, row.penalty});
        pressed_.push_back({.5 * (a + b), row.penalty});
        pressed_.push_back({b, row.penalty});
      }
    // One law for each run of points that share it.
    for (std::size_t first = 0; first < rows_.size();)
      {
        std::size_t last = first;
        while (last < rows_.size() && rows_[last].law == rows_[first].law)
          ++last;
        if (first == 0 && last == rows_.size())
          rows_[first].law->evaluate(pressed_);
        else
          {
            std::vector<PressedPoint> part(pressed_.begin() + 3 * first,
                                           pressed_.begin() + 3 * last);
            rows_[first].law->evaluate(part);
            std::copy(part.begin(), part.end(), pressed_.begin() + 3 * first);
          }
        first = last;
      }
    for (std::size_t i = 0; i < rows_.size(); ++i)
      {
        Row                &row  = rows_[i];
        const PressedPoint &at_a = pressed_[3 * i], &middle = pressed_[3 * i + 1],
                           &at_b = pressed_[3 * i + 2];
        const double way         = row.after - row.before;
        if (row.before <= 0. && row.after <= 0.)
          row.elastic = row.slope = 0.;
        else if (std::min(row.before, row.after) > 0. &&
                 std::abs(way) < small_way * std::max(row.before, row.after))
          {
            row.elastic = (at_a.pressure + 4. * middle.pressure + at_b.pressure) / 6.;
            row.slope   = (2. * middle.tangent + at_b.tangent) / 6.;
          }
        else
          {
            row.elastic = (at_b.energy - at_a.energy) / way;
            row.slope   = (at_b.pressure - row.elastic) / way;
          }
      }
  }

  void PressureSolver::solve(std::vector<TouchingPoint> &points)
  {
    // Sweeps: the law of all points at the ends as they are; then point by point the pressure that
    // its linearized law and the velocities of the moment ask for, never below zero.
    double change = std::numeric_limits<double>::infinity();
    for (n_sweeps_ = 0; change > tolerance; ++n_sweeps_)
      {
        if (n_sweeps_ == largest_sweeps)
          throw NumericalError("the contact pressures did not converge: after " +
                               std::to_string(n_sweeps_) + " sweeps they change by " +
                               std::to_string(change) + " of the largest pressure");
        for (Row &row : rows_)
          row.after = end_penetration(row);
        evaluate_law();
        double largest = 0., largest_change = 0.;
        for (Row &row : rows_)
          {
            const double way       = row.after - row.before;
            const double asked     = row.elastic + row.damping * way / dt_;
            const double stiffness = row.slope + row.damping / dt_;
            const double b         = end_penetration(row);
            const double error     = asked + stiffness * (b - row.after) - row.pressure;
            const double pressure =
              std::max(0., row.pressure + error / (1. + stiffness * row.give));
            push(row, pressure - row.pressure);
            largest_change = std::max(largest_change, std::abs(pressure - row.pressure));
            largest        = std::max({largest, pressure, row.pressure});
            row.pressure   = pressure;
          }
        if (!std::isfinite(largest))
          throw NumericalError("the contact pressures are not finite");
        change = largest > 0. ? largest_change / largest : 0.;
      }
    for (Row &row : rows_)
      row.after = end_penetration(row);
    evaluate_law();
    for (std::size_t i = 0; i < rows_.size(); ++i)
      {
        const Row     &row   = rows_[i];
        TouchingPoint &point = points[i];
        point.pressure       = row.pressure;
        point.gap_rate       = (row.before - row.after) / dt_;
        point.elastic        = row.damping > 0. ? row.elastic : row.pressure;
        // With m v- . v+/2 and the energy of all else at t_n, E(a), E(b) and the work of the
        // pressure from the mean of a and b to the penetration at t_n stay the same
        // (doc/theory/contact.md).
        point.energy = .5 * (pressed_[3 * i].energy + pressed_[3 * i + 2].energy) -
                       row.pressure * (.5 * (row.before + row.after) + row.gap);
      }
  }
} // namespace vfife
