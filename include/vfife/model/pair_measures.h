// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_pair_measures_h
#define vfife_model_pair_measures_h

#include <cstddef>
#include <optional>
#include <vector>

namespace vfife
{
  struct Measurements;
  struct Model;
  struct ToothContact;
  struct Transmission;

  /** What a gear pair says of one of its bodies. */
  struct MemberOfPair
  {
    unsigned int                     teeth;
    double                           sense; ///< in which it turns about its axis
    const std::vector<unsigned int> &bore;  ///< of the pair
  };

  /** The driven member where it is @p body, otherwise the driver. */
  MemberOfPair find_member(const Transmission &pair, unsigned int body);

  /** Sum of the model's torques on a body about its axis, at full load or, with their histories, at
   * a @p time [N mm]. */
  double torque_on(const Model &model, unsigned int body, const std::optional<double> &time = {});

  /** Torque on the driven member of a model's gear pair about its axis, positive against its
   * rotation; 0 without a gear pair [N mm]. */
  double load_torque(const Model &model);

  /** Sets the tooth pairs in contact and the sums over them; @p n_contacts: Model::contacts. */
  void set_teeth(std::vector<ToothContact> teeth, std::size_t n_contacts, Measurements &measured);

  /** Completes the angles, which are rotations beyond the kinematic turn so far, by what the driver
   * has turned since time zero, @p turn [rad], and sets the transmission errors. */
  void complete_angles(const Transmission &transmission, double turn, Measurements &measured);
} // namespace vfife

#endif
