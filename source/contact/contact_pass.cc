// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/machine_speed.h>
#include <vfife/contact/contact_pass.h>
#include <vfife/contact/search/carried_area.h>

#include <algorithm>
#include <limits>

namespace vfife
{
  namespace
  {
    /** A gap changes by the motion times at most this: the normal field is not exactly that of the
     * facets. */
    constexpr double gap_per_motion = 1.25;

    std::array<Vector3, 4> current_corners(const SurfaceGeometry &surface, const unsigned int facet)
    {
      const auto &k = surface.corners(facet);
      return {{surface.node(k[0]), surface.node(k[1]), surface.node(k[2]), surface.node(k[3])}};
    }
  } // namespace


  ContactPass::ContactPass(const FacetSurface   &slave,
                           const FacetSurface   &master,
                           const ContactOptions &options,
                           const double          area_factor)
    : slave_(slave, options.surface, EdgeRelief(slave, options))
    , master_(master, options.surface, EdgeRelief(master, options))
    , rule_(facet_quadrature(options.discretization, options.points_per_facet.number))
    , area_factor_(area_factor)
    , edge_fading_(options.edge_fading)
    , skin_(options.search_skin > 0. ? options.search_skin : 0.2 * master_.mean_facet_size())
    , depth_limit_(options.depth_limit > 0.
                     ? options.depth_limit
                     : 0.5 * std::min(slave_.mean_facet_size(), master_.mean_facet_size()))
    , slave_path_(slave_.n_groups())
    , master_path_(master_.n_groups())
  {
    // Undeformed areas, once for all: the energy of the contact then depends on gaps alone. A
    // corner has the integral of its shape function.
    const bool at_corners = options.discretization == ContactDiscretization::nodes;
    for (unsigned int f = 0; f < slave_.n_facets(); ++f)
      for (unsigned int i = 0; i < rule_.size(); ++i)
        {
          const FacetQuadraturePoint &q = rule_[i];
          point_areas_.push_back(area_factor *
                                 (at_corners ? slave_.corner_areas(f)[i]
                                             : q.weight * slave_.area_element(f, q.xi, q.eta)));
          point_offsets_.push_back(slave_.offset(f, q.xi, q.eta));
        }
    point_stiffness_.assign(point_areas_.size(), 1.);
    slave_carried_areas_ = slave_.node_areas();
    for (double &area : slave_carried_areas_)
      area *= area_factor_;
    bound_master_areas(FacetDirections());
  }


  void ContactPass::place(const RigidMotion &slave_to_master)
  {
    bound_master_areas(find_directions(slave_, master_, slave_to_master));
  }


  void ContactPass::vary_penalty(const double least_width)
  {
    point_stiffness_.clear();
    for (unsigned int f = 0; f < slave_.n_facets(); ++f)
      point_stiffness_.insert(point_stiffness_.end(),
                              rule_.size(),
                              least_width / slave_.facet_width(f));
  }


  void ContactPass::set_stiffness(const std::vector<double> &of_group_points)
  {
    for (unsigned int g = 0; g < slave_.n_groups(); ++g)
      {
        const std::vector<unsigned int> &facets = slave_.group_facets(g);
        if (facets.size() * rule_.size() != of_group_points.size())
          throw InputError("stiffness of a contact: expected one value per point of a group (" +
                           std::to_string(facets.size() * rule_.size()) + "), got " +
                           std::to_string(of_group_points.size()));
        for (std::size_t k = 0; k < facets.size(); ++k)
          std::copy_n(of_group_points.begin() + k * rule_.size(),
                      rule_.size(),
                      point_stiffness_.begin() + facets[k] * rule_.size());
      }
  }


  double ContactPass::largest_stiffness_of(const unsigned int slave_facet) const
  {
    double largest = 0;
    for (unsigned int i = 0; i < rule_.size(); ++i)
      largest = std::max(largest, stiffness_of(slave_facet, i));
    return largest;
  }


  void ContactPass::bound_master_areas(const FacetDirections &directions)
  {
    master_carried_areas_ = CarriedArea(rule_, edge_fading_).bound(slave_, master_, directions);
    for (double &area : master_carried_areas_)
      area *= area_factor_;
  }


  void ContactPass::set_pairs(const std::vector<std::pair<unsigned int, unsigned int>> &pairs)
  {
    // Lists and projections of pairs that stay are taken over, new pairs begin without a list.
    std::vector<Pair> kept;
    for (const auto &groups : pairs)
      {
        const auto old = std::find_if(pairs_.begin(), pairs_.end(), [&groups](const Pair &pair) {
          return pair.slave_group == groups.first && pair.master_group == groups.second;
        });
        if (old != pairs_.end())
          kept.push_back(std::move(*old));
        else
          {
            kept.emplace_back();
            kept.back().slave_group  = groups.first;
            kept.back().master_group = groups.second;
          }
      }
    pairs_ = std::move(kept);
    follow_groups();
    results_.clear();
  }


  void ContactPass::set_shares(const std::vector<PointShare> &shares)
  {
    // Points that come from other ranks are listed anew; what is gone is forgotten.
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (!(pairs_[i].share == shares[i]))
        {
          Pair changed;
          changed.slave_group  = pairs_[i].slave_group;
          changed.master_group = pairs_[i].master_group;
          changed.share        = shares[i];
          pairs_[i]            = std::move(changed);
        }
    follow_groups();
    clear_results();
  }


  void ContactPass::take_work(std::vector<double> &of_pairs)
  {
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      {
        of_pairs[i] += pairs_[i].work;
        pairs_[i].work = 0.;
      }
  }


  void ContactPass::follow_groups()
  {
    std::vector<unsigned int> slave_groups, master_groups;
    for (const Pair &pair : pairs_)
      if (!pair.share.empty())
        {
          slave_groups.push_back(pair.slave_group);
          master_groups.push_back(pair.master_group);
        }
    for (auto *groups : {&slave_groups, &master_groups})
      {
        std::sort(groups->begin(), groups->end());
        groups->erase(std::unique(groups->begin(), groups->end()), groups->end());
      }
    slave_path_.set_active(slave_groups);
    master_path_.set_active(master_groups);
  }


  std::size_t ContactPass::n_listed_points() const
  {
    std::size_t n = 0;
    for (const Pair &pair : pairs_)
      n += pair.points.size();
    return n;
  }


  Vector3 ContactPass::slave_point(const unsigned int facet, const unsigned int rule_point) const
  {
    const auto &k = slave_.corners(facet);
    const auto &N = rule_[rule_point].shape;
    return N[0] * slave_.node(k[0]) + N[1] * slave_.node(k[1]) + N[2] * slave_.node(k[2]) +
           N[3] * slave_.node(k[3]);
  }


  std::vector<Box> ContactPass::facet_boxes(const unsigned int group) const
  {
    std::vector<Box> boxes;
    boxes.reserve(master_.group_facets(group).size());
    for (const unsigned int f : master_.group_facets(group))
      boxes.push_back(Box::around(current_corners(master_, f), 0.));
    return boxes;
  }


  bool ContactPass::find_closest(const std::vector<unsigned int> &group,
                                 const std::vector<Box>          &boxes,
                                 std::vector<unsigned int>       &near,
                                 const Vector3                   &x,
                                 const Vector3                   &slave_normal,
                                 const double                     reach,
                                 Projection                      &best)
  {
    // A point that lies over a facet is preferred to the border of another that is a little nearer.
    constexpr double border_handicap = 1.5;

    double      nearest = reach;
    std::size_t found   = near.size();
    for (std::size_t i = 0; i < near.size(); ++i)
      {
        // Farther than the best foot so far, without any projection?
        if (boxes[near[i]].square_distance(x) > nearest * nearest)
          continue;

        // Newton's method from the middle of the facet, with the height over it.
        const unsigned int facet  = group[near[i]];
        const FacetState  &state  = master_.state(facet);
        const Vector3      normal = state.normal(0.5, 0.5);
        Projection         projection;
        projection.facet  = facet;
        projection.lambda = (x - state.position(0.5, 0.5)).dot(normal) / normal.squaredNorm();
        if (!project_on_facet(state, master_.border_sides(facet), x, projection))
          continue;

        // Back sides of the master are no candidates.
        const double xi  = std::min(1., std::max(0., projection.xi));
        const double eta = std::min(1., std::max(0., projection.eta));
        if (state.normal(xi, eta).dot(slave_normal) > 0.)
          continue;

        // The foot counts where it lies on the facet; one beyond it is moved to the border.
        double distance = clamped_distance(state, x, projection);
        if (!projection.inside)
          distance *= border_handicap;
        if (distance <= nearest)
          {
            nearest = distance;
            best    = projection;
            found   = i;
          }
      }
    if (found == near.size())
      return false;
    std::swap(near.front(), near[found]);
    return true;
  }


  void ContactPass::find_points(Pair &pair, const double open_reach, const double depth_reach)
  {
    ++n_wide_searches_;
    std::vector<AnchorOfPoint> anchors;
    append_anchors(0, pair, anchors);
    pair.points.clear();
    pair.touching.clear();

    // An R-tree of the master group's facets as they are now.
    const auto            &group = master_.group_facets(pair.master_group);
    const std::vector<Box> boxes = facet_boxes(pair.master_group);
    const BoxTree          tree(boxes);

    // 1.5: the handicap of border points in find_closest().
    const double reach = 1.5 * (std::max(open_reach, depth_reach) + slave_.largest_offset() +
                                master_.largest_offset());
    std::vector<unsigned int> near;
    for (const unsigned int facet : slave_.group_facets(pair.slave_group))
      {
        if (!pair.share.has(facet))
          continue;
        // Master facets near the whole slave facet, then the nearest foot of each of its points.
        tree.find(Box::around(current_corners(slave_, facet), reach), near);
        if (near.empty())
          continue;
        const Vector3 slave_normal = slave_.vector_area(facet);
        for (unsigned int q = 0; q < rule_.size(); ++q)
          {
            const Vector3 x = slave_point(facet, q);
            ListedPoint   point;
            if (!find_closest(group, boxes, near, x, slave_normal, reach, point.projection))
              continue;
            // The neighbour decides about points at the very edge of two facets.
            Projection walked = point.projection;
            if (project_walking(master_, x, walked))
              point.projection = walked;

            // What the point needs in every step, and its gap; one that lies beyond the border is
            // kept too, as it may come in.
            const std::size_t i = static_cast<std::size_t>(facet) * rule_.size() + q;
            const Projection &p = point.projection;
            point.slave_facet   = facet;
            point.rule_point    = q;
            point.area          = point_areas_[i];
            point.slave_offset  = point_offsets_[i];
            point.pressure      = 0.;
            point.gap           = std::numeric_limits<double>::infinity();
            if (p.inside)
              {
                point.gap = p.lambda * master_.state(p.facet).normal(p.xi, p.eta).norm() -
                            master_.offset(p.facet, p.xi, p.eta) - point.slave_offset;
                if (point.gap >= open_reach || point.gap <= -depth_reach)
                  continue;
              }
            pair.points.push_back(point);
          }
      }
    if (has_friction_)
      {
        pair.anchors.assign(pair.points.size(), ContactAnchor());
        place_anchors(anchors, pair);
      }
    // None sleeps yet.
    pair.awake_at.assign(pair.points.size(), -std::numeric_limits<double>::infinity());
  }


  void ContactPass::update_paths(const SurfaceMotion &slave, const SurfaceMotion &master)
  {
    slave_.bind(slave);
    master_.bind(master);
    slave_path_.update(slave_, master.body);
    master_path_.update(master_, master.body);
  }


  void ContactPass::list_points()
  {
    for (Pair &pair : pairs_)
      {
        if (pair.share.empty())
          continue;
        // The list is good until the gap of a point that is not in it could have closed.
        const double path =
          slave_path_.length(pair.slave_group) + master_path_.length(pair.master_group);
        if (pair.listed && path - pair.built_at <= skin_)
          continue;
        find_points(pair, gap_per_motion * skin_, depth_limit_ + gap_per_motion * skin_);
        pair.listed   = true;
        pair.built_at = path;
      }
  }


  void ContactPass::locate(const SurfaceMotion      &slave,
                           const SurfaceMotion      &master,
                           const SurfaceInteraction &interaction,
                           const double              look_ahead)
  {
    has_friction_ = interaction.friction != nullptr && mode_ != FrictionMode::none;
    step_         = 2. * look_ahead;
    for (Pair &pair : pairs_)
      pair.anchors.resize(has_friction_ ? pair.points.size() : 0);

    double     last     = times_ != nullptr ? processor_time() : 0.;
    const auto add_time = [&](double ContactTimes::*part_of_step) {
      if (times_ == nullptr)
        return;
      const double now = processor_time();
      times_->*part_of_step += now - last;
      last = now;
    };

    // How far the groups have moved; who may touch; where the points lie; what the law says.
    update_paths(slave, master);
    add_time(&ContactTimes::motion);
    list_points();
    if (has_friction_ && !restored_.empty())
      {
        for (Pair &pair : pairs_)
          place_anchors(restored_, pair);
        restored_.clear();
      }
    add_time(&ContactTimes::wide_search);
    for (Pair &pair : pairs_)
      find_gaps(pair, look_ahead);
    add_time(&ContactTimes::projection);

    clear_results();
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      describe(i, interaction.damping > 0.);
    add_time(&ContactTimes::forces);
  }


  void ContactPass::clear_results()
  {
    touching_.clear();
    touches_.clear();
    results_.assign(pairs_.size(), GroupPairResult());
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      {
        results_[i].slave_group  = pairs_[i].slave_group;
        results_[i].master_group = pairs_[i].master_group;
      }
  }


  void ContactPass::append_points(std::vector<ContactPoint> &points, const bool swapped) const
  {
    for (const Pair &pair : pairs_)
      for (const ListedPoint &point : pair.points)
        if (point.pressure > 0.)
          {
            ContactPoint out;
            out.swapped      = swapped;
            out.position     = slave_point(point.slave_facet, point.rule_point);
            out.slave_facet  = point.slave_facet;
            out.master_facet = point.projection.facet;
            out.xi           = point.projection.xi;
            out.eta          = point.projection.eta;
            out.gap          = point.gap;
            out.pressure     = point.pressure;
            points.push_back(out);
          }
  }
} // namespace vfife
