// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What of a ContactPass goes on from one evaluation to the next, to checkpoints or not at all.
#include <vfife/base/text/byte_stream.h>
#include <vfife/contact/contact_pass.h>

#include <cmath>

namespace vfife
{
  void ContactPass::serialize(ByteStream &stream)
  {
    std::size_t n = pairs_.size();
    stream.pass(n, n_wide_searches_);
    stream.require(n <= static_cast<std::size_t>(slave_.n_groups()) * master_.n_groups(),
                   "more pairs of groups than the surfaces have");
    pairs_.resize(n);
    for (Pair &pair : pairs_)
      stream.pass(pair.slave_group,
                  pair.master_group,
                  pair.share,
                  pair.work,
                  pair.listed,
                  pair.built_at,
                  pair.points,
                  pair.awake_at);
    slave_path_.serialize(stream);
    master_path_.serialize(stream);
    if (stream.reads())
      check_lists(stream);
  }


  void ContactPass::check_lists(const ByteStream &stream) const
  {
    for (const Pair &pair : pairs_)
      {
        stream.require(pair.slave_group < slave_.n_groups() &&
                         pair.master_group < master_.n_groups() &&
                         pair.awake_at.size() == pair.points.size(),
                       "a list of points of groups that are not there");
        for (const ListedPoint &point : pair.points)
          stream.require(point.slave_facet < slave_.n_facets() && point.rule_point < rule_.size() &&
                           point.projection.facet < master_.n_facets() &&
                           std::isfinite(point.projection.xi + point.projection.eta +
                                         point.projection.lambda),
                         "a point on facets that are not there");
      }
  }
} // namespace vfife
