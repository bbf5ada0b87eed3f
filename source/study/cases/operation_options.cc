// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/study/cases/operation_options.h>

#include <deal.II/base/parameter_handler.h>

#include <utility>

namespace vfife
{
  namespace
  {
    const Choices<HubKind> hub_kinds = {{"rigid", HubKind::rigid_hub},
                                        {"per node", HubKind::free_rotation}};
  } // namespace

  void OperationOptions::declare(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Operation");
    declare_quantity_over_time(prm,
                               "speed",
                               speed,
                               speed_history,
                               "rpm",
                               "Speed of the pinion",
                               Range::not_negative().with_hint(
                                 "direction of rotation = reverse reverses it"));
    declare_quantity_over_time(
      prm,
      "torque",
      torque,
      torque_history,
      "N m",
      "Torque on the driven member (by default the gear), against its rotation",
      Range::not_negative());
    declare_quantity_over_time(
      prm,
      "pinion torque",
      pinion_torque,
      pinion_torque_history,
      "N m",
      "Torque on the pinion, instead of torque: torque on the gear is this torque "
      "times gear teeth divided by pinion teeth; 0: torque applies",
      Range::not_negative());
    declare_number_or_word(
      prm,
      "mesh cycles",
      meshes,
      "until steady",
      "Length of the run in mesh cycles. until steady: the length that the damping "
      "requires, extended by half until the ripple is steady",
      1,
      1000000);
    declare_integer(
      prm, "maximum mesh cycles", most_meshes, "Maximum length of a run until steady", 1, 1000000);
    declare_quantity(
      prm,
      "end time",
      end_time,
      "s",
      "Length of the run as a time, instead of mesh cycles; not given: mesh cycles apply",
      Range::positive().or_word("not given"));
    declare_number(prm,
                   "ramp",
                   ramp,
                   "Mesh cycles over which the torque grows linearly, with Dynamics/start = ramp "
                   "(whole periods of the torsional vibration)",
                   Range::not_negative());
    declare_quantity(prm,
                     "contact stress limit",
                     pressure_limit,
                     "MPa",
                     "Contact stress limit: the program warns if Hertzian pressure of a single "
                     "tooth pair under the whole torque exceeds it. 1500: endurance limit of "
                     "case-hardened steel, quality MQ (ISO 6336-5), without factors for life, size "
                     "and lubrication; none: no limit",
                     Range::positive().or_word("none"));
    declare_driving(prm, driving, direction);
    declare_choice(
      prm,
      "bore rotation",
      hub,
      hub_kinds,
      "Rotation of the driven member's bore, whose radial and axial displacements "
      "are zero. rigid: the bore rotates as one, as on a stiff shaft; per node: "
      "each node rotates independently under the uniform traction of the torque, which "
      "adds some 4 to 12 arcsec of transmission error");
  }

  void OperationOptions::require_speed(const std::string &section) const
  {
    // Zero is allowed when the entry is declared: kinds that stand still have no use for a speed.
    if (!(speed > 0))
      throw InputError(section + "/speed", "expected a speed of the pinion above 0, got none");
  }

  void OperationOptions::check(const std::string &section) const
  {
    if (torque > 0 && pinion_torque > 0)
      throw InputError(
        section + "/pinion torque",
        "expected torque (on the driven member) or pinion torque, got both. Remove one of them");
    if (!(torque > 0) && !(pinion_torque > 0))
      throw InputError(section + "/torque",
                       "expected torque or pinion torque above 0, got none; flanks without load do "
                       "not stay in contact");
  }

  void OperationOptions::require_constant(const std::string &section,
                                          const std::string &study) const
  {
    using NamedHistory = std::pair<const char *, const ParameterHistory *>;
    for (const auto &[entry, history] : {NamedHistory("/speed", &speed_history),
                                         NamedHistory("/torque", &torque_history),
                                         NamedHistory("/pinion torque", &pinion_torque_history)})
      if (!history->is_constant())
        throw InputError(
          section + entry,
          "the " + study +
            " requires a constant value. Use kind run or reduced for values over time");
  }

  void OperationOptions::require_driving_pinion(const std::string &section,
                                                const std::string &study) const
  {
    if (driving != DrivingMember::pinion)
      throw InputError(section + "/driving member",
                       "the " + study +
                         " requires that the pinion drives. Set direction of rotation = reverse "
                         "for the flanks of a driving gear");
  }
} // namespace vfife
