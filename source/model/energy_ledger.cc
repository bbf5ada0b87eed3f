// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/energy_ledger.h>

namespace vfife
{
  double EnergyLedger::residual() const
  {
    // What is stored now, less what was at the start and what has been supplied,
    // plus what was lost.
    return kinetic + strain + contact - start - drive_work - torque_work + damping_loss +
           mesh_damping_loss + contact_loss;
  }

  double EnergyLedger::error() const
  {
    // Before anything has moved there is neither energy nor scale, and no error.
    return scale > 0 ? residual() / scale : 0.;
  }
} // namespace vfife
