// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/byte_stream.h>
#include <vfife/contact/pass/point_lists.h>
#include <vfife/contact/pass/wide_search.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    /** A gap changes by the motion times at most this: the normal field is not exactly that of the
     * facets. */
    constexpr double gap_per_motion = 1.25;

    /** Share of a gap that the groups may move before its point is looked at again (1/1.25). */
    constexpr double sleep_per_gap = 0.8;

    /** What a point that touches costs besides, its pressure and forces, in the cost of finding
     * where it lies (measured, doc/verification/contact.md). */
    constexpr double work_of_touching = 2.;
  } // namespace

  PointLists::PointLists(PassSurfaces &surfaces, const ContactOptions &options)
    : surfaces_(surfaces)
    , skin_(options.search_skin > 0. ? options.search_skin
                                     : 0.2 * surfaces.master.mean_facet_size())
    , depth_limit_(options.depth_limit > 0.
                     ? options.depth_limit
                     : 0.5 * std::min(surfaces.slave.surface().mean_facet_size(),
                                      surfaces.master.mean_facet_size()))
    , slave_path_(surfaces.slave.surface().n_groups())
    , master_path_(surfaces.master.n_groups())
  {
  }

  void PointLists::set_pairs(const std::vector<std::pair<unsigned int, unsigned int>> &pairs)
  {
    // Lists and projections of pairs that stay are taken over, new pairs begin without a list.
    std::vector<PointList> kept;
    for (const auto &groups : pairs)
      {
        const auto old =
          std::find_if(lists_.begin(), lists_.end(), [&groups](const PointList &list) {
            return list.slave_group == groups.first && list.master_group == groups.second;
          });
        if (old != lists_.end())
          kept.push_back(std::move(*old));
        else
          {
            kept.emplace_back();
            kept.back().slave_group  = groups.first;
            kept.back().master_group = groups.second;
          }
      }
    lists_ = std::move(kept);
    follow_groups();
  }

  void PointLists::set_shares(const std::vector<PointShare> &shares)
  {
    // Points that come from other ranks are listed anew; what is gone is forgotten.
    for (std::size_t i = 0; i < lists_.size(); ++i)
      if (!(lists_[i].share == shares[i]))
        {
          PointList changed;
          changed.slave_group  = lists_[i].slave_group;
          changed.master_group = lists_[i].master_group;
          changed.share        = shares[i];
          lists_[i]            = std::move(changed);
        }
    follow_groups();
  }

  void PointLists::take_work(std::vector<double> &of_pairs)
  {
    for (std::size_t i = 0; i < lists_.size(); ++i)
      {
        of_pairs[i] += lists_[i].work;
        lists_[i].work = 0.;
      }
  }

  void PointLists::follow_groups()
  {
    std::vector<unsigned int> slave_groups, master_groups;
    for (const PointList &list : lists_)
      if (!list.share.empty())
        {
          slave_groups.push_back(list.slave_group);
          master_groups.push_back(list.master_group);
        }
    for (auto *groups : {&slave_groups, &master_groups})
      {
        std::sort(groups->begin(), groups->end());
        groups->erase(std::unique(groups->begin(), groups->end()), groups->end());
      }
    slave_path_.set_active(slave_groups);
    master_path_.set_active(master_groups);
  }

  void PointLists::update_paths()
  {
    const RigidMotion &frame = surfaces_.master.motion().body;
    slave_path_.update(surfaces_.slave.surface(), frame);
    master_path_.update(surfaces_.master, frame);
  }

  double PointLists::path_of(const PointList &list) const
  {
    return slave_path_.length(list.slave_group) + master_path_.length(list.master_group);
  }

  void PointLists::wake()
  {
    for (PointList &list : lists_)
      list.awake_at.assign(list.points.size(), -std::numeric_limits<double>::infinity());
  }

  void PointLists::find_points(PointList &list, const double open_reach, const double depth_reach)
  {
    ++n_wide_searches_;
    WideSearch(surfaces_, list.master_group).find_points(list, open_reach, depth_reach);
  }

  PointList
  PointLists::points_within(const PointList &list, const double reach, const PointShare &share)
  {
    // A list of its own: the kept ones stay as they are.
    PointList within;
    within.slave_group  = list.slave_group;
    within.master_group = list.master_group;
    within.share        = share;
    find_points(within, reach, reach);
    return within;
  }

  void PointLists::renew(const StickSlip &friction)
  {
    for (PointList &list : lists_)
      {
        if (list.share.empty())
          continue;
        // The list is good until the gap of a point that is not in it could have closed.
        const double path = path_of(list);
        if (list.listed && path - list.built_at <= skin_)
          continue;
        std::vector<AnchorOfPoint> anchors;
        StickSlip::append_anchors(0, list, anchors);
        find_points(list, gap_per_motion * skin_, depth_limit_ + gap_per_motion * skin_);
        friction.renew_anchors(anchors, list);
        list.listed   = true;
        list.built_at = path;
      }
  }

  bool PointLists::locate(PointList &list, const unsigned int i, const double path)
  {
    SurfaceGeometry &master = surfaces_.master;
    ListedPoint     &point  = list.points[i];
    Projection      &p      = point.projection;
    const Vector3    x      = surfaces_.slave.position(point.slave_facet, point.rule_point);
    if (!project_walking(master, x, p))
      {
        // Lost: look through the whole group. Finding nothing means out of reach until the next
        // wide search.
        const double  reach  = 1.5 * (depth_limit_ + 3. * skin_);
        const Vector3 normal = surfaces_.slave.surface().vector_area(point.slave_facet);
        if (!WideSearch(surfaces_, list.master_group).find_foot(x, normal, reach, p))
          {
            // Start the next attempt from a defined state, not at once.
            p.xi = p.eta     = 0.5;
            p.lambda         = 0.;
            p.inside         = false;
            list.awake_at[i] = path + 0.25 * skin_;
            return false;
          }
      }
    if (p.inside)
      return true;

    // Beyond the border: nothing can happen before the point has come half the way back to it.
    const FacetState &state   = master.state(p.facet);
    const double      xi      = std::min(1., std::max(0., p.xi));
    const double      eta     = std::min(1., std::max(0., p.eta));
    const double      lateral = (state.position(p.xi, p.eta) - state.position(xi, eta)).norm();
    // The last part is for the tolerance beyond the border, within which a point is inside.
    list.awake_at[i] = path + std::max(0., 0.5 * lateral - 0.002 * master.mean_facet_size());
    return false;
  }

  void PointLists::find_touching(const double look_ahead, StickSlip &friction)
  {
    for (PointList &list : lists_)
      find_touching(list, look_ahead, friction);
  }

  void PointLists::find_touching(PointList &list, const double look_ahead, StickSlip &friction)
  {
    const double path = path_of(list);
    list.touching.clear();
    unsigned int n_awake = 0;
    for (unsigned int i = 0; i < list.points.size(); ++i)
      {
        // Asleep: the gap was too wide to have closed since.
        if (path < list.awake_at[i])
          continue;
        ++n_awake;
        ListedPoint &point = list.points[i];
        if (!locate(list, i, path))
          {
            point.pressure = 0.;
            friction.open(list, i, false);
            continue;
          }
        point.gap = surfaces_.gap(point.projection, point.slave_offset);
        // Open: sleep. Closed: touching (the pressure of the step before is a first guess), unless
        // it is deep enough to belong to the other side of a thin body.
        const double reach = find_reach(point, look_ahead);
        if (point.gap >= reach)
          // Accelerated while it sleeps, it may reach farther when it wakes.
          list.awake_at[i] = path + std::max(0., sleep_per_gap * point.gap - 2. * reach);
        else if (point.gap > -depth_limit_)
          {
            list.touching.push_back(i);
            continue;
          }
        point.pressure = 0.;
        friction.open(list, i, true);
      }
    list.work += n_awake + work_of_touching * list.touching.size();
  }

  double PointLists::find_reach(const ListedPoint &point, const double look_ahead) const
  {
    // A point that is closed at either end of the step touches: half as far again as the faster of
    // its velocities over the master there goes in that time. Points too many carry nothing.
    constexpr double margin = 1.5;
    if (!(look_ahead > 0.))
      return 0.;
    const SurfaceGeometry &of_slave  = surfaces_.slave.surface();
    const SurfaceGeometry &of_master = surfaces_.master;
    const auto             weights   = bilinear_weights(point.projection.xi, point.projection.eta);
    const auto            &shape     = surfaces_.slave.rule()[point.rule_point].shape;
    const auto            &slave     = of_slave.corners(point.slave_facet);
    const auto            &master    = of_master.corners(point.projection.facet);
    Vector3                before = Vector3::Zero(), after = Vector3::Zero();
    for (unsigned int k = 0; k < 4; ++k)
      {
        before +=
          shape[k] * of_slave.velocity(slave[k]) - weights[k] * of_master.velocity(master[k]);
        after += shape[k] * of_slave.later_velocity(slave[k]) -
                 weights[k] * of_master.later_velocity(master[k]);
      }
    return margin * look_ahead * std::sqrt(std::max(before.squaredNorm(), after.squaredNorm()));
  }

  std::size_t PointLists::n_points() const
  {
    std::size_t n = 0;
    for (const PointList &list : lists_)
      n += list.points.size();
    return n;
  }

  void PointLists::serialize(ByteStream &stream)
  {
    std::size_t n = lists_.size();
    stream.pass(n, n_wide_searches_);
    stream.require(n <= static_cast<std::size_t>(surfaces_.slave.surface().n_groups()) *
                          surfaces_.master.n_groups(),
                   "more pairs of groups than the surfaces have");
    lists_.resize(n);
    for (PointList &list : lists_)
      stream.pass(list.slave_group,
                  list.master_group,
                  list.share,
                  list.work,
                  list.listed,
                  list.built_at,
                  list.points,
                  list.awake_at);
    slave_path_.serialize(stream);
    master_path_.serialize(stream);
    if (stream.reads())
      check(stream);
  }

  void PointLists::check(const ByteStream &stream) const
  {
    const SurfaceGeometry &slave = surfaces_.slave.surface(), &master = surfaces_.master;
    for (const PointList &list : lists_)
      {
        stream.require(list.slave_group < slave.n_groups() &&
                         list.master_group < master.n_groups() &&
                         list.awake_at.size() == list.points.size(),
                       "a list of points of groups that are not there");
        for (const ListedPoint &point : list.points)
          stream.require(point.slave_facet < slave.n_facets() &&
                           point.rule_point < surfaces_.slave.rule().size() &&
                           point.projection.facet < master.n_facets() &&
                           std::isfinite(point.projection.xi + point.projection.eta +
                                         point.projection.lambda),
                         "a point on facets that are not there");
      }
  }
} // namespace vfife
