// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_transmission_h
#define vfife_model_transmission_h

#include <vfife/base/types.h>

#include <vector>

namespace vfife
{
  /**
   * A gear pair among the bodies of a model. Angles of the two members grow in the drive direction
   * (sense +1 or -1 about the member's axis) and are zero at the unloaded, unspun mean contact;
   * dynamic transmission error DTE = theta_driven - (z_driver / z_driven) theta_driver,   negative
   * when the driven member lags.
   */
  struct Transmission
  {
    unsigned int driver = 0, driven = 1; ///< bodies
    unsigned int driver_teeth = 0, driven_teeth = 0;
    double       driver_sense = 1, driven_sense = -1;
    double       driver_start = 0, driven_start = 0; ///< theta at time zero [rad]
    double       driver_rate = 0;                    ///< d theta_driver / dt [rad/s]

    /** Nodes whose mass-weighted mean rotation beyond the prescribed turn is the driver's; empty:
     * it turns as prescribed. */
    std::vector<unsigned int> driver_bore;
    std::vector<unsigned int>
      driven_bore; ///< nodes whose mass-weighted mean rotation is theta_driven
    std::vector<unsigned int> driven_rim; ///< nodes of the rim

    Vector3 contact_point  = Vector3::Zero();  ///< mean contact, fixed frame [mm]
    Vector3 contact_normal = Vector3::UnitX(); ///< out of the driven member, into the driver
    double  arm            = 0;                ///< |(P x n) . axis| of the driven member [mm]

    double ratio() const
    {
      return static_cast<double>(driver_teeth) / driven_teeth;
    }
    double driven_rate() const
    {
      return driver_rate * ratio();
    }
    /** Tooth meshes per second [Hz]. */
    double mesh_frequency() const
    {
      return std::abs(driver_rate) * driver_teeth / (2 * pi);
    }
  };
} // namespace vfife

#endif
