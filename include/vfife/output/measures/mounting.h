// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_mounting_h
#define vfife_output_measures_mounting_h

#include <vfife/base/types.h>

#include <array>
#include <string>

namespace vfife
{
  /** Where a member of a gear pair stands: its apex [mm] and the unit vector of its axis from the
   * apex to the back. */
  struct MountedMember
  {
    Vector3 apex = Vector3::Zero(), direction = Vector3::UnitZ();
  };

  /**
   * How two members with crossing axes stand to each other, in the four numbers of gear engineers
   * (E, P, G, Sigma); the differences of two mountings are mounting errors with the signs of the
   * section Gear pair/Mounting (doc/theory/bearing.md, Misalignment).
   */
  struct Mounting
  {
    /** E: of the pinion's axis from the gear's, along gear axis x pinion axis [mm]. */
    double offset = 0;
    /** P, G: of each apex from the common perpendicular of the axes, away from the apex [mm]. */
    double pinion_shift = 0, gear_shift = 0;
    double shaft_angle = 0; ///< Sigma [rad]

    Mounting operator-(const Mounting &other) const;
  };

  /** One of the four, as users read it. */
  struct MountingNumber
  {
    std::string name, unit; ///< of its column
    double      value;
  };

  /** E, P, G in um, Sigma in arcmin. */
  std::array<MountingNumber, 4> list_numbers(const Mounting &mounting);

  /** Throws NumericalError for parallel axes. */
  Mounting find_mounting(const MountedMember &pinion, const MountedMember &gear);
} // namespace vfife

#endif
