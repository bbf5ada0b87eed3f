// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_driving_h
#define vfife_gear_driving_h

#include <vfife/base/parameter_handler.h>

#include <string>

namespace vfife
{
  /** Drive: the pinion turns about + its axis (apex to back) and pushes the gear. */
  enum class MeshSide
  {
    drive,
    coast
  };

  enum class DrivingMember
  {
    pinion,
    gear
  };

  /** Forward: the pinion turns about + its axis (apex to back), the gear about -. */
  enum class TurningDirection
  {
    forward,
    reverse
  };

  /** Entries `driving member` and `direction of rotation` of the present section. */
  void declare_driving(dealii::ParameterHandler &prm,
                       DrivingMember            &driving,
                       TurningDirection         &direction);

  /** The flanks that carry the load with this driving member and direction. */
  MeshSide working_side(DrivingMember driving, TurningDirection direction);

  /** "pinion" or "gear"; "forward" or "reverse". */
  std::string name_of(DrivingMember member);
  std::string name_of(TurningDirection direction);

  /** "drive" or "coast". */
  std::string side_name(MeshSide side);
} // namespace vfife

#endif
