// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pair_bodies_h
#define vfife_fem_pair_pair_bodies_h

#include <vfife/fem/pair/bearing_springs.h>
#include <vfife/fem/pair/pressed_pair.h>
#include <vfife/fem/statics/compliance.h>

namespace vfife
{
  /**
   * The whole bodies of a pair at rest in its turning axes, their bearings and what stands still in
   * space around them. Rows, in axes of time zero: those of Compliance::watch(): three per point,
   * six of each bearing's ring, then those of standing motions.
   */
  class PairBodies : public PressedBodies
  {
  public:
    /** Watches the @p points; @p pair: where the bodies have turned to. All must outlive the
     * object. */
    PairBodies(const Model              &model,
               Compliance               &compliance,
               std::vector<unsigned int> points,
               const PressedPair        &pair);

    Eigen::VectorXd answer(const Eigen::VectorXd &force) override;
    Eigen::MatrixXd flexibility(const std::vector<unsigned int> &rows) override;
    void            add_forces(const Eigen::VectorXd &u, PressedForces &sum) const override;
    PressedSprings  find_springs(const Eigen::VectorXd &u, bool turning, bool own) const override;

    bool has_bearings() const
    {
      return bearings_.size() > 0;
    }
    std::vector<SeatState> bearing_states(const Eigen::VectorXd &u) const;
    /** As PairEquilibriumResult has it. */
    Eigen::MatrixXd bearing_tangent(const Eigen::VectorXd &u) const;

    /** Takes the displacements @p before as known, whose forces are in what else acts; returns the
     * torque that bearings have there on the driven body about its axis [N mm]. */
    double set_known(const Eigen::VectorXd &before);

  private:
    std::size_t bearing_row(std::size_t i) const;
    /** Those of all bearings of displacements at all rows. */
    Eigen::VectorXd          bearing_rows(const Eigen::VectorXd &u) const;
    BearingSprings::Response evaluate_bearings(const Eigen::VectorXd &u) const;

    Compliance        &compliance_;
    const PressedPair &pair_;
    BearingSprings     bearings_;
    Eigen::VectorXd    known_rows_; ///< of standing motions, whose forces are in what else acts
  };
} // namespace vfife

#endif
