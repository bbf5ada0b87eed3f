// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What may touch in the next steps of a ReducedPair.
#include "reduced_pair_parts.h"

#include <vfife/model/body_frame.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  namespace
  {
    /** Part of a mesh cycle between searches for what may touch. */
    constexpr double search_part = .1;
    /** Least distance within which flanks may touch until the next search [mm]. */
    constexpr double least_reach = 2e-3;
    /** Widenings after which all nodes of the teeth are looked at. */
    constexpr unsigned int largest_widening = 4;
  } // namespace

  std::vector<unsigned int> ReducedPair::nodes_of(const std::vector<NodeOfBody> &nodes,
                                                  const unsigned int             b)
  {
    std::vector<unsigned int> own;
    for (const NodeOfBody &node : nodes)
      if (node.first == b)
        own.push_back(node.second);
    return own;
  }

  Matrix3 ReducedPair::axes_of(const unsigned int b, const unsigned int node) const
  {
    const ReducedBody &reduced = members_[b]->body;
    const Body        &body    = model_.bodies[b];
    return rotation_about(compute_sector_axis(body).direction,
                          reduced.sector_of(node) * reduced.sector_angle) *
           body.placement.rotation;
  }

  VectorXd ReducedPair::displace_nodes(const std::vector<NodeOfBody> &nodes) const
  {
    VectorXd     u(3 * nodes.size());
    Eigen::Index i = 0;
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        const Member                   &member = *members_[b];
        const std::vector<unsigned int> own    = nodes_of(nodes, b);
        const VectorXd                  along  = member.rows.displace_nodes(
          own, member.spin, member.axial, member.coordinates(), rows_of(member, now_.force));
        for (std::size_t k = 0; k < own.size(); ++k, i += 3)
          u.segment<3>(i) = axes_of(b, own[k]) * along.segment<3>(3 * k);
      }
    return u;
  }

  std::vector<double> ReducedPair::places_of(const unsigned int               b,
                                             const std::vector<unsigned int> &nodes) const
  {
    std::vector<NodeOfBody> of_body;
    for (const unsigned int node : nodes)
      of_body.emplace_back(b, node);
    const VectorXd      u    = displace_nodes(of_body);
    const Body         &body = model_.bodies[b];
    std::vector<double> places(3 * nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      Eigen::Map<Vector3>(places.data() + 3 * i) =
        pair_.place(b, body.placement(body.node_positions()[nodes[i]]) + u.segment<3>(3 * i));
    return places;
  }

  void ReducedPair::search()
  {
    const double meshes = std::abs(members_[model_.only_transmission()->driver]->rate) *
                          model_.only_transmission()->driver_teeth / (2. * pi);
    search_steps_ = std::max(1., std::floor(search_part / (meshes * options_.step)));
    since_search_ = 0;

    // Of the teeth that come near each other the nodes that may be pressed. What the load does to
    // the flanks turns the driven hub by `turn`: in so short a time they come nearer by less.
    const double later = driver_turn(search_steps_);
    searched_from_     = driver_turn_;
    searched_to_       = later;
    held_.resize(0);
    pair_.find_candidates(later);
    std::vector<NodeOfBody> nodes = pair_.candidates();
    if (now_.force.size() > 0 && widening_ < largest_widening)
      {
        const double reach =
          std::max(least_reach, std::abs(now_.turn) * model_.only_transmission()->arm);
        held_ = displace_nodes(nodes);
        check_reach(nodes, held_);
        pair_.hold(held_);
        nodes = pair_.find_near(now_.turn, later, std::ldexp(reach, widening_));
        for (std::size_t i = 0; i < nodes_.size(); ++i)
          if (now_.force.segment<3>(3 * i).squaredNorm() > 0.)
            nodes.push_back(nodes_[i]);
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      }
    set_rows(std::move(nodes));
  }

  void ReducedPair::set_rows(std::vector<NodeOfBody> nodes)
  {
    if (nodes == nodes_)
      return;
    std::vector<PressedPair::Node> axes;
    owners_.clear();
    const auto add_rows = [&](const unsigned int b, const Eigen::Index n) {
      std::vector<Eigen::Index> &places = members_[b]->places;
      for (Eigen::Index i = 0; i < n; ++i)
        {
          owners_.emplace_back(b, places.size());
          places.push_back(owners_.size() - 1);
        }
    };
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        std::vector<unsigned int> own = nodes_of(nodes, b);
        members_[b]->rows.set_nodes(own);
        members_[b]->places.clear();
        add_rows(b, 3 * own.size());
        // Rows are along the axes of the body frame, turned with the sector.
        for (const unsigned int node : own)
          axes.push_back({b, node, axes_of(b, node)});
      }
    for (const Bearing &bearing : model_.bearings)
      add_rows(bearing.body, 6);
    pair_.set_nodes(axes);

    // Forces go with their nodes.
    const auto keep = [&](VectorXd &force) {
      if (force.size() == 0)
        return;
      VectorXd           kept  = VectorXd::Zero(n_rows());
      const Eigen::Index seats = 6 * springs_.size();
      kept.tail(seats)         = force.tail(seats);
      for (std::size_t i = 0, k = 0; i < nodes.size(); ++i)
        {
          while (k < nodes_.size() && nodes_[k] < nodes[i])
            ++k;
          if (k < nodes_.size() && nodes_[k] == nodes[i])
            kept.segment<3>(3 * i) = force.segment<3>(3 * k);
        }
      force = std::move(kept);
    };
    keep(now_.force);
    keep(earlier_force_);
    nodes_ = std::move(nodes);
  }
} // namespace vfife
