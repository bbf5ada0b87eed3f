// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_constraints_supports_h
#define vfife_model_constraints_supports_h

#include <vfife/bearing/bearing_system.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <string>
#include <vector>

namespace vfife
{
  class Communicator;

  /** What holds nodes of a body and reacts to what acts on them. */
  struct Support
  {
    std::string  name;
    unsigned int body = 0;
  };

  /** The constraints of a model, its springs to the ground, its bearings and its couplings:
   * Measurements::reactions has their order. */
  std::vector<Support> list_supports(const Model &model);

  /** All bearings of a model, in its order, in its housing. */
  BearingSystem make_bearing_system(const Model &model);

  /** Place of the first bearing in list_supports(); couplings follow the bearings. */
  std::size_t first_bearing(const Model &model);

  /** Replaces reactions of this rank's nodes by those of all ranks. Collective. */
  void sum_over_ranks(std::vector<Reaction> &reactions, const Communicator &communicator);
} // namespace vfife

#endif
