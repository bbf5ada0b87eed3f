// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/model/load_shares.h>
#include <vfife/model/state.h>
#include <vfife/output/measures/body_ring.h>

#include <utility>

namespace vfife
{
  BodyRing::BodyRing(const Body                &body,
                     std::vector<unsigned int>  nodes,
                     const std::vector<double> &shares,
                     const std::string         &owner)
    : first_node_(body.first_node)
    , nodes_(std::move(nodes))
    , places_(find_undeformed_places(body, nodes_))
    , set_(shares, places_, owner)
  {
  }

  BodyRing::BodyRing(const Body &body, std::vector<unsigned int> nodes, const std::string &owner)
    : BodyRing(body, nodes, masses_of(body, nodes), owner)
  {
  }

  MeanMotion::Motion BodyRing::measure(const State &state, const Communicator &communicator) const
  {
    std::vector<double> sums = MeanMotion::make_sums();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      {
        const std::uint32_t local = state.partition->find_owned(first_node_ + nodes_[i]);
        if (local != Partition::absent)
          set_.add(i, state.node_position(local), Vector3::Zero(), sums);
      }
    communicator.sum(sums);
    return set_.solve(sums);
  }

  MeanMotion::Motion BodyRing::measure(const std::function<Vector3(std::size_t)> &place_of) const
  {
    std::vector<double> sums = MeanMotion::make_sums();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      set_.add(i, place_of(i), Vector3::Zero(), sums);
    return set_.solve(sums);
  }
} // namespace vfife
