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

  /** The results of a pair of groups (sums over all ranks) of @p contact in Model::contacts, with
   * the torque on the master's body about its axis. */
  ToothContact
  make_tooth_contact(const Model &model, unsigned int contact, const GroupPairResult &result);
} // namespace vfife

#endif
