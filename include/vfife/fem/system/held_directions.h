// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_held_directions_h
#define vfife_fem_system_held_directions_h

#include <vfife/model/model.h>

namespace vfife
{
  /** Projects on the directions in which a constraint keeps a point from moving; @p axis: of its
   * body. */
  Matrix3 held_directions(const Constraint &constraint, const Axis &axis, const Vector3 &point);
} // namespace vfife

#endif
