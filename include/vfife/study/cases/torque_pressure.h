// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_torque_pressure_h
#define vfife_study_cases_torque_pressure_h

#include <vfife/base/types.h>

#include <string>

namespace vfife
{
  class HertzContact;
  struct Model;

  /** Hertz's contact of one tooth pair that carries all the torque at the mean contact. */
  struct TorquePressure
  {
    /** @p force: torque over arm [N]. */
    TorquePressure(const HertzContact &hertz, double force);
    TorquePressure(const HertzContact &hertz, const Model &model);

    /** One line for the log. */
    std::string describe() const;

    /** What is wrong where it is above @p limit [MPa]; empty where it is not, or for a limit of 0.
     */
    std::string find_excess(double limit) const;

    Vector2 semi_axes; ///< [mm], the larger first
    double  largest;   ///< [MPa]
  };
} // namespace vfife

#endif
