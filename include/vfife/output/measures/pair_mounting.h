// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_pair_mounting_h
#define vfife_output_measures_pair_mounting_h

#include <vfife/model/model.h>
#include <vfife/output/measures/body_ring.h>
#include <vfife/output/measures/mounting.h>

#include <array>
#include <optional>

namespace vfife
{
  class Communicator;
  struct State;

  /**
   * Mounting of the members of a model's gear pair; the first of the two bodies is the pinion. The
   * mean motion of its bore (Transmission) moves apex and axis of a member. A member whose bore
   * turns as prescribed keeps its place.
   */
  class PairMounting
  {
  public:
    /** The model must have a transmission. */
    explicit PairMounting(const Model &model);

    /** Whether a member hangs in bearings, so that the mounting changes at all. */
    static bool changes(const Model &model);

    /** What the state has more than the undeformed pair. Collective. */
    Mounting measure(const State &state, const Communicator &communicator) const;

    /** The same where the rings of the bores move so. */
    Mounting measure(const RingMotions &motion_of) const;

  private:
    struct Member
    {
      unsigned int            body = 0;
      MountedMember           undeformed;
      std::optional<BodyRing> bore; ///< none: it turns as prescribed
    };
    std::array<Member, 2> members_;
    Mounting              undeformed_;
  };
} // namespace vfife

#endif
