// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_contact_impulse_h
#define vfife_contact_contact_impulse_h

#include <vfife/base/types.h>

#include <cmath>
#include <string>

namespace vfife
{
  /** Integrals of the contact of a gear pair over time, by the trapezoidal rule over all steps.
   * Plain numbers for checkpoints. */
  struct ContactImpulse
  {
    double force  = 0; ///< of the sum of the tooth pairs' forces [N s]
    double torque = 0; ///< of that on the driven member [N mm s]

    double last_force = not_known, last_torque = not_known; ///< [N], [N mm]

    /** Of the integral of the column @p name of a history. */
    static std::string column_of(const std::string &name)
    {
      return "impulse of " + name;
    }

    /** What acts now, @p dt after the last time [s]; the first time begins. */
    void add(const double dt, const double force_now, const double torque_now)
    {
      if (!std::isnan(last_force))
        {
          force += .5 * dt * (last_force + force_now);
          torque += .5 * dt * (last_torque + torque_now);
        }
      last_force  = force_now;
      last_torque = torque_now;
    }
  };
} // namespace vfife

#endif
