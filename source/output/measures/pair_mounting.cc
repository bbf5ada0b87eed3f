// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/model/pair_measures.h>
#include <vfife/model/state.h>
#include <vfife/output/measures/pair_mounting.h>

#include <algorithm>
#include <tuple>

namespace vfife
{
  PairMounting::PairMounting(const Model &model)
  {
    const Transmission &t                        = *model.only_transmission();
    std::tie(members_[0].body, members_[1].body) = std::minmax(t.driver, t.driven);
    for (Member &member : members_)
      {
        const Body &body = model.bodies[member.body];
        // The body frame has its origin in the apex and z along the axis, to the back.
        member.undeformed = {body.placement.translation, body.placement.rotation.col(2)};
        const auto &bore  = find_member(t, member.body).bore;
        if (!bore.empty())
          member.bore.emplace(body, bore, "bore of the " + body.name());
      }
    undeformed_ = find_mounting(members_[0].undeformed, members_[1].undeformed);
  }

  bool PairMounting::changes(const Model &model)
  {
    const Transmission *const t = model.only_transmission();
    return t && (model.bodies[t->driver].floats || model.bodies[t->driven].floats);
  }

  Mounting PairMounting::measure(const RingMotions &motion_of) const
  {
    std::array<MountedMember, 2> now;
    for (unsigned int b = 0; b < 2; ++b)
      {
        now[b] = members_[b].undeformed;
        if (!members_[b].bore)
          continue;
        const BodyRing          &bore   = *members_[b].bore;
        const MeanMotion::Motion motion = motion_of(members_[b].body, bore);
        // The apex lies on the axis: the turn of the body leaves it where it is.
        now[b].apex = bore.centre() + motion.displacement +
                      motion.rotation * (members_[b].undeformed.apex - bore.centre());
        now[b].direction = motion.rotation * members_[b].undeformed.direction;
      }
    return find_mounting(now[0], now[1]) - undeformed_;
  }

  Mounting PairMounting::measure(const State &state, const Communicator &communicator) const
  {
    return measure(
      [&](const unsigned int, const BodyRing &bore) { return bore.measure(state, communicator); });
  }
} // namespace vfife
