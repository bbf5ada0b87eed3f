// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// What ContactPass does in every step: finds where the listed points lie on the master, and presses
// those that have gone into it.
//
//            x_s            slave's facet, a quadrature point
//             |  ^
//      lambda m  | n        gap g = n.(x_s - y) - offsets of both true surfaces
//             |  |
//   ----------y------->     master's facet y(xi, eta): x_s - y is parallel to its normal field m
//                  y_xi
//
// The energy of a point is w(xi, eta) A E(-g), E of the contact law, A the undeformed area and w
// the fading at the master's border. The force on the slave is its slope, in the dual vectors a of
// the facet (n.a = 0, a_xi.y_xi = 1):
//   f = w A p n - (w A p c_xi + A E w_xi) a_xi - (the same in eta),   c_xi = n.y_xi + offset_xi.
#include <vfife/base/process/machine_speed.h>
#include <vfife/contact/contact_pass.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** Share of a gap that the groups may move before its point is looked at again (1/1.25). */
    constexpr double sleep_per_gap = 0.8;

    /** What a point that touches costs besides, its pressure and forces, in the cost of finding
     * where it lies (measured, doc/verification/contact.md). */
    constexpr double work_of_touching = 2.;

    /** Cosine between the normals below which slave and master count as facing each other. */
    constexpr double facing_cosine = -0.2;

    inline void add_to(double *forces, const unsigned int node, const Vector3 &f)
    {
      double *target = forces + 3 * static_cast<std::size_t>(node);
      target[0] += f[0];
      target[1] += f[1];
      target[2] += f[2];
    }
  } // namespace


  Fading ContactPass::find_fading(const Projection &p) const
  {
    return edge_fading_ > 0. ? Fading(master_, p, edge_fading_) : Fading();
  }


  bool ContactPass::locate(
    const Pair &pair, ListedPoint &point, const Vector3 &x, const double path, double &awake_at)
  {
    Projection &p = point.projection;
    if (!project_walking(master_, x, p))
      {
        // Lost: look through the whole group. Finding nothing means out of reach until the next
        // wide search.
        const double              reach = 1.5 * (depth_limit_ + 3. * skin_);
        const auto               &group = master_.group_facets(pair.master_group);
        std::vector<unsigned int> all(group.size());
        std::iota(all.begin(), all.end(), 0u);
        if (!find_closest(group,
                          facet_boxes(pair.master_group),
                          all,
                          x,
                          slave_.vector_area(point.slave_facet),
                          reach,
                          p))
          {
            // Start the next attempt from a defined state, not at once.
            p.xi = p.eta = 0.5;
            p.lambda     = 0.;
            p.inside     = false;
            awake_at     = path + 0.25 * skin_;
            return false;
          }
      }
    if (p.inside)
      return true;

    // Beyond the border: nothing can happen before the point has come half the way back to it.
    const FacetState &state   = master_.state(p.facet);
    const double      xi      = std::min(1., std::max(0., p.xi));
    const double      eta     = std::min(1., std::max(0., p.eta));
    const double      lateral = (state.position(p.xi, p.eta) - state.position(xi, eta)).norm();
    // The last part is for the tolerance beyond the border, within which a point is inside.
    awake_at = path + std::max(0., 0.5 * lateral - 0.002 * master_.mean_facet_size());
    return false;
  }


  void ContactPass::find_gaps(Pair &pair, const double look_ahead)
  {
    const double path =
      slave_path_.length(pair.slave_group) + master_path_.length(pair.master_group);
    pair.touching.clear();
    unsigned int n_awake = 0;
    for (unsigned int i = 0; i < pair.points.size(); ++i)
      {
        // Asleep: the gap was too wide to have closed since.
        if (path < pair.awake_at[i])
          continue;
        ++n_awake;
        ListedPoint  &point = pair.points[i];
        const Vector3 x     = slave_point(point.slave_facet, point.rule_point);
        if (!locate(pair, point, x, path, pair.awake_at[i]))
          {
            point.pressure = 0.;
            if (has_friction_)
              open(pair, i, false);
            continue;
          }
        // lambda counts in lengths of m, the gap between the true surfaces in mm.
        const Projection &p      = point.projection;
        const double      length = master_.state(p.facet).normal(p.xi, p.eta).norm();
        point.gap = p.lambda * length - master_.offset(p.facet, p.xi, p.eta) - point.slave_offset;
        // Open: sleep. Closed: touching (the pressure of the step before is a first guess), unless
        // it is deep enough to belong to the other side of a thin body.
        const double reach = find_reach(point, look_ahead);
        if (point.gap >= reach)
          // Accelerated while it sleeps, it may reach farther when it wakes.
          pair.awake_at[i] = path + std::max(0., sleep_per_gap * point.gap - 2. * reach);
        else if (point.gap > -depth_limit_)
          {
            pair.touching.push_back(i);
            continue;
          }
        point.pressure = 0.;
        if (has_friction_)
          open(pair, i, true);
      }
    pair.work += n_awake + work_of_touching * pair.touching.size();
  }


  double ContactPass::find_reach(const ListedPoint &point, const double look_ahead) const
  {
    // A point that is closed at either end of the step touches: half as far again as the faster of
    // its velocities over the master there goes in that time. Points too many carry nothing.
    constexpr double margin = 1.5;
    if (!(look_ahead > 0.))
      return 0.;
    const auto  weights = bilinear_weights(point.projection.xi, point.projection.eta);
    const auto &shape   = rule_[point.rule_point].shape;
    const auto &slave   = slave_.corners(point.slave_facet);
    const auto &master  = master_.corners(point.projection.facet);
    Vector3     before = Vector3::Zero(), after = Vector3::Zero();
    for (unsigned int k = 0; k < 4; ++k)
      {
        before += shape[k] * slave_.velocity(slave[k]) - weights[k] * master_.velocity(master[k]);
        after += shape[k] * slave_.later_velocity(slave[k]) -
                 weights[k] * master_.later_velocity(master[k]);
      }
    return margin * look_ahead * std::sqrt(std::max(before.squaredNorm(), after.squaredNorm()));
  }


  void ContactPass::describe(const unsigned int number, const bool with_rates)
  {
    Pair            &pair   = pairs_[number];
    GroupPairResult &result = results_[number];
    for (const unsigned int i : pair.touching)
      {
        ListedPoint      &point  = pair.points[i];
        const Projection &p      = point.projection;
        const Vector3     normal = master_.state(p.facet).normal(p.xi, p.eta).normalized();
        // Surfaces that do not face each other do not press.
        const Vector3 slave_normal = slave_.vector_area(point.slave_facet);
        const bool    faces = normal.dot(slave_normal) <= facing_cosine * slave_normal.norm();
        const Fading  fade  = faces ? find_fading(p) : Fading();
        if (faces)
          result.largest_penetration = std::max(result.largest_penetration, -point.gap);
        if (!faces || point.area * fade.weight <= 0.)
          {
            point.pressure = 0.;
            if (has_friction_)
              open(pair, i, true);
            continue;
          }
        // The gap's slopes: along the normal, and along the facet where the gap changes as the
        // point slides; the couple of that part goes to the master's corners.
        const Vector3 x = slave_point(point.slave_facet, point.rule_point);
        touches_.push_back({number, i, x, normal, fade, TangentBasis(master_, p, x, normal)});
        const TangentBasis &basis   = touches_.back().basis;
        const auto          weights = bilinear_weights(p.xi, p.eta);
        const Vector3       tangential =
          -basis.slope_xi * basis.dual_xi - basis.slope_eta * basis.dual_eta;

        TouchingPoint touching;
        touching.pair         = number;
        touching.slave_facet  = point.slave_facet;
        touching.rule_point   = point.rule_point;
        touching.slave_nodes  = slave_.corners(point.slave_facet);
        touching.master_nodes = master_.corners(p.facet);
        touching.area         = point.area * fade.weight;
        touching.gap          = point.gap;
        touching.stiffness    = stiffness_of(point.slave_facet, point.rule_point);
        touching.pressure     = fade.weight > 0. ? point.pressure / fade.weight : 0.;
        Eigen::Map<Vector3>(touching.direction) = normal + tangential;
        for (unsigned int k = 0; k < 4; ++k)
          {
            touching.slave_weights[k] = rule_[point.rule_point].shape[k];
            Eigen::Map<Vector3> slope(touching.master_slopes[k]);
            slope =
              -weights[k] * (normal + tangential) + basis.couple_share(tangential, k) * normal;
            if (with_rates)
              touching.gap_rate +=
                touching.slave_weights[k] *
                  touching.normal_slope().dot(slave_.velocity(touching.slave_nodes[k])) +
                slope.dot(master_.velocity(touching.master_nodes[k]));
          }
        touching_.push_back(touching);
      }
  }


  void ContactPass::press(const SurfaceInteraction &interaction,
                          double                   *slave_forces,
                          double                   *master_forces)
  {
    const double start = times_ != nullptr ? processor_time() : 0.;
    for (std::size_t i = 0; i < touching_.size(); ++i)
      {
        const Touch   &touch  = touches_[i];
        Pair          &pair   = pairs_[touch.pair];
        ContactAnchor *anchor = has_friction_ ? &pair.anchors[touch.point] : nullptr;
        if (!press(touching_[i],
                   touch,
                   interaction,
                   pair.points[touch.point],
                   anchor,
                   results_[touch.pair],
                   slave_forces,
                   master_forces) &&
            has_friction_)
          open(pair, touch.point, true);
      }
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      {
        results_[i].friction_loss += pairs_[i].released;
        pairs_[i].released = 0.;
      }
    if (times_ != nullptr)
      times_->forces += processor_time() - start;
  }


  bool ContactPass::press(const TouchingPoint      &touching,
                          const Touch              &touch,
                          const SurfaceInteraction &interaction,
                          ListedPoint              &point,
                          ContactAnchor            *anchor,
                          GroupPairResult          &result,
                          double                   *slave_forces,
                          double                   *master_forces)
  {
    const double pressure = touching.pressure, area = touching.area;
    // What acts on the slave's area: a faded edge is soft and sinks in deeply, but carries little.
    point.pressure          = touch.fade.weight * pressure;
    result.largest_pressure = std::max(result.largest_pressure, point.pressure);
    result.energy += touching.energy * area;
    result.damping_power -= (pressure - touching.elastic) * touching.gap_rate * area;
    if (pressure <= 0.)
      return false;

    // The force is the slope of the energy w E(-g) A of the contact law: by the slopes of the gap,
    // and along the facet where the weight changes as the point slides.
    const double weight_energy = touching.energy * point.area;
    Vector3      tangential    = -weight_energy * (touch.fade.slope_xi * touch.basis.dual_xi +
                                           touch.fade.slope_eta * touch.basis.dual_eta);
    if (anchor != nullptr)
      tangential +=
        stick(point, touch.normal, touch.basis, pressure, area, interaction, *anchor, result);
    // Opposite forces on the corners of both facets, by the weights of the point in each.
    const auto    weights = bilinear_weights(point.projection.xi, point.projection.eta);
    const Vector3 force   = (pressure * area) * touching.normal_slope() + tangential;
    for (unsigned int k = 0; k < 4; ++k)
      {
        add_to(slave_forces, touching.slave_nodes[k], touching.slave_weights[k] * force);
        add_to(master_forces,
               touching.master_nodes[k],
               (pressure * area) * touching.master_slope(k) - weights[k] * tangential +
                 touch.basis.couple_share(tangential, k) * touch.normal);
      }
    result.force += force;
    result.moment += touch.x.cross(force);
    result.area += area;
    result.normal_force += pressure * area;
    return true;
  }


  void ContactPass::append_springs(const ContactLaw           &law,
                                   const double                penalty,
                                   const bool                  swapped,
                                   std::vector<ContactSpring> &springs)
  {
    for (const Pair &pair : pairs_)
      {
        std::vector<const ListedPoint *> points;
        std::vector<PressedPoint>        pressed;
        for (const ListedPoint &point : pair.points)
          if (point.pressure > 0.)
            {
              points.push_back(&point);
              pressed.push_back(
                {-point.gap,
                 penalty * stiffness_of(point.slave_facet, point.rule_point) * point.area});
            }
        law.evaluate(pressed);
        for (std::size_t i = 0; i < points.size(); ++i)
          {
            springs.push_back(make_spring(*points[i], pressed[i]));
            springs.back().swapped = swapped;
          }
      }
  }


  ContactSpring ContactPass::make_spring(const ListedPoint &point, const PressedPoint &elastic)
  {
    const Projection  &p = point.projection;
    const Vector3      x = slave_point(point.slave_facet, point.rule_point);
    const Vector3      n = master_.state(p.facet).normal(p.xi, p.eta).normalized();
    const TangentBasis basis(master_, p, x, n);
    const Fading       fade = find_fading(p);
    // The slope of g sqrt(w), by the slopes of the gap and of the weight along the facet.
    const double by_weight = 0.5 * point.gap / fade.weight;

    ContactSpring spring;
    spring.slave_nodes    = slave_.corners(point.slave_facet);
    spring.master_nodes   = master_.corners(p.facet);
    spring.slave_weights  = rule_[point.rule_point].shape;
    spring.master_weights = bilinear_weights(p.xi, p.eta);
    spring.direction =
      std::sqrt(fade.weight) * (n - (basis.slope_xi - by_weight * fade.slope_xi) * basis.dual_xi -
                                (basis.slope_eta - by_weight * fade.slope_eta) * basis.dual_eta);
    spring.stiffness = elastic.tangent;
    return spring;
  }
} // namespace vfife
