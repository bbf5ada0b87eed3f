// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/driving.h>

namespace vfife
{
  namespace
  {
    const Choices<DrivingMember>    driving_members = {{"pinion", DrivingMember::pinion},
                                                       {"gear", DrivingMember::gear}};
    const Choices<TurningDirection> directions      = {{"forward", TurningDirection::forward},
                                                       {"reverse", TurningDirection::reverse}};
  } // namespace

  void declare_driving(dealii::ParameterHandler &prm,
                       DrivingMember            &driving,
                       TurningDirection         &direction)
  {
    declare_choice(prm, "driving member", driving, driving_members, "Member that drives");
    declare_choice(prm,
                   "direction of rotation",
                   direction,
                   directions,
                   "forward: the pinion rotates counter-clockwise seen from its back");
  }

  MeshSide working_side(const DrivingMember driving, const TurningDirection direction)
  {
    // a driving gear pushes with the flanks that a driving pinion uses the other way round
    const bool forward = direction == TurningDirection::forward;
    return (driving == DrivingMember::pinion) == forward ? MeshSide::drive : MeshSide::coast;
  }

  std::string name_of(const DrivingMember member)
  {
    return member == DrivingMember::pinion ? "pinion" : "gear";
  }

  std::string name_of(const TurningDirection direction)
  {
    return direction == TurningDirection::forward ? "forward" : "reverse";
  }

  std::string side_name(const MeshSide side)
  {
    return side == MeshSide::drive ? "drive" : "coast";
  }
} // namespace vfife
