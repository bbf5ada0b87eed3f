// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_spiral_bevel_proposed_contact_h
#define vfife_gear_spiral_bevel_proposed_contact_h

#include <vfife/gear/spiral_bevel/mean_contact.h>

namespace vfife
{
  /**
   * The equations of the mean contact have more than one solution. Throws InputError when that of a
   * proposed pair is not the one it was designed for: another lag or another contact ellipse. @p
   * contact has the flanks without errors of mounting.
   */
  void check_proposed_contact(const PairProposal &proposal,
                              double              shaft_angle,
                              const Blank        &gear,
                              MeshSide            side,
                              const MeanContact  &mean,
                              const FlankContact &contact);
} // namespace vfife

#endif
