// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_pair_pair_drive_h
#define vfife_reduced_pair_pair_drive_h

#include <vfife/reduced/pair/pair_member.h>

#include <cstdint>
#include <vector>

namespace vfife
{
  struct EnergyLedger;
  struct Transmission;

  /** What drives and loads a ReducedPair, step by step over time as the model has it. */
  struct PairDrive
  {
    double        step;        ///< length [s]
    double        driver_rate; ///< at time zero [rad/s]
    double        load;        ///< on the driven body about its axis now [N mm]
    double        turn    = 0; ///< of the driver since time zero [rad]
    double        time    = 0; ///< [s]
    std::uint64_t n_steps = 0;

    /** At time zero, in steps of @p length [s]. The model must outlive the object. */
    PairDrive(const Model &model, double length);

    /** Turn, rates and torques of the members go on to the end of the step that begins, and work is
     * added: returns the mean loads in the step, by body. */
    std::vector<AxialLoad> advance(PairMembers &members, EnergyLedger &energy);
    /** Throws NumericalError where the driven body turns so far [rad] in a step beyond the driver.
     */
    void check_turn(double turned) const;
    /** Rates now over those of the model at time zero. */
    double rate_factor() const;
    /** Of the driver since time zero after @p more steps [rad]. */
    double turn_after(double more) const;
    /** The kinematic one, in the drive direction [rad]. */
    double driven_turn() const;
    void   serialize(ByteStream &stream);

  private:
    const Model        &model_;
    const Transmission &transmission_;
  };
} // namespace vfife

#endif
