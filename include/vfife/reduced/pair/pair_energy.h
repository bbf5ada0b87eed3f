// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_pair_pair_energy_h
#define vfife_reduced_pair_pair_energy_h

#include <vfife/model/energy_ledger.h>
#include <vfife/reduced/pair/pair_bearings.h>
#include <vfife/reduced/pair/pair_drive.h>

namespace vfife
{
  /** The energies of a ReducedPair, and the work and losses of its steps. */
  struct PairEnergy
  {
    EnergyLedger ledger;

    /** All must outlive the object; @p now: forces, deflection and what acts at the rows. */
    PairEnergy(const Model        &model,
               const PairMembers  &members,
               const PairDrive    &drive,
               const PairBearings &bearings,
               const PressedState &now);

    /** The present energies are those at the start. */
    void restart();
    /** Before anything moves. */
    void begin_step();
    /** Adds work and losses of the step, with the mean @p torque on the driven body [N mm]. */
    void end_step(double torque);
    /** Finds the energies now. */
    void measure();

    void serialize(ByteStream &stream);

  private:
    /** Way of the torque about the axis, of the driven body's turn and of its bore [rad]. */
    double torque_way() const;
    /** Powers now: of what drives and what is lost [mJ/s]. */
    EnergyLedger find_powers() const;

    const Transmission &transmission_;
    const PairMembers  &members_;
    const PairDrive    &drive_;
    const PairBearings &bearings_;
    const PressedState &now_;
    EnergyLedger        first_;
    EnergyLedger        powers_;  ///< at the begin of the step
    double              way_ = 0; ///< torque_way() there
  };
} // namespace vfife

#endif
