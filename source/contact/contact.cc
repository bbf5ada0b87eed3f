// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/contact/contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    std::vector<ContactPass> make_passes(const FacetSurface   &slave,
                                         const FacetSurface   &master,
                                         const ContactOptions &options)
    {
      options.check("");
      std::vector<ContactPass> passes;
      // Two passes are the mean of both directions: each gets half of every area.
      if (options.discretization == ContactDiscretization::two_pass)
        {
          passes.emplace_back(slave, master, options, 0.5);
          passes.emplace_back(master, slave, options, 0.5);
        }
      else
        passes.emplace_back(slave, master, options, 1.);
      return passes;
    }

    /** From the slave's undeformed frame into the master's. */
    RigidMotion slave_to_master(const RigidMotion &slave, const RigidMotion &master)
    {
      RigidMotion motion;
      motion.rotation    = master.rotation.transpose() * slave.rotation;
      motion.translation = master.rotation.transpose() * (slave.translation - master.translation);
      return motion;
    }

    using GroupPair = std::pair<unsigned int, unsigned int>;

    GroupPair swapped(const GroupPair &pair)
    {
      return {pair.second, pair.first};
    }

    void add_swapped(const GroupPairResult &from, GroupPairResult &to)
    {
      to.force -= from.force;
      to.moment -= from.moment;
      to.largest_pressure    = std::max(to.largest_pressure, from.largest_pressure);
      to.largest_penetration = std::max(to.largest_penetration, from.largest_penetration);
      to.area += from.area;
      to.normal_force += from.normal_force;
      to.energy += from.energy;
      to.damping_power += from.damping_power;
      to.friction_loss += from.friction_loss;
    }

    void keep_each_once(std::vector<unsigned int> &nodes)
    {
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
  } // namespace

  Contact::Contact(const FacetSurface   &slave,
                   const FacetSurface   &master,
                   const ContactOptions &options)
    : interaction_(options)
    , passes_(make_passes(slave, master, options))
    , broad_search_(passes_.front().slave(), passes_.front().master())
  {
  }

  void
  Contact::find_candidates(const RigidMotion &slave, const RigidMotion &master, const double margin)
  {
    find_candidates(slave, master, slave, master, margin);
  }

  void Contact::find_candidates(const RigidMotion &slave,
                                const RigidMotion &master,
                                const RigidMotion &slave_later,
                                const RigidMotion &master_later,
                                const double       margin)
  {
    auto pairs = broad_search_.find_pairs(slave_to_master(slave, master),
                                          slave_to_master(slave_later, master_later),
                                          margin);
    if (pairs == candidate_pairs_)
      return;
    // The passes keep what they know of pairs that stay.
    candidate_pairs_ = std::move(pairs);
    passes_[0].set_pairs(candidate_pairs_);
    if (passes_.size() == 2)
      {
        std::vector<GroupPair> pairs;
        for (const GroupPair &pair : candidate_pairs_)
          pairs.push_back(swapped(pair));
        passes_[1].set_pairs(pairs);
      }
    results_.clear();
    find_active_nodes();
  }

  void Contact::find_active_nodes()
  {
    // All nodes of all groups in a pair, each once: a group may be in several pairs.
    active_slave_nodes_.clear();
    active_master_nodes_.clear();
    for (const GroupPair &pair : candidate_pairs_)
      {
        const auto &s = passes_[0].slave().group_nodes(pair.first);
        const auto &m = passes_[0].master().group_nodes(pair.second);
        active_slave_nodes_.insert(active_slave_nodes_.end(), s.begin(), s.end());
        active_master_nodes_.insert(active_master_nodes_.end(), m.begin(), m.end());
      }
    keep_each_once(active_slave_nodes_);
    keep_each_once(active_master_nodes_);
  }

  double Contact::vary_penalty()
  {
    double least = std::numeric_limits<double>::infinity();
    for (const ContactPass &pass : passes_)
      for (unsigned int f = 0; f < pass.slave().n_facets(); ++f)
        least = std::min(least, pass.slave().facet_width(f));
    for (ContactPass &pass : passes_)
      pass.slave_points().vary_stiffness(least);
    return least;
  }

  void Contact::set_stiffness(const std::vector<double> &of_group_points)
  {
    if (passes_.size() != 1)
      throw InputError("Contact/discretization",
                       "expected one pass with a stiffness per contact point, got two passes");
    passes_.front().slave_points().set_stiffness(of_group_points);
  }

  void Contact::add_forces(const SurfaceMotion &slave,
                           const SurfaceMotion &master,
                           const double         dt,
                           double              *slave_forces,
                           double              *master_forces)
  {
    if (!(penalty() > 0.))
      throw NumericalError("contact: the penalty is not set (Contact::set_penalty)");
    std::vector<TouchingPoint> points = locate(slave, master, dt, 0.);
    find_explicit_pressures(dt, points);
    press(points, dt, slave_forces, master_forces);
  }

  void Contact::find_explicit_pressures(const double dt, std::vector<TouchingPoint> &points) const
  {
    // The elastic pressures go through the law all at once.
    const SurfaceInteraction  interaction = this->interaction(dt);
    std::vector<PressedPoint> pressed(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        pressed[i].penetration = -points[i].gap;
        pressed[i].penalty     = interaction.penalty * points[i].stiffness;
      }
    interaction.law.evaluate(pressed);
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        points[i].elastic = pressed[i].pressure;
        points[i].energy  = pressed[i].energy;
        points[i].pressure =
          interaction.pressure(points[i].elastic, points[i].gap_rate, points[i].stiffness);
      }
  }

  std::vector<TouchingPoint> Contact::locate(const SurfaceMotion &slave,
                                             const SurfaceMotion &master,
                                             const double         dt,
                                             const double         look_ahead)
  {
    const SurfaceInteraction   interaction = this->interaction(dt);
    std::vector<TouchingPoint> points;
    for (unsigned int i = 0; i < passes_.size(); ++i)
      {
        // The second pass: the same pairs in the same order, seen from the master.
        const SurfaceMotion &of_slave  = i == 0 ? slave : master,
                            &of_master = i == 0 ? master : slave;
        passes_[i].locate(of_slave, of_master, interaction, look_ahead);
        for (TouchingPoint &point : passes_[i].touching())
          point.pass = i;
        points.insert(points.end(), passes_[i].touching().begin(), passes_[i].touching().end());
      }
    return points;
  }

  void Contact::press(const std::vector<TouchingPoint> &points,
                      const double                      dt,
                      double                           *slave_forces,
                      double                           *master_forces)
  {
    const SurfaceInteraction interaction = this->interaction(dt);
    auto                     next        = points.begin();
    for (unsigned int i = 0; i < passes_.size(); ++i)
      {
        std::vector<TouchingPoint> &touching = passes_[i].touching();
        std::copy_n(next, touching.size(), touching.begin());
        next += touching.size();
        if (i == 0)
          passes_[i].press(interaction, slave_forces, master_forces);
        else
          passes_[i].press(interaction, master_forces, slave_forces);
      }
    results_ = passes_[0].results();
    if (passes_.size() == 2)
      for (std::size_t i = 0; i < results_.size(); ++i)
        add_swapped(passes_[1].results()[i], results_[i]);
  }

  ContactPoint Contact::smallest_gap(const SurfaceMotion &slave,
                                     const SurfaceMotion &master,
                                     const double         reach,
                                     const PointShare    &share)
  {
    ContactPoint smallest = passes_[0].smallest_gap(slave, master, reach, share);
    if (passes_.size() == 2)
      {
        ContactPoint other = passes_[1].smallest_gap(master, slave, reach, share);
        other.swapped      = true;
        if (other.gap < smallest.gap)
          smallest = other;
      }
    return smallest;
  }

  std::pair<std::vector<unsigned int>, std::vector<unsigned int>> Contact::find_near_nodes(
    const SurfaceMotion &slave, const SurfaceMotion &master, const double reach)
  {
    std::pair<std::vector<unsigned int>, std::vector<unsigned int>> nodes;
    passes_[0].add_near_nodes(slave, master, reach, nodes.first, nodes.second);
    if (passes_.size() == 2)
      passes_[1].add_near_nodes(master, slave, reach, nodes.second, nodes.first);
    keep_each_once(nodes.first);
    keep_each_once(nodes.second);
    return nodes;
  }

  void Contact::place(const RigidMotion &slave, const RigidMotion &master)
  {
    passes_[0].place(slave_to_master(slave, master));
    if (passes_.size() == 2)
      passes_[1].place(slave_to_master(master, slave));
  }

  std::vector<ContactPoint> Contact::points() const
  {
    std::vector<ContactPoint> points;
    for (std::size_t i = 0; i < passes_.size(); ++i)
      passes_[i].append_points(points, i == 1);
    return points;
  }

  std::vector<ContactSpring> Contact::springs()
  {
    std::vector<ContactSpring> springs;
    for (std::size_t i = 0; i < passes_.size(); ++i)
      passes_[i].append_springs(interaction_.law(), penalty(), i == 1, springs);
    return springs;
  }

  double Contact::search_skin() const
  {
    double skin = passes_[0].lists().skin();
    for (const ContactPass &pass : passes_)
      skin = std::max(skin, pass.lists().skin());
    return skin;
  }

  double Contact::depth_limit() const
  {
    return passes_[0].lists().depth_limit();
  }

  std::size_t Contact::n_listed_points() const
  {
    std::size_t n = 0;
    for (const ContactPass &pass : passes_)
      n += pass.lists().n_points();
    return n;
  }

  std::size_t Contact::n_wide_searches() const
  {
    std::size_t n = 0;
    for (const ContactPass &pass : passes_)
      n += pass.lists().n_wide_searches();
    return n;
  }

  void Contact::set_shares(const std::vector<PointShare> &shares)
  {
    // The second pass has the same pairs in the same order.
    for (ContactPass &pass : passes_)
      pass.set_shares(shares);
    results_ = passes_[0].results();
  }

  std::vector<double> Contact::take_work()
  {
    std::vector<double> of_pairs(candidate_pairs_.size(), 0.);
    for (ContactPass &pass : passes_)
      pass.take_work(of_pairs);
    return of_pairs;
  }

  void Contact::serialize(ByteStream &stream)
  {
    stream.pass(candidate_pairs_);
    for (const auto &pair : candidate_pairs_)
      stream.require(pair.first < passes_[0].slave().n_groups() &&
                       pair.second < passes_[0].master().n_groups(),
                     "groups that the surfaces have not");
    for (ContactPass &pass : passes_)
      pass.serialize(stream);
    if (stream.reads())
      find_active_nodes();
  }

  void Contact::set_friction_mode(const FrictionMode mode)
  {
    for (ContactPass &pass : passes_)
      pass.set_friction_mode(mode);
  }

  std::vector<AnchorOfPoint> Contact::anchors() const
  {
    std::vector<AnchorOfPoint> anchors;
    for (unsigned int i = 0; i < passes_.size(); ++i)
      passes_[i].append_anchors(i, anchors);
    return anchors;
  }

  bool Contact::has_restored_anchors() const
  {
    return std::any_of(passes_.begin(), passes_.end(), [](const ContactPass &pass) {
      return pass.has_restored_anchors();
    });
  }

  bool Contact::has_place(const AnchorOfPoint &of_point) const
  {
    const ContactAnchor &anchor = of_point.anchor;
    return of_point.pass < passes_.size() &&
           anchor.facet < passes_[of_point.pass].master().n_facets() &&
           std::isfinite(anchor.xi + anchor.eta + anchor.elastic + anchor.energy);
  }

  void Contact::restore_anchors(const std::vector<AnchorOfPoint> &anchors)
  {
    for (unsigned int i = 0; i < passes_.size(); ++i)
      {
        std::vector<AnchorOfPoint> of_pass;
        for (const AnchorOfPoint &anchor : anchors)
          if (anchor.pass == i)
            of_pass.push_back(anchor);
        passes_[i].restore_anchors(of_pass);
      }
  }
} // namespace vfife
