// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_lumped_mesh_law_h
#define vfife_lumped_mesh_law_h

#include <vfife/base/text/table.h>
#include <vfife/lumped/fourier_series.h>

#include <string>

namespace vfife
{
  /** How the torque of the mesh grows with the compression between no load and the load at which a
   * loaded tooth contact analysis was made. */
  enum class LoadLaw
  {
    power,   ///< through both states, with the tangent of the loaded one
    tangent, ///< linear, with the tangent of the loaded state
    secant   ///< linear, through both states
  };

  /**
   * The elastic torque of the gear mesh on the gear [N mm] over the compression s [rad of the gear]
   * and the position x [mesh cycles]:
   *   M = k(x) s (k(x) s/T0)^(p(x) - 1),  s > 0;   0,  -b < s < 0;   -M(-(s + b)),  s < -b
   * with the secant stiffness k at the torque T0 and the backlash b (doc/theory/lumped.md).
   */
  struct MeshLaw
  {
    FourierSeries stiffness;             ///< k [N mm/rad]
    FourierSeries exponent = 1.;         ///< p: tangent over secant stiffness at T0
    FourierSeries unloaded_error;        ///< DTE at which the flanks touch without load [rad]
    double        reference_torque = 1.; ///< T0 [N mm]
    double        backlash         = 0.; ///< b, rotation of the gear [rad]

    /** From loaded_contact.csv, whose positions must divide a mesh cycle equally. Throws
     * InputError. */
    static MeshLaw from_table(const Table &table, const std::string &path, LoadLaw law);

    double torque(double s, double x) const;
    /** dM/ds. */
    double slope(double s, double x) const;
    /** Integral of M over s [mJ]. */
    double energy(double s, double x) const;
    /** d energy/dx at constant s [mJ per mesh cycle]. */
    double energy_slope(double s, double x) const;
    /** The compression under a positive torque [rad]. */
    double compression(double torque, double x) const;
  };
} // namespace vfife

#endif
