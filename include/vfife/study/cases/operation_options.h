// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_operation_options_h
#define vfife_study_cases_operation_options_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/parameters/parameter_history.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/types.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>

#include <string>

namespace vfife
{
  /** How the hub of the driven member turns. */
  enum class HubKind
  {
    rigid_hub,    ///< all nodes of the bore as one
    free_rotation ///< each node by itself
  };

  /** Section Operation: what the pair is run at. */
  struct OperationOptions
  {
    double speed         = 0; ///< of the pinion at time zero [rad/s]
    double torque        = 0; ///< on the driven member at time zero [N mm]
    double pinion_torque = 0; ///< on the pinion instead [N mm]; 0: torque holds
    /** Over the values at time zero. */
    ParameterHistory speed_history, torque_history, pinion_torque_history;

    /** Mesh cycles to run, or until the ripple is steady, and the most of these. */
    NumberOrWord meshes      = {40, false};
    unsigned int most_meshes = 400;
    double       end_time    = 0;  ///< of the run instead [s]; 0: meshes decide
    double       ramp        = 12; ///< of the torque, with Dynamics/start = ramp [mesh cycles]
    HubKind      hub         = HubKind::rigid_hub;

    /** Endurance limit for contact stress of case-hardened steel, quality MQ (ISO 6336-5); 0: none
     * is known [MPa]. */
    double pressure_limit = 1500;

    DrivingMember    driving   = DrivingMember::pinion;
    TurningDirection direction = TurningDirection::forward;

    void declare(dealii::ParameterHandler &prm);
    /** Throws InputError for a load that is missing or given twice. */
    void check(const std::string &section) const;

    /** Throws InputError where there is no speed. */
    void require_speed(const std::string &section) const;

    /** Throws InputError where the gear drives, which @p study (a noun) does not take. */
    void require_driving_pinion(const std::string &section, const std::string &study) const;

    /** Throws InputError where speed or torque change with time, which @p study (a noun) does not
     * know. */
    void require_constant(const std::string &section, const std::string &study) const;

    /** Mesh cycles per second at time zero [Hz]. */
    double mesh_frequency(unsigned int pinion_teeth) const
    {
      return speed * pinion_teeth / (2 * pi);
    }
  };
} // namespace vfife

#endif
