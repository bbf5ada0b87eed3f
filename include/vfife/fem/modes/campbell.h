// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_campbell_h
#define vfife_fem_modes_campbell_h

#include <vfife/base/text/table.h>
#include <vfife/fem/modes/rotating_body.h>

#include <string>
#include <vector>

namespace vfife
{
  /**
   * A row a mode: body, speed [rpm], mode, frequency [Hz] (turning axes), residual [-], nodal
   * diameter and circles [-] (-1: the body is not made of sectors), share of that diameter [-],
   * direction of travel, shares of axial, radial and tangential motion [-], effective masses x y z
   * [kg] and inertias x y z [kg mm^2] (fixed axes, about the point of the body's axis), that point
   * x y z [mm], damping ratio [-] under @p zeta [1/s].
   */
  Table make_mode_table();
  void  add_modes(const std::string &body, const ModesAtSpeed &modes, double zeta, Table &table);

  /** Modes that belong together over the speeds: same diameter, direction and place in order. A
   * wave that the spin has overtaken stays on its branch with a negative frequency. */
  struct CampbellBranch
  {
    int                 nodal_diameter = -1;
    unsigned int        order          = 0; ///< from 1, among those of that diameter and direction
    std::string         direction;          ///< "forward", "backward", "standing"
    std::vector<double> rates, frequencies; ///< [rad/s], [Hz] in turning axes
  };

  std::vector<CampbellBranch> make_branches(const std::vector<ModesAtSpeed> &speeds);

  /** A row a point of a branch: body, nodal diameter, order, direction, speed [rpm], frequency in
   * turning axes and for an observer at rest [Hz]. */
  Table make_campbell_table();
  void
  add_branches(const std::string &body, const std::vector<CampbellBranch> &branches, Table &table);

  /**
   * Speeds at which a force that stands still in space, of frequency m z Omega (mesh order m, z
   * teeth; m = 0: the constant load), meets a branch: its harmonic of h diameters is felt by the
   * turning body at (m z + h) Omega as a wave against the speed and at |m z - h| Omega as a wave
   * with it (against it, where h > m z). Unbalance, which stands still in the turning body, meets a
   * wave of one diameter where the spin overtakes it. Between computed speeds frequencies are
   * interpolated linearly. Columns: body, nodal diameter, order, excitation, wave, mesh order,
   * speed of the body [rpm], frequency [Hz] in its turning axes, speed of the pinion [rpm]: @p
   * pinion_ratio times that of the body, no number for bodies that are none of a pair.
   */
  Table make_resonance_table();
  void  add_resonances(const std::string                 &body,
                       const std::vector<CampbellBranch> &branches,
                       unsigned int                       teeth,
                       unsigned int                       mesh_orders,
                       double                             pinion_ratio,
                       Table                             &table);
} // namespace vfife

#endif
