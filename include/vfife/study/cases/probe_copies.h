// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_probe_copies_h
#define vfife_study_cases_probe_copies_h

#include <vfife/model/model.h>

#include <vector>

namespace vfife
{
  /**
   * The nodes of a gear body at which @p probe lies in its own sector and in all others, one a
   * tooth: after m mesh cycles the probe is where copy m is now (copy 0 is the probe itself).
   * Where the deformation stands still in space the copies' stresses of one instant are the probe's
   * whole passage.
   *
   * They are the node set with the probe's name, which has one node a sector in the order of the
   * sectors. Throws InputError where the model is no gear pair or has no such set.
   */
  std::vector<Probe> list_copies(const Model &model, const Probe &probe);

  /**
   * Mesh cycles from time zero until the undeformed node of @p probe passes the meridian plane of
   * the mean contact, in [0, teeth of the body). Throws InputError where the model is no gear pair.
   */
  double meshes_to_contact(const Model &model, const Probe &probe);
} // namespace vfife

#endif
