// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_tooth_contact_h
#define vfife_model_tooth_contact_h

#include <vfife/contact/contact_results.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

namespace vfife
{
  /** A force on a node of a body, fixed frame [N]. */
  struct NodalForce
  {
    unsigned int body = 0, node = 0;
    Vector3      force = Vector3::Zero();
  };

  /** What a pair of groups of the contact @p pair does (sums over all ranks), with the torque on
   * the master's body about its axis. */
  ToothContact
  make_tooth_contact(const Model &model, const ContactPair &pair, const GroupPairResult &result);
} // namespace vfife

#endif
