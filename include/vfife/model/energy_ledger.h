// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_energy_ledger_h
#define vfife_model_energy_ledger_h

namespace vfife
{
  /** Energies since the start of the run [mJ]. Work is counted as received by the bodies,
   * dissipation as lost. */
  struct EnergyLedger
  {
    double kinetic          = 0; ///< now
    double kinetic_relative = 0; ///< of the motion relative to the rigidly turning bodies, now
    double strain           = 0; ///< of bodies and springs to the ground, now
    double contact          = 0; ///< stored in the contact's springs, those of stick included, now
    double drive_work       = 0;
    double torque_work      = 0;
    double damping_loss     = 0;
    /** Taken by the driven speed damping, a speed controller: negative where it has given. */
    double mesh_damping_uptake = 0;
    double contact_loss        = 0; ///< contact damping and friction
    double start               = 0; ///< kinetic + strain + contact at the start
    double scale               = 0; ///< largest value so far that the error is divided by; at least
                                    ///< scale_floor of the kinetic energy at the start, and the
                                    ///< energy of approach of flying bodies that have touched
    // From here on in the order in which versions have added them, as checkpoints keep it.
    double friction_loss = 0; ///< part of contact_loss
    /** Part of mesh_damping_uptake that comes from motion relative to the kinematic rotation, a
     * loss; the rest passes through the rotation. Counted from where a run of a version without it
     * went on. */
    double swing_loss = 0;
    /** Round-off of the kinetic energy of rigid flight or spin is some 1e-15 of it and must not be
     * the measure of itself. */
    static constexpr double scale_floor = 1e-10;

    /** What the sum of the energies has gained beyond work less losses [mJ]. */
    double residual() const;
    /** What has been exchanged since the state @p first: within the bodies and lost; with what
     * drives and loads them, less what only passes through; or by their motion as a whole; the
     * largest of them [mJ]. */
    double exchanged_since(const EnergyLedger &first) const;
    /** Residual over the scale; doc/reference/conventions.md, Steady part and figures. */
    double error() const;
  };
} // namespace vfife

#endif
