// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "pair_bodies.h"

#include <vfife/model/model.h>

namespace vfife
{
  namespace
  {
    /** Those of bearings: couplings are linear, and the same in all axes that turn about their own.
     */
    std::vector<BearingRing> list_bearing_rings(const Model &model, const BearingRings &rings)
    {
      return {rings.list().begin(), rings.list().begin() + model.bearings.size()};
    }

    BearingSprings make_springs(const Model &model, const BearingRings &rings)
    {
      std::vector<Vector3> centres;
      for (const BearingRing &ring : list_bearing_rings(model, rings))
        centres.push_back(ring.centre);
      const Eigen::Index    n = 6 * centres.size();
      const Eigen::MatrixXd K =
        rings.stiffness([&model](const unsigned int body) { return model.bodies[body].rate; });
      return {model, centres, K.topLeftCorner(n, n), model.only_transmission()->arm};
    }
  } // namespace

  PairBodies::PairBodies(const Model              &model,
                         Compliance               &compliance,
                         std::vector<unsigned int> points,
                         const PressedPair        &pair)
    : compliance_(compliance)
    , pair_(pair)
    , bearings_(make_springs(model, compliance.rings()))
  {
    std::vector<PointMotion> motions;
    for (BearingRing &ring : list_bearing_rings(model, compliance.rings()))
      {
        ring.motion.bottomRows<3>() *= bearings_.arm();
        motions.push_back(std::move(ring));
      }
    Eigen::Index n_known = 0;
    for (const StandingMotion &standing : compliance.standing_motions())
      {
        motions.push_back(standing);
        n_known += standing.stiffness.rows();
      }
    known_rows_ = Eigen::VectorXd::Zero(n_known);
    compliance_.watch(std::move(points), std::move(motions));
  }

  std::size_t PairBodies::bearing_row(const std::size_t i) const
  {
    return compliance_.first_motion_row() + 6 * i;
  }

  Eigen::VectorXd PairBodies::bearing_rows(const Eigen::VectorXd &u) const
  {
    return u.segment(bearing_row(0), 6 * bearings_.size());
  }

  BearingSprings::Response PairBodies::evaluate_bearings(const Eigen::VectorXd &u) const
  {
    return bearings_.evaluate(bearing_rows(u), pair_.rotations(), pair_.kinematic_turns());
  }

  std::vector<SeatState> PairBodies::bearing_states(const Eigen::VectorXd &u) const
  {
    return evaluate_bearings(u).states;
  }

  Eigen::MatrixXd PairBodies::bearing_tangent(const Eigen::VectorXd &u) const
  {
    return bearings_.tangent(evaluate_bearings(u));
  }

  double PairBodies::set_known(const Eigen::VectorXd &before)
  {
    known_rows_ = before.tail(before.size() - bearing_row(bearings_.size()));
    return bearings_.set_known(bearing_rows(before), pair_.rotations(), pair_.kinematic_turns());
  }

  Eigen::VectorXd PairBodies::answer(const Eigen::VectorXd &force)
  {
    // Forces are zero but at the few nodes under pressure and bearings: only their columns of A are
    // asked for.
    std::vector<unsigned int> rows;
    for (unsigned int k = 0; k < force.size(); ++k)
      if (force[k] != 0.)
        rows.push_back(k);
    compliance_.prepare(rows);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(force.size());
    for (const unsigned int k : rows)
      u += force[k] * compliance_.column(k);
    return u;
  }

  Eigen::MatrixXd PairBodies::flexibility(const std::vector<unsigned int> &rows)
  {
    return compliance_.flexibility(rows);
  }

  void PairBodies::add_forces(const Eigen::VectorXd &u, PressedForces &sum) const
  {
    if (has_bearings())
      evaluate_bearings(u).add_to(sum, bearing_row(0));
    std::size_t row = bearing_row(bearings_.size()), i = 0;
    for (const StandingMotion &standing : compliance_.standing_motions())
      {
        const Eigen::Index    size  = standing.stiffness.rows();
        const Eigen::VectorXd since = u.segment(row, size) - known_rows_.segment(i, size);
        const Eigen::VectorXd force = -standing.stiffness * since;
        sum.force.segment(row, size) += force;
        sum.energy -= .5 * since.dot(force);
        row += size;
        i += size;
      }
  }

  PressedSprings
  PairBodies::find_springs(const Eigen::VectorXd &u, const bool turning, const bool own) const
  {
    const Eigen::Index first = bearing_row(0), n = u.size() - first;
    PressedSprings     springs;
    springs.stiffness = Eigen::MatrixXd::Zero(n, n);
    springs.by_turn   = Eigen::VectorXd::Zero(n);
    if (own && has_bearings())
      evaluate_bearings(u).add_to(springs, turning);
    Eigen::Index row = 6 * bearings_.size();
    for (const StandingMotion &standing : compliance_.standing_motions())
      {
        const Eigen::Index size                       = standing.stiffness.rows();
        springs.stiffness.block(row, row, size, size) = standing.stiffness;
        row += size;
      }
    return springs;
  }
} // namespace vfife
