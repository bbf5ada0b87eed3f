// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/spiral_bevel/machine_settings.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** An entry that may hold for both flanks. */
    struct Shared
    {
      const char *entry;
      double MachineSettings::*value;
    };

    constexpr Shared shared_entries[] = {
      {"blade angle", &MachineSettings::blade_angle},
      {"blade edge radius", &MachineSettings::edge_radius},
      {"radial distance", &MachineSettings::radial_distance},
      {"cradle angle", &MachineSettings::cradle_angle},
      {"blank offset", &MachineSettings::blank_offset},
      {"sliding base", &MachineSettings::sliding_base},
      {"machine center to back", &MachineSettings::machine_center_to_back},
      {"machine root angle", &MachineSettings::machine_root_angle},
      {"ratio of roll", &MachineSettings::ratio_of_roll},
      {"modified roll second order", &MachineSettings::second_order_roll},
      {"modified roll third order", &MachineSettings::third_order_roll},
      {"cutter tilt", &MachineSettings::cutter_tilt},
      {"cutter swivel", &MachineSettings::cutter_swivel}};
  } // namespace

  double MachineSettings::edge_width() const
  {
    // the circle touches the tip plane below its centre: rf (1 - sin al) / cos al from the tip
    return edge_radius * (1. - std::sin(blade_angle)) / std::cos(blade_angle);
  }

  // Modified roll, psi(phi) = Ra (phi - C phi^2 - D phi^3), and its derivatives in Horner's form.
  double MachineSettings::blank_rotation(const double phi) const
  {
    return ratio_of_roll * phi * (1. - phi * (second_order_roll + phi * third_order_roll));
  }

  double MachineSettings::roll_rate(const double phi) const
  {
    return ratio_of_roll * (1. - phi * (2. * second_order_roll + 3. * phi * third_order_roll));
  }

  double MachineSettings::roll_acceleration(const double phi) const
  {
    return -ratio_of_roll * (2. * second_order_roll + 6. * phi * third_order_roll);
  }

  double MachineSettings::conjugate_ratio_of_roll(const double pitch_angle) const
  {
    // at the pitch generatrix A from the apex: A cos(d - g) of the cradle, A sin(d) of the blank
    return std::cos(pitch_angle - machine_root_angle) / std::sin(pitch_angle);
  }

  Vector3 MachineSettings::apex() const
  {
    return {machine_center_to_back * std::cos(machine_root_angle),
            blank_offset,
            -sliding_base - machine_center_to_back * std::sin(machine_root_angle)};
  }

  Vector3 MachineSettings::tilt_direction() const
  {
    const double angle = cradle_angle + cutter_swivel;
    return {std::cos(angle), std::sin(angle), 0.};
  }

  void MachineSettings::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "point radius",
                     point_radius,
                     "mm",
                     "Point radius: cutter radius at the blade tip; auto: from the cutter diameter "
                     "and the other flank (spread blade)",
                     Range::positive().or_word("auto"));
    declare_shared(prm);
  }

  void MachineSettings::declare_shared(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "blade angle",
                     blade_angle,
                     "deg",
                     "Blade angle to the cutter axis",
                     Range::between(0., 60.).or_word("not given"));
    declare_quantity(prm,
                     "blade edge radius",
                     edge_radius,
                     "mm",
                     "Edge radius of the blade tip, which generates the fillet",
                     Range::positive().or_word("not given"));
    declare_quantity(prm,
                     "radial distance",
                     radial_distance,
                     "mm",
                     "Radial distance between cutter axis and cradle axis",
                     Range::positive().or_word("not given"));
    declare_quantity(prm,
                     "cradle angle",
                     cradle_angle,
                     "deg",
                     "Cradle angle of the cutter; positive for a left-hand, negative for a "
                     "right-hand member",
                     Range::between(-180., 180.).or_word("not given"));
    declare_quantity(prm,
                     "blank offset",
                     blank_offset,
                     "mm",
                     "Blank offset: distance of the blank axis from the cradle axis, along +y of "
                     "the machine");
    declare_quantity(prm,
                     "sliding base",
                     sliding_base,
                     "mm",
                     "Sliding base; positive values withdraw the blank from the cutter");
    declare_quantity(prm,
                     "machine center to back",
                     machine_center_to_back,
                     "mm",
                     "Machine center to back; positive values withdraw the blank along its own "
                     "axis");
    declare_quantity(prm,
                     "machine root angle",
                     machine_root_angle,
                     "deg",
                     "Machine root angle: angle between blank axis and machine plane",
                     Range::between(0., 90.).or_word("not given"));
    declare_number(prm,
                   "ratio of roll",
                   ratio_of_roll,
                   "Ratio of roll: rotation of the blank divided by rotation of the cradle; auto: "
                   "derived",
                   Range::positive().or_word("auto"));
    declare_number(prm,
                   "modified roll second order",
                   second_order_roll,
                   "C of the blank's rotation Ra (phi - C phi^2 - D phi^3) [1/rad]");
    declare_number(prm,
                   "modified roll third order",
                   third_order_roll,
                   "D of the blank's rotation Ra (phi - C phi^2 - D phi^3) [1/rad^2]");
    declare_quantity(prm,
                     "cutter tilt",
                     cutter_tilt,
                     "deg",
                     "Tilt angle between cutter axis and cradle axis",
                     Range::between(-45., 45.));
    declare_quantity(prm,
                     "cutter swivel",
                     cutter_swivel,
                     "deg",
                     "Swivel angle: direction of the tilt axis, measured from the line between "
                     "cradle axis and cutter axis",
                     Range::between(-180., 180.));
  }

  void MachineSettings::take_over(const MachineSettings &both)
  {
    for (const Shared &shared : shared_entries)
      if (both.*shared.value != 0.)
        this->*shared.value = both.*shared.value;
  }

  void MachineSettings::examine_shared(const MachineSettings &both,
                                       const std::string     &both_section,
                                       const std::string     &section,
                                       Findings              &findings) const
  {
    // Defaults count as not given: only what differs from both is contradicted.
    const MachineSettings untouched(blade);
    for (const Shared &shared : shared_entries)
      {
        const double own = this->*shared.value, common = both.*shared.value;
        if (common != 0. && own != common && own != untouched.*shared.value)
          findings.add(Findings::Action::stop,
                       section + "/" + shared.entry,
                       {both_section + "/" + shared.entry},
                       std::string("the ") + shared.entry +
                         " is given for both flanks and, differently, for this one");
      }
  }

  void MachineSettings::examine(const std::string &section, Findings &findings) const
  {
    const auto require = [&](const std::string &name, const double value) {
      if (value == 0.)
        findings.add_missing(section, name);
    };
    // 0 means not given
    require("point radius", point_radius);
    require("blade angle", blade_angle);
    require("blade edge radius", edge_radius);
    require("radial distance", radial_distance);
    require("cradle angle", cradle_angle);
    require("machine root angle", machine_root_angle);

    if (edge_width() >= point_radius)
      {
        std::ostringstream message;
        message << "Blade edge radius " << edge_radius << " mm does not fit a point radius of "
                << point_radius << " mm";
        findings.add(Findings::Action::stop,
                     section + "/blade edge radius",
                     {section + "/point radius"},
                     message.str());
      }
  }
} // namespace vfife
