// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_turn_pins_h
#define vfife_fem_system_turn_pins_h

#include <vfife/fem/system/fem_system.h>

#include <vector>

namespace vfife
{
  /** Whether a hub of a body of the model lets it turn about its axis. */
  bool has_turning_hub(const Model &model, unsigned int body);

  /** Whether a rigid motion of a body (3 numbers a point) is nothing but a turn about its axis. */
  bool
  is_turn(const FemSpace &space, const FemSpace::Part &part, const std::vector<double> &motion);

  /**
   * Torsional springs on the first bearing of each of @p bodies, which turn freely in their
   * bearings, over the motions of all @p rings: they carry nothing where loads have no moment about
   * the axis, so that their stiffness (the shear modulus times the cube of the ring's radius) does
   * not matter [N/mm, N, N mm].
   */
  Eigen::MatrixXd make_turn_pins(const FemSpace                  &space,
                                 const BearingRings              &rings,
                                 const std::vector<unsigned int> &bodies);

  /** K with these springs. Collective. */
  FemMatrix
  add_turn_pins(const FemSystem &system, const std::vector<unsigned int> &bodies, FemMatrix K);
} // namespace vfife

#endif
