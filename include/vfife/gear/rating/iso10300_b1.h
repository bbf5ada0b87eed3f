// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_rating_iso10300_b1_h
#define vfife_gear_rating_iso10300_b1_h

#include <vfife/gear/driving.h>

#include <array>

namespace vfife
{
  class GearPair;

  /** One member of a bevel pair without offset, generated; sizes at the mean point. */
  struct RatedMember
  {
    double teeth           = 0;
    double pitch_angle     = 0; ///< delta [rad]
    double addendum        = 0; ///< h_am [mm]
    double dedendum        = 0; ///< h_fm [mm]
    double tooth_thickness = 0; ///< s_mn, normal to the tooth, on the pitch circle [mm]
    double edge_radius     = 0; ///< rho_a0 of the tool [mm]
  };

  /** A pair for iso10300_b1(); pinion first. */
  struct RatedPair
  {
    std::array<RatedMember, 2> members;
    double                     normal_module  = 0; ///< m_mn at the mean point [mm]
    double                     spiral_angle   = 0; ///< beta_m, equal for both [rad]
    double                     pressure_angle = 0; ///< alpha_n of the loaded flanks [rad]
    double                     face_width     = 0; ///< b [mm]
    double contact_share = 0.85;                   ///< of the face width in the contact pattern [-]
    double modulus       = 0;                      ///< E* of contact_modulus() [MPa]
  };

  /** Tooth form and nominal root stress of one member. */
  struct RatedTooth
  {
    double root_thickness    = 0; ///< s_Fn, chord at the tangents of 30 deg [mm]
    double fillet_radius     = 0; ///< rho_F there [mm]
    double bending_arm       = 0; ///< h_Fa of a force at the tip [mm]
    double load_angle        = 0; ///< alpha_Fan [rad]
    double form_factor       = 0; ///< Y_Fa [-]
    double stress_correction = 0; ///< Y_Sa [-]
    double root_stress       = 0; ///< sigma_F0 [MPa]
  };

  /** Nominal stresses of method B1 and what they are made of. */
  struct BevelRating
  {
    double transverse_contact_ratio = 0; ///< eps_v_alpha [-]
    double face_contact_ratio       = 0; ///< eps_v_beta [-]
    double contact_line             = 0; ///< l_bm, length of the middle one [mm]
    double curvature_radius         = 0; ///< rho_rel normal to the contact line [mm]
    double mid_zone                 = 0; ///< Z_M-B [-]
    double load_sharing             = 0; ///< Z_LS; its square is Y_LS [-]
    double elasticity               = 0; ///< Z_E [sqrt(MPa)]
    double spiral_angle_factor      = 0; ///< Y_BS [-]
    double contact_stress           = 0; ///< sigma_H0 [MPa]

    std::array<RatedTooth, 2> teeth;
  };

  /**
   * Nominal contact stress and root stresses by ISO 10300:2023, method B1, without the factors K,
   * for a face contact ratio of at least one and low profile crowning. @p pinion_torque: [N mm].
   * Throws InputError for a smaller face contact ratio, and where no root section exists.
   * Source: ISO 10300-1:2023 annex A, -2 and -3 clause 6, as a public implementation states them;
   * checked against sample 1 of ISO/TR 10300-30:2024. Derivation in doc/theory/gear.md.
   */
  BevelRating iso10300_b1(const RatedPair &pair, double pinion_torque);

  /**
   * The pair as its flanks are: angles and thickness at the mean point of the flanks in contact on
   * @p side, edge radii of the blades that cut these flanks. @p modulus: E* [MPa].
   */
  RatedPair rated_pair(const GearPair &pair, MeshSide side, double modulus);
} // namespace vfife

#endif
