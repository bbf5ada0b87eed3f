// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "../matrix_stream.h"

#include <vfife/base/text/byte_stream.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/reduced/pair/pair_rows.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  using Eigen::MatrixXd;
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

  PairRows::PairRows(const Model     &model,
                     PairMembers     &members,
                     PressedPair     &pair,
                     const PairDrive &drive)
    : model_(model)
    , members_(members)
    , pair_(pair)
    , drive_(drive)
  {
  }

  std::vector<unsigned int> PairRows::nodes_of(const std::vector<NodeOfBody> &nodes,
                                               const unsigned int             b)
  {
    std::vector<unsigned int> own;
    for (const NodeOfBody &node : nodes)
      if (node.first == b)
        own.push_back(node.second);
    return own;
  }

  Matrix3 PairRows::axes_of(const unsigned int b, const unsigned int node) const
  {
    const ReducedBody &reduced = members_[b]->body;
    const Body        &body    = model_.bodies[b];
    return rotation_about(compute_sector_axis(body).direction,
                          reduced.sector_of(node) * reduced.sector_angle) *
           body.placement.rotation;
  }

  VectorXd PairRows::displace(const std::vector<std::vector<VectorXcd>> &coordinates) const
  {
    VectorXd u(size());
    for (std::size_t b = 0; b < members_.size(); ++b)
      {
        const PairMember &member = *members_[b];
        const VectorXd    own = member.spin * member.rows.spin() + member.rows.under(member.axial) +
                             member.rows.displace(coordinates[b]);
        for (std::size_t i = 0; i < member.places.size(); ++i)
          u[member.places[i]] = own[i];
      }
    return u;
  }

  VectorXd PairRows::displace_nodes(const std::vector<NodeOfBody> &nodes,
                                    const VectorXd                &force) const
  {
    VectorXd     u(3 * nodes.size());
    Eigen::Index i = 0;
    for (unsigned int b = 0; b < members_.size(); ++b)
      {
        const PairMember               &member = *members_[b];
        const std::vector<unsigned int> own    = nodes_of(nodes, b);
        const VectorXd                  along  = member.rows.displace_nodes(
          own, member.spin, member.axial, member.coordinates(), member.part_of(force));
        for (std::size_t k = 0; k < own.size(); ++k, i += 3)
          u.segment<3>(i) = axes_of(b, own[k]) * along.segment<3>(3 * k);
      }
    return u;
  }

  void PairRows::search(PressedState &now, VectorXd &earlier)
  {
    const Transmission &t      = *model_.only_transmission();
    const double        meshes = std::abs(members_[t.driver]->rate) * t.driver_teeth / (2. * pi);
    search_steps_              = std::max(1., std::floor(search_part / (meshes * drive_.step)));
    since_search_              = 0;

    // Of the teeth that come near each other the nodes that may be pressed. What the load does to
    // the flanks turns the driven hub by `turn`: in so short a time they come nearer by less.
    const double later = drive_.turn_after(search_steps_);
    searched_from_     = drive_.turn;
    searched_to_       = later;
    held_.resize(0);
    pair_.find_candidates(later);
    std::vector<NodeOfBody> nodes = pair_.candidates();
    if (now.force.size() > 0 && widening < largest_widening)
      {
        const double reach = std::max(least_reach, std::abs(now.turn) * t.arm);
        held_              = displace_nodes(nodes, now.force);
        check_reach(nodes, held_);
        pair_.hold(held_);
        nodes = pair_.find_near(now.turn, later, std::ldexp(reach, widening));
        for (std::size_t i = 0; i < nodes_.size(); ++i)
          if (now.force.segment<3>(3 * i).squaredNorm() > 0.)
            nodes.push_back(nodes_[i]);
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      }
    set_nodes(std::move(nodes), now, earlier);
  }

  void PairRows::search_when_due(PressedState &now, VectorXd &earlier)
  {
    if (++since_search_ < search_steps_)
      return;
    widening -= widening > 0 ? 1 : 0;
    search(now, earlier);
  }

  void PairRows::add_rows(const unsigned int b, const Eigen::Index n)
  {
    std::vector<Eigen::Index> &places = members_[b]->places;
    for (Eigen::Index i = 0; i < n; ++i)
      {
        owners_.emplace_back(b, places.size());
        places.push_back(owners_.size() - 1);
      }
  }

  void PairRows::set_nodes(std::vector<NodeOfBody> nodes, PressedState &now, VectorXd &earlier)
  {
    if (nodes == nodes_)
      return;
    std::vector<PressedPair::Node> axes;
    owners_.clear();
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
    for (VectorXd *const force : {&now.force, &earlier})
      {
        if (force->size() == 0)
          continue;
        VectorXd           kept  = VectorXd::Zero(size());
        const Eigen::Index seats = 6 * model_.bearings.size();
        kept.tail(seats)         = force->tail(seats);
        for (std::size_t i = 0, k = 0; i < nodes.size(); ++i)
          {
            while (k < nodes_.size() && nodes_[k] < nodes[i])
              ++k;
            if (k < nodes_.size() && nodes_[k] == nodes[i])
              kept.segment<3>(3 * i) = force->segment<3>(3 * k);
          }
        *force = std::move(kept);
      }
    nodes_ = std::move(nodes);
  }

  void PairRows::check_reach(const std::vector<NodeOfBody> &nodes, const VectorXd &u) const
  {
    if (model_.bearings.empty())
      return;
    std::vector<Vector3>      sums(members_.size(), Vector3::Zero());
    std::vector<unsigned int> n(members_.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        sums[nodes[i].first] += pair_.rotations()[nodes[i].first] * u.segment<3>(3 * i);
        ++n[nodes[i].first];
      }
    Vector3 apart = Vector3::Zero();
    for (unsigned int b = 0; b < sums.size(); ++b)
      if (n[b] > 0)
        apart += (b == 0 ? 1. : -1.) / n[b] * sums[b];
    const std::string excess = describe_excess(apart.norm(), pair_.depth_limit());
    if (!excess.empty())
      pair_.fail(excess, "");
  }

  void PairRows::serialize(PressedState &now, VectorXd &earlier, ByteStream &stream)
  {
    std::vector<NodeOfBody> nodes = nodes_;
    stream.pass(search_steps_, since_search_, widening, searched_from_, searched_to_, nodes);
    pass_matrix(held_, stream);
    if (!stream.reads())
      return;
    now = PressedState();
    earlier.resize(0);
    pair_.set_position(searched_from_);
    pair_.find_candidates(searched_to_);
    if (held_.size() > 0)
      pair_.hold(held_);
    set_nodes(std::move(nodes), now, earlier);
    pair_.set_position(drive_.turn);
  }

  VectorXd PairAnswers::answer(const VectorXd &force)
  {
    VectorXd u = VectorXd::Zero(force.size());
    for (std::size_t b = 0; b < touch_rows_.size(); ++b)
      {
        // Few nodes are under pressure: only their columns.
        const std::vector<Eigen::Index> &places = members_[b]->places;
        VectorXd                         own    = VectorXd::Zero(places.size());
        for (std::size_t k = 0; k < places.size(); ++k)
          if (force[places[k]] != 0.)
            own += force[places[k]] * touch_rows_[b]->flexibility().col(k);
        for (std::size_t k = 0; k < places.size(); ++k)
          u[places[k]] = own[k];
      }
    return u;
  }

  MatrixXd PairAnswers::flexibility(const std::vector<unsigned int> &rows)
  {
    // Bodies do not move each other.
    MatrixXd flexibility = MatrixXd::Zero(rows.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      {
        const auto [of_column, column] = rows_.owner(rows[k]);
        for (std::size_t i = 0; i < rows.size(); ++i)
          if (const auto [of_row, row] = rows_.owner(rows[i]); of_row == of_column)
            flexibility(i, k) = touch_rows_[of_row]->flexibility()(row, column);
      }
    return flexibility;
  }

  void PairAnswers::add_forces(const VectorXd &u, PressedForces &sum) const
  {
    if (const Eigen::Index n = bearings_.n_rows(); n > 0)
      bearings_.evaluate(u).add_to(sum, u.size() - n);
  }

  PressedSprings
  PairAnswers::find_springs(const VectorXd &u, const bool turning, const bool own) const
  {
    PressedSprings     springs;
    const Eigen::Index n = bearings_.n_rows();
    springs.stiffness    = MatrixXd::Zero(n, n);
    springs.by_turn      = VectorXd::Zero(n);
    if (n > 0 && own)
      bearings_.evaluate(u).add_to(springs, turning);
    return springs;
  }
} // namespace vfife
