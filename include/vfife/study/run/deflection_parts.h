// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_deflection_parts_h
#define vfife_study_run_deflection_parts_h

#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/measures/support_leads.h>

#include <vector>

namespace vfife
{
  class Communicator;

  /**
   * Where the transmission error of a loaded pair at the mean contact comes from [rad], lag
   * negative. With n the normal out of the driven member into the driver and p its arm about the
   * driven axis, flanks that touch after displacements u_g (driven) and u_p (driver) at the contact
   * ask the hub for the rotation
   *   (n . u_g - n . u_p)/p   in the drive direction.
   */
  struct DeflectionParts
  {
    double total       = 0;
    double centrifugal = 0; ///< displacement of both flanks by spinning alone
    double web_windup  = 0; ///< rotation of the rim against the hub under load
    double rim_tilt = 0; ///< of the rim's rigid motion under load tilt and shift, from the hub on
    double teeth    = 0; ///< what remains: bending of teeth, contact, pinion body
  };

  /** The lowest oscillation of a loaded pair whose driver is held. */
  struct Swing
  {
    double stiffness = 0; ///< torque over rotation of the driven member's hub [N mm/rad]
    double inertia   = 0; ///< of the shape, as of a rotation of the hub [t mm^2]

    /** [Hz]; 0 where nothing is known. */
    double frequency() const;
  };

  /**
   * Displacement of the driven rim by its waves of two and more nodal diameters, at the mean
   * contact of a gear pair.
   *
   * Each sector of the rim has a rigid motion of its own, fitted by least squares over its masses.
   * Taken to the contact point of the sector's own tooth, and turned back onto the first one, these
   * displacements d_k are a periodic function of the sector k. With z sectors, alpha = 2 pi/z and
   *   d^_n = 1/z sum_k d_k exp(-i n k alpha)
   * the waves 2 to N have at the contact, in sector c, the displacement
   *   2 Re sum_n d^_n exp(i n c alpha).
   * Waves 0 and 1 hold the rim's rigid motion.
   */
  class RimBending
  {
  public:
    /** Waves up to @p largest; fewer where there are not twice as many teeth. The model, which has
     * a gear pair, must outlive the object. */
    RimBending(const Model &model, unsigned int largest);

    /** [mm], fixed frame at rest; zero for a driven body that is not made of equal sectors.
     * Collective. */
    Vector3 measure(const State &state, const Communicator &communicator) const;

  private:
    const Model              &model_;
    unsigned int              n_sectors_ = 0, largest_, contact_sector_ = 0;
    std::vector<unsigned int> sectors_; ///< of the rim's nodes
  };

  /** Displacements of a pair at rest in its turning frames, for DeflectionParts. */
  class DeflectionProbe
  {
  public:
    DeflectionProbe(const Model &model, const Communicator &communicator);

    /** To be called with the spun, unloaded state. Collective. */
    void take_spun(State &state);

    /** With the state under a part of the torque. Collective. */
    void take_partly_loaded(State &state, double torque);

    /** With the state under the full torque. Collective. */
    DeflectionParts take_loaded(State &state);

    /** What the loaded rim's bending with two and more nodal diameters adds, up to largest_wave:
     * its flank is elsewhere than the rim's rigid motion takes it [rad]. It is not in `teeth`. */
    double rim_bending() const
    {
      return rim_bending_;
    }

    /** Bending with more nodal diameters is as short as a few teeth: it belongs to these. */
    static constexpr unsigned int largest_wave = 8;

    /** Of the loaded state; zero for bodies without bearings. */
    const SupportParts &supports() const
    {
      return supports_;
    }

    /**
     * The slope of the pair at full load, from the partly loaded state to that of take_loaded().
     * With u the difference of both shapes and psi the rotation of the driven hub, to which a shaft
     * of the driver adds what it winds up, the swing of the pair in the shape u has the frequency
     * (1/2pi) sqrt(k/J), k = dT/psi and J = sum m u . u/psi^2 (Rayleigh). Collective.
     */
    Swing compute_swing(const State &loaded, double torque) const;

  private:
    struct Shape
    {
      double  contact  = 0;               ///< (n . u_g - n . u_p)/p at the flanks
      double  hub_lead = 0, rim_lead = 0; ///< transmission errors
      double  driven_turn = 0;            ///< of the driven hub alone, drive direction
      Vector3 rim_shift =
        Vector3::Zero(); ///< rigid motion of the rim: u = shift + tilt x (x - axis point)
      Vector3 rim_turn = Vector3::Zero();
      /** (n . u)/p of the rim's bending at the contact, RimBending. */
      double rim_bending = 0;

      SupportLeads::Leads supports; ///< of contact, what shafts make
    };
    Shape measure(State &state) const;
    Vector3
    flank_displacement(const State &state, unsigned int body, const std::string &surface) const;
    void fit_rim(const State &state, Shape &shape) const;

    const Model        &model_;
    const Communicator &communicator_;
    SupportLeads        supports_of_;
    RimBending          rim_bending_of_;
    Shape               spun_;
    SupportParts        supports_;
    double              partial_torque_ = 0, partial_turn_ = 0; ///< [N mm], [rad]
    double              loaded_turn_ = 0, rim_bending_ = 0;     ///< [rad]
    NodeField           partial_position_;                      ///< [mm]
  };
} // namespace vfife

#endif
