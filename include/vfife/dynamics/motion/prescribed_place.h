// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_motion_prescribed_place_h
#define vfife_dynamics_motion_prescribed_place_h

#include <vfife/model/body.h>

#include <array>
#include <optional>

namespace vfife
{
  /** Displacements [mm; theta: rad] in the directions in which a node is prescribed; the others are
   * free.
   */
  using PrescribedDisplacement = std::array<std::optional<double>, 3>;

  /** @p free with the coordinates x, y, z that are prescribed replaced by those of @p start plus
   * the displacement. */
  Vector3 place_prescribed(const Vector3                &start,
                           const Vector3                &free,
                           const PrescribedDisplacement &prescribed);

  /**
   * The same along r, theta, z of @p axis. A prescribed radius or angle moves the node from @p free
   * along the direction that r or theta had at the place @p old, as the force of a constraint of
   * central differences acts: a free rotation on a circle then keeps its speed exactly.
   */
  Vector3 place_prescribed(const Axis                   &axis,
                           const Vector3                &start,
                           const Vector3                &old,
                           const Vector3                &free,
                           const PrescribedDisplacement &prescribed);

  /** Takes out of the force @p f on a node at @p x what acts along prescribed directions. */
  Vector3 project_free(const Axis                &axis,
                       bool                       cylindrical,
                       const Vector3             &x,
                       const std::array<bool, 3> &prescribed,
                       const Vector3             &f);
} // namespace vfife

#endif
