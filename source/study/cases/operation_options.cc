// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/study/cases/operation_options.h>

#include <deal.II/base/parameter_handler.h>

#include <utility>

namespace vfife
{
  namespace
  {
    const Choices<HubKind> hub_kinds = {{"rigid hub", HubKind::rigid_hub},
                                        {"free rotation", HubKind::free_rotation}};
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
                                 "direction of rotation = reverse turns it round"));
    declare_quantity_over_time(prm,
                               "torque",
                               torque,
                               torque_history,
                               "N m",
                               "Torque on the driven member (the gear, if nothing else is said), "
                               "against its rotation",
                               Range::not_negative());
    declare_quantity_over_time(prm,
                               "pinion torque",
                               pinion_torque,
                               pinion_torque_history,
                               "N m",
                               "Torque at the pinion instead of that on the driven member, which "
                               "has the same work without friction: torque on the gear times "
                               "pinion teeth over gear teeth; 0: torque holds",
                               Range::not_negative());
    declare_number_or_word(
      prm,
      "tooth meshes",
      meshes,
      "until steady",
      "Length of the run in tooth meshes, or until the ripple is steady: the "
      "length that damping asks for, and half as much again as often as needed",
      1,
      1000000);
    declare_integer(prm,
                    "most tooth meshes",
                    most_meshes,
                    "After which a run until steady ends though it is not",
                    1,
                    1000000);
    declare_quantity(prm,
                     "end time",
                     end_time,
                     "s",
                     "Length of the run instead of tooth meshes; 0: these decide",
                     Range::not_negative());
    declare_number(prm,
                   "ramp",
                   ramp,
                   "Tooth meshes over which the torque grows linearly, with Dynamics/start = ramp "
                   "(whole swing periods)",
                   Range::not_negative());
    declare_quantity(prm,
                     "allowed contact pressure",
                     pressure_limit,
                     "MPa",
                     "Beyond which Hertz's pressure of one tooth pair under all the torque is said "
                     "to be too large; 1500: endurance limit of case-hardened steel, quality MQ "
                     "(ISO 6336-5); 0: none is known",
                     Range::not_negative());
    declare_driving(prm, driving, direction);
    declare_choice(
      prm,
      "hub",
      hub,
      hub_kinds,
      "Bore of the driven member, whose radial and axial displacement is held: it turns as one, as "
      "a hub on a stiff shaft does, or each of its nodes slides about the axis by itself under the "
      "constant traction of the torque, which alone gives way by some 12 arcsec without a web and "
      "4 to 9 with one of 5 mm");
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
