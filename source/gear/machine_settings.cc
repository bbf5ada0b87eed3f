// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters.h>
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
      "Point radius",
      point_radius,
      "mm",
      "Cutter radius at the blade tip; 0: derived from the cutter diameter and the other "
      "flank (spread blade)",
      Range::not_negative());
    declare_quantity(prm,
                     "Blade angle",
                     blade_angle,
                     "deg",
                     "Angle of the blade to the cutter axis; 0: not given",
                     Range::between(0., 60.));
    declare_quantity(prm,
                     "Blade edge radius",
                     edge_radius,
                     "mm",
                     "Rounding of the blade tip, which cuts the fillet",
                     Range::positive());
    declare_quantity(prm,
                     "Radial distance",
                     radial_distance,
                     "mm",
                     "Distance of the cutter axis from the cradle axis; 0: not given",
                     Range::not_negative());
    declare_quantity(
      prm,
      "Cradle angle",
      cradle_angle,
      "deg",
      "Position of the cutter on the cradle; positive for a left-hand, negative for a "
      "right-hand member; 0: not given",
      Range::between(-180., 180.));
    declare_quantity(prm,
                     "Blank offset",
                     blank_offset,
                     "mm",
                     "Offset of the blank axis from the cradle axis, along +y of the machine");
    declare_quantity(prm,
                     "Sliding base",
                     sliding_base,
                     "mm",
                     "Positive values withdraw the blank from the cutter");
    declare_quantity(prm,
                     "Machine center to back",
                     machine_center_to_back,
                     "mm",
                     "Positive values withdraw the blank along its own axis");
    declare_quantity(prm,
                     "Machine root angle",
                     machine_root_angle,
                     "deg",
                     "Angle of the blank axis to the machine plane; 0: not given",
                     Range::between(0., 90.));
    declare_number(prm,
                   "Ratio of roll",
                   ratio_of_roll,
                   "Rotation of the blank over rotation of the cradle; 0: derived",
                   Range::not_negative());
  }

  void MachineSettings::check(const std::string &section) const
  {
    const auto require = [&](const std::string &name, const double value) {
      if (value == 0.)
        throw InputError(section + "/" + name,
                         name + " is missing in section \"" + section + "\": it has no default");
    };
    require("Point radius", point_radius);
    require("Blade angle", blade_angle);
    require("Radial distance", radial_distance);
    require("Cradle angle", cradle_angle);
    require("Machine root angle", machine_root_angle);

    if (edge_radius <= 0.)
      throw InputError(section + "/Blade edge radius", "Blade edge radius must be positive");
    if (edge_width() >= point_radius)
      {
        std::ostringstream message;
        message << "Blade edge radius " << edge_radius << " mm does not fit a point radius of "
                << point_radius << " mm";
        throw InputError(section + "/Blade edge radius", message.str());
      }
  }
} // namespace vfife
