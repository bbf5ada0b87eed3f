// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/model/state.h>
#include <vfife/output/measures/pair_mounting.h>

namespace vfife
{
  PairMounting::PairMounting(const Model &model)
    : model_(model)
  {
    const Transmission &t = *model.transmission;
    for (unsigned int b = 0; b < 2; ++b)
      {
        const Body &body   = model.bodies[b];
        Member     &member = members_[b];
        // The body frame has its origin in the apex and z along the axis, to the back.
        member.undeformed = {body.placement.translation, body.placement.rotation.col(2)};
        member.bore       = b == t.driver ? t.driver_bore : t.driven_bore;
        if (member.bore.empty())
          continue;
        std::vector<double> shares;
        double              sum = 0;
        for (const unsigned int node : member.bore)
          {
            member.places.push_back(body.placement(body.node_positions()[node]));
            shares.push_back(body.node_masses()[node]);
            member.centre += shares.back() * member.places.back();
            sum += shares.back();
          }
        member.centre /= sum;
        member.set.emplace(shares, member.places, "bore of the " + body.name());
      }
    undeformed_ = find_mounting(members_[0].undeformed, members_[1].undeformed);
  }

  bool PairMounting::changes(const Model &model)
  {
    return model.transmission && (model.bodies[0].floats || model.bodies[1].floats);
  }

  const std::vector<unsigned int> &PairMounting::bore(const unsigned int body) const
  {
    return members_[body].bore;
  }

  MountedMember PairMounting::move(const Member &member, const MeanMotion::Motion &motion)
  {
    // The apex lies on the axis: the turn of the body leaves it where it is.
    return {member.centre + motion.displacement +
              motion.rotation * (member.undeformed.apex - member.centre),
            motion.rotation * member.undeformed.direction};
  }

  Mounting PairMounting::measure(const State &state, const Communicator &communicator) const
  {
    std::array<MountedMember, 2> now;
    for (unsigned int b = 0; b < 2; ++b)
      {
        const Member &member = members_[b];
        now[b]               = member.undeformed;
        if (!member.set)
          continue;
        std::vector<double> sums = MeanMotion::make_sums();
        for (std::size_t i = 0; i < member.bore.size(); ++i)
          {
            const std::uint32_t local =
              state.partition->find_owned(model_.bodies[b].first_node + member.bore[i]);
            if (local != Partition::absent)
              member.set->add(i, state.node_position(local), Vector3::Zero(), sums);
          }
        communicator.sum(sums);
        now[b] = move(member, member.set->solve(sums));
      }
    return find_mounting(now[0], now[1]) - undeformed_;
  }

  Mounting PairMounting::measure(const std::array<std::vector<Vector3>, 2> &displacements,
                                 const std::array<Matrix3, 2>              &rotations) const
  {
    std::array<MountedMember, 2> now;
    for (unsigned int b = 0; b < 2; ++b)
      {
        const Member &member = members_[b];
        now[b]               = member.undeformed;
        if (!member.set)
          continue;
        const Vector3      &point = model_.bodies[b].axis.point;
        std::vector<double> sums  = MeanMotion::make_sums();
        for (std::size_t i = 0; i < member.bore.size(); ++i)
          member.set->add(i,
                          point + rotations[b] * (member.places[i] + displacements[b][i] - point),
                          Vector3::Zero(),
                          sums);
        now[b] = move(member, member.set->solve(sums));
      }
    return find_mounting(now[0], now[1]) - undeformed_;
  }
} // namespace vfife
