// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/load_torque.h>
#include <vfife/model/model.h>

namespace vfife
{
  double load_torque(const Model &model)
  {
    const Transmission *const t   = model.only_transmission();
    double                    sum = 0;
    for (const Torque &torque : model.torques)
      if (t && torque.body == t->driven)
        // Torques act + about the body's axis; what resists has the sign against its rotation.
        sum -= t->driven_sense * torque.value;
    return sum;
  }
} // namespace vfife
