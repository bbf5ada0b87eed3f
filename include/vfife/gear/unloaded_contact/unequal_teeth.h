// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_unloaded_contact_unequal_teeth_h
#define vfife_gear_unloaded_contact_unequal_teeth_h

#include <vfife/gear/unloaded_contact/contact_analysis.h>

#include <map>

namespace vfife
{
  /**
   * Unloaded contact of a side of a pair whose teeth have errors of their own (pitch, runout,
   * topography of single teeth): every tooth pair is analysed with the errors of its two teeth, on
   * flanks and edges; the one with the least lag touches.
   */
  class UnequalTeeth
  {
  public:
    /** Where the pair stands when the pinion has turned on from the mean contact. */
    struct Position
    {
      double lag = 0.; ///< of the gear, as in UnloadedContactPoint; infinite: nothing touches [rad]
      int    pair = 0; ///< that touches, see UnloadedContact
    };

    UnequalTeeth(const GearPair &pair, MeshSide side);

    /** At a rotation of the pinion in pitches. Tooth pairs near the last one are kept: positions in
     * a row are fast. */
    Position at(double pitches);

    /** Mesh cycles after which the same teeth meet again: least common multiple of the numbers of
     * teeth. */
    static unsigned int hunting_cycle(const GearPair &pair);

  private:
    const PairContact &contact(int k);

    GearPair                   pair_;
    MeshSide                   side_;
    std::map<int, PairContact> contacts_;
  };

  /**
   * Transmission error of the driven member, at its own axis, over @p meshes mesh cycles from the
   * mean contact on, in the direction of rotation, with the teeth that touch:
   * transmission_meshes.csv.
   */
  Table transmission_of_meshes(const GearPair               &pair,
                               const ContactAnalysisOptions &options,
                               unsigned int                  meshes);
} // namespace vfife

#endif
