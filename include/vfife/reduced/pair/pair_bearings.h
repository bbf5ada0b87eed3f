// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_pair_pair_bearings_h
#define vfife_reduced_pair_pair_bearings_h

#include <vfife/fem/pair/bearing_springs.h>
#include <vfife/fem/pair/pressed_pair.h>
#include <vfife/reduced/pair/pair_member.h>

#include <vector>

namespace vfife
{
  /** What the bearings of a ReducedPair do beyond the springs that the reduced bodies have for
   * them. Their rows are the last of the pair. */
  class PairBearings
  {
  public:
    /** Model and @p pair must outlive the object. */
    PairBearings(const Model                    &model,
                 const std::vector<ReducedBody> &bodies,
                 const PressedPair              &pair);

    /** At the displacements @p u of the pair's rows. */
    BearingSprings::Response evaluate(const Eigen::VectorXd &u) const;
    Eigen::Index             n_rows() const
    {
      return 6 * springs_.size();
    }
    /** Dampers act from the present state, in a step of the length @p step [s]; 0: they do not. */
    void begin_step(double step);
    /** The step ends with the rows at @p u, dampers included. */
    void end_step(const Eigen::VectorXd &u);
    /** The present state becomes that at @p u, where dampers do not act. */
    void set(const Eigen::VectorXd &u);

    const BearingSprings::Response &present() const
    {
      return present_;
    }
    /** Their states now, with the mean force of dampers in the last step where there was one. */
    std::vector<SeatState> measure(bool has_stepped) const;
    /** Adds what dampers lose in the step that has ended, of the length @p step [s], and what they
     * take from a driver of the @p driver_rate [rad/s]. */
    void add_damping(double driver_rate, double step, EnergyLedger &energy) const;

  private:
    BearingSprings           springs_;
    const PressedPair       &pair_;
    unsigned int             driver_;
    BearingSprings::Response present_; ///< dampers left out
    BearingSprings::Response damped_;  ///< with those of the last step
    BearingSprings::Response before_;  ///< at its begin
  };
} // namespace vfife

#endif
