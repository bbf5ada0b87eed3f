// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/energy_ledger.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  double EnergyLedger::residual() const
  {
    // What is stored now, less what was at the start and what has been supplied,
    // plus what was lost.
    return kinetic + strain + contact - start - drive_work - torque_work + damping_loss +
           mesh_damping_uptake + contact_loss;
  }

  double EnergyLedger::exchanged_since(const EnergyLedger &first) const
  {
    const double within = std::abs(strain - first.strain) + std::abs(contact - first.contact) +
                          std::abs(kinetic_relative - first.kinetic_relative) +
                          std::abs(damping_loss + mesh_damping_uptake + contact_loss);
    return std::max(
      {within, std::abs(drive_work + torque_work), std::abs(kinetic - first.kinetic)});
  }

  double EnergyLedger::error() const
  {
    // Before anything has moved there is neither energy nor scale, and no error.
    return scale > 0 ? residual() / scale : 0.;
  }
} // namespace vfife
