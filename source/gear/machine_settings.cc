// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters.h>
#include <vfife/gear/findings.h>
#include <vfife/gear/machine_settings.h>

#include <cmath>
#include <sstream>

namespace vfife
{
  double MachineSettings::edge_width() const
  {
    return edge_radius * (1. - std::sin(blade_angle)) / std::cos(blade_angle);
  }

  void MachineSettings::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(
      prm,
      "point radius",
      point_radius,
      "mm",
      "Cutter radius at the blade tip; 0: derived from the cutter diameter and the other "
      "flank (spread blade)",
      Range::not_negative());
    declare_quantity(prm,
                     "blade angle",
                     blade_angle,
                     "deg",
                     "Angle of the blade to the cutter axis; 0: not given",
                     Range::between(0., 60.));
    declare_quantity(prm,
                     "blade edge radius",
                     edge_radius,
                     "mm",
                     "Rounding of the blade tip, which cuts the fillet",
                     Range::positive());
    declare_quantity(prm,
                     "radial distance",
                     radial_distance,
                     "mm",
                     "Distance of the cutter axis from the cradle axis; 0: not given",
                     Range::not_negative());
    declare_quantity(
      prm,
      "cradle angle",
      cradle_angle,
      "deg",
      "Position of the cutter on the cradle; positive for a left-hand, negative for a "
      "right-hand member; 0: not given",
      Range::between(-180., 180.));
    declare_quantity(prm,
                     "blank offset",
                     blank_offset,
                     "mm",
                     "Offset of the blank axis from the cradle axis, along +y of the machine");
    declare_quantity(prm,
                     "sliding base",
                     sliding_base,
                     "mm",
                     "Positive values withdraw the blank from the cutter");
    declare_quantity(prm,
                     "machine center to back",
                     machine_center_to_back,
                     "mm",
                     "Positive values withdraw the blank along its own axis");
    declare_quantity(prm,
                     "machine root angle",
                     machine_root_angle,
                     "deg",
                     "Angle of the blank axis to the machine plane; 0: not given",
                     Range::between(0., 90.));
    declare_number(prm,
                   "ratio of roll",
                   ratio_of_roll,
                   "Rotation of the blank over rotation of the cradle; 0: derived",
                   Range::not_negative());
  }

  void MachineSettings::examine(const std::string &section, Findings &findings) const
  {
    const auto require = [&](const std::string &name, const double value) {
      if (value == 0.)
        findings.add_missing(section, name);
    };
    require("point radius", point_radius);
    require("blade angle", blade_angle);
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
