// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_transmission_h
#define vfife_model_transmission_h

#include <vfife/base/parameters/parameter_history.h>
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
    double       driver_rate = 0;                    ///< d theta_driver / dt at time zero [rad/s]
    /** Of the rate over that at time zero, which falls to zero nowhere in a run; and the largest
     * such factor, by which the samples of a run are chosen. */
    ParameterHistory rate_history   = {};
    double           largest_factor = 1;

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
    bool has_constant_rate() const
    {
      return rate_history.is_constant();
    }
    /** Turn of the driver since time zero [rad]. */
    double driver_turn(const double time) const
    {
      return driver_rate * rate_history.integral(time);
    }
    /** Kinematic turn of the driven member since time zero [rad]. */
    double driven_turn(const double time) const
    {
      return ratio() * driver_turn(time);
    }
    /** [rad/s] */
    double driven_rate(const double time = 0) const
    {
      return driver_rate * ratio() * rate_history.value(time);
    }
    /** Mesh cycles per second at time zero [Hz]. */
    double mesh_frequency() const
    {
      return std::abs(driver_rate) * driver_teeth / (2 * pi);
    }
    /** [Hz] */
    double mesh_frequency(const double time) const
    {
      return mesh_frequency() * rate_history.value(time);
    }
    /** The largest of a run [Hz]. */
    double largest_mesh_frequency() const
    {
      return mesh_frequency() * largest_factor;
    }
    /** Mesh cycles since time zero. */
    double meshes(const double time) const
    {
      return mesh_frequency() * rate_history.integral(time);
    }
    /** The time at which so many mesh cycles have passed [s], negative for those before time zero,
     * when the rate was that of time zero. Throws InputError where the rate falls to zero before.
     */
    double time_of(const double meshes) const
    {
      const double constant = meshes / mesh_frequency();
      return has_constant_rate() || meshes <= 0 ? constant : rate_history.find_time(constant);
    }
  };
} // namespace vfife

#endif
