// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/pair/pressed_state.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  double PressedState::potential(const TurnLoad &load) const
  {
    return 0.5 * force.dot(deflection) + acting.energy + load.potential(turn);
  }

  double PressedState::residual(const TurnLoad &load, const double arm) const
  {
    const double imbalance = (acting.force - force).norm();
    if (!touching)
      return imbalance / unit;
    const double scale = std::max(unit, acting.contact_force);
    return std::max(imbalance / scale,
                    std::abs((acting.torque + load.at(turn)) /
                             (unit > 0 ? scale * arm : load.torque)));
  }

  bool PressedState::presses() const
  {
    return !touching || unit > 0 || acting.contact_energy > 0;
  }
} // namespace vfife
