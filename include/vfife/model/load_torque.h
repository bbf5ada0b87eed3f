// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_load_torque_h
#define vfife_model_load_torque_h

namespace vfife
{
  struct Model;

  /** Torque on the driven member of a model's gear pair about its axis, positive against its
   * rotation; 0 without a gear pair [N mm]. */
  double load_torque(const Model &model);
} // namespace vfife

#endif
