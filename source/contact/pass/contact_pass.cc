// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A point that touches, and its force:
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
#include <vfife/base/process/wall_clock.h>
#include <vfife/contact/pass/contact_pass.h>
#include <vfife/contact/pass/smallest_gap.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Cosine between the normals below which slave and master count as facing each other. */
    constexpr double facing_cosine = -0.2;

    inline void add_to(double *forces, const unsigned int node, const Vector3 &f)
    {
      double *target = forces + 3 * static_cast<std::size_t>(node);
      target[0] += f[0];
      target[1] += f[1];
      target[2] += f[2];
    }

    ContactSpring
    make_spring(PassSurfaces &surfaces, const ListedPoint &point, const PressedPoint &elastic)
    {
      const Projection  &p = point.projection;
      const Vector3      x = surfaces.slave.position(point.slave_facet, point.rule_point);
      const TangentBasis basis(surfaces.master, p, x, surfaces.normal(p));
      const Fading       fade = surfaces.fading(p);
      // The slope of g sqrt(w), by the slopes of the gap and of the weight along the facet.
      const double by_weight = 0.5 * point.gap / fade.weight;

      ContactSpring spring;
      spring.slave_nodes    = surfaces.slave.surface().corners(point.slave_facet);
      spring.master_nodes   = surfaces.master.corners(p.facet);
      spring.slave_weights  = surfaces.slave.rule()[point.rule_point].shape;
      spring.master_weights = bilinear_weights(p.xi, p.eta);
      spring.direction =
        std::sqrt(fade.weight) *
        (basis.normal - (basis.slope_xi - by_weight * fade.slope_xi) * basis.dual_xi -
         (basis.slope_eta - by_weight * fade.slope_eta) * basis.dual_eta);
      spring.stiffness = elastic.tangent;
      return spring;
    }
  } // namespace

  ContactPass::ContactPass(const FacetSurface   &slave,
                           const FacetSurface   &master,
                           const ContactOptions &options,
                           const double          area_factor)
    : surfaces_(std::make_unique<PassSurfaces>(slave, master, options, area_factor))
    , lists_(*surfaces_, options)
    , friction_(*surfaces_)
    , master_carried_areas_(surfaces_->slave.carried_areas_on(surfaces_->master,
                                                              surfaces_->edge_fading,
                                                              FacetDirections()))
  {
  }

  void ContactPass::place(const RigidMotion &slave_to_master)
  {
    master_carried_areas_ =
      surfaces_->slave.carried_areas_on(surfaces_->master,
                                        surfaces_->edge_fading,
                                        find_directions(slave(), master(), slave_to_master));
  }

  void ContactPass::set_pairs(const std::vector<std::pair<unsigned int, unsigned int>> &pairs)
  {
    lists_.set_pairs(pairs);
    results_.clear();
  }

  void ContactPass::set_shares(const std::vector<PointShare> &shares)
  {
    lists_.set_shares(shares);
    clear_results();
  }

  void ContactPass::set_friction_mode(const FrictionMode mode)
  {
    // A point that sleeps is to be looked at: held anchors are put under all points, and those of
    // open points go when sliding goes on.
    if (friction_.set_mode(mode))
      lists_.wake();
  }

  void ContactPass::append_anchors(const unsigned int          pass,
                                   std::vector<AnchorOfPoint> &anchors) const
  {
    // Before the first forces of a run that goes on the points have none yet.
    anchors.insert(anchors.end(), friction_.restored().begin(), friction_.restored().end());
    for (const PointList &list : lists_.all())
      StickSlip::append_anchors(pass, list, anchors);
  }

  void ContactPass::locate(const SurfaceMotion      &slave,
                           const SurfaceMotion      &master,
                           const SurfaceInteraction &interaction,
                           const double              look_ahead)
  {
    friction_.begin(interaction, 2. * look_ahead, lists_.all());

    double     last     = times_ != nullptr ? processor_time() : 0.;
    const auto add_time = [&](double ContactTimes::*part_of_step) {
      if (times_ == nullptr)
        return;
      const double now = processor_time();
      times_->*part_of_step += now - last;
      last = now;
    };

    // How far the groups have moved; who may touch; where the points lie; what the law says.
    surfaces_->bind(slave, master);
    lists_.update_paths();
    add_time(&ContactTimes::motion);
    lists_.renew(friction_);
    friction_.use_restored(lists_.all());
    add_time(&ContactTimes::wide_search);
    lists_.find_touching(look_ahead, friction_);
    add_time(&ContactTimes::projection);

    clear_results();
    for (std::size_t i = 0; i < lists_.all().size(); ++i)
      describe(i, interaction.damping > 0.);
    add_time(&ContactTimes::forces);
  }

  void ContactPass::clear_results()
  {
    const std::vector<PointList> &lists = lists_.all();
    touching_.clear();
    touches_.clear();
    results_.assign(lists.size(), GroupPairResult());
    for (std::size_t i = 0; i < lists.size(); ++i)
      {
        results_[i].slave_group  = lists[i].slave_group;
        results_[i].master_group = lists[i].master_group;
      }
  }

  void ContactPass::describe(const unsigned int number, const bool with_rates)
  {
    PointList       &list   = lists_.all()[number];
    GroupPairResult &result = results_[number];
    for (const unsigned int i : list.touching)
      {
        ListedPoint      &point  = list.points[i];
        const Projection &p      = point.projection;
        const Vector3     normal = surfaces_->normal(p);
        // Surfaces that do not face each other do not press.
        const Vector3 slave_normal = slave().vector_area(point.slave_facet);
        const bool    faces = normal.dot(slave_normal) <= facing_cosine * slave_normal.norm();
        const Fading  fade  = faces ? surfaces_->fading(p) : Fading();
        if (faces)
          result.largest_penetration = std::max(result.largest_penetration, -point.gap);
        if (!faces || point.area * fade.weight <= 0.)
          {
            point.pressure = 0.;
            friction_.open(list, i, true);
            continue;
          }
        const Vector3 x = surfaces_->slave.position(point.slave_facet, point.rule_point);
        touches_.push_back({number, i, x, fade, TangentBasis(surfaces_->master, p, x, normal)});
        describe(point, touches_.back(), with_rates);
      }
  }

  void ContactPass::describe(const ListedPoint &point, const Touch &touch, const bool with_rates)
  {
    // The gap's slopes: along the normal, and along the facet where the gap changes as the point
    // slides; the couple of that part goes to the master's corners.
    const Projection   &p       = point.projection;
    const Fading       &fade    = touch.fade;
    const TangentBasis &basis   = touch.basis;
    const Vector3      &normal  = basis.normal;
    const auto          weights = bilinear_weights(p.xi, p.eta);
    const Vector3 tangential = -basis.slope_xi * basis.dual_xi - basis.slope_eta * basis.dual_eta;

    TouchingPoint touching;
    touching.pair         = touch.list;
    touching.slave_facet  = point.slave_facet;
    touching.rule_point   = point.rule_point;
    touching.slave_nodes  = slave().corners(point.slave_facet);
    touching.master_nodes = master().corners(p.facet);
    touching.area         = point.area * fade.weight;
    touching.gap          = point.gap;
    touching.stiffness    = surfaces_->slave.stiffness(point.slave_facet, point.rule_point);
    touching.pressure     = fade.weight > 0. ? point.pressure / fade.weight : 0.;
    Eigen::Map<Vector3>(touching.direction) = normal + tangential;
    const FacetQuadraturePoint &q           = surfaces_->slave.rule()[point.rule_point];
    for (unsigned int k = 0; k < 4; ++k)
      {
        touching.slave_weights[k] = q.shape[k];
        Eigen::Map<Vector3> slope(touching.master_slopes[k]);
        slope = -weights[k] * (normal + tangential) + basis.couple_share(tangential, k) * normal;
        if (with_rates)
          touching.gap_rate +=
            touching.slave_weights[k] *
              touching.normal_slope().dot(slave().velocity(touching.slave_nodes[k])) +
            slope.dot(master().velocity(touching.master_nodes[k]));
      }
    touching_.push_back(touching);
  }

  void ContactPass::press(const SurfaceInteraction &interaction,
                          double                   *slave_forces,
                          double                   *master_forces)
  {
    const double            start = times_ != nullptr ? processor_time() : 0.;
    std::vector<PointList> &lists = lists_.all();
    for (std::size_t i = 0; i < touching_.size(); ++i)
      if (!press(i, interaction, slave_forces, master_forces))
        friction_.open(lists[touches_[i].list], touches_[i].point, true);
    for (std::size_t i = 0; i < lists.size(); ++i)
      {
        results_[i].friction_loss += lists[i].released;
        lists[i].released = 0.;
      }
    if (times_ != nullptr)
      times_->forces += processor_time() - start;
  }

  bool ContactPass::press(const std::size_t         number,
                          const SurfaceInteraction &interaction,
                          double                   *slave_forces,
                          double                   *master_forces)
  {
    const TouchingPoint &touching = touching_[number];
    const Touch         &touch    = touches_[number];
    const TangentBasis  &basis    = touch.basis;
    PointList           &list     = lists_.all()[touch.list];
    ListedPoint         &point    = list.points[touch.point];
    GroupPairResult     &result   = results_[touch.list];
    const double         pressure = touching.pressure, area = touching.area;
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
    Vector3      tangential    = -weight_energy * (touch.fade.slope_xi * basis.dual_xi +
                                           touch.fade.slope_eta * basis.dual_eta);
    if (friction_.acts())
      {
        const FrictionForce friction = friction_.stick(list, touch, touching, interaction);
        tangential += friction.force;
        result.energy += friction.energy;
        result.friction_loss += friction.loss;
      }
    // Opposite forces on the corners of both facets, by the weights of the point in each.
    const auto    weights = bilinear_weights(point.projection.xi, point.projection.eta);
    const Vector3 force   = (pressure * area) * touching.normal_slope() + tangential;
    for (unsigned int k = 0; k < 4; ++k)
      {
        add_to(slave_forces, touching.slave_nodes[k], touching.slave_weights[k] * force);
        add_to(master_forces,
               touching.master_nodes[k],
               (pressure * area) * touching.master_slope(k) - weights[k] * tangential +
                 basis.couple_share(tangential, k) * basis.normal);
      }
    result.force += force;
    result.moment += touch.x.cross(force);
    result.area += area;
    result.normal_force += pressure * area;
    return true;
  }

  ContactPoint ContactPass::smallest_gap(const SurfaceMotion &slave,
                                         const SurfaceMotion &master,
                                         const double         reach,
                                         const PointShare    &share)
  {
    surfaces_->bind(slave, master);
    ContactPoint smallest;
    for (const PointList &list : lists_.all())
      {
        const PointList    near    = lists_.points_within(list, reach, share);
        const ContactPoint of_list = find_smallest_gap(*surfaces_, near.points);
        if (of_list.gap < smallest.gap)
          smallest = of_list;
      }
    return smallest;
  }

  void ContactPass::add_near_nodes(const SurfaceMotion       &slave,
                                   const SurfaceMotion       &master,
                                   const double               reach,
                                   std::vector<unsigned int> &slave_nodes,
                                   std::vector<unsigned int> &master_nodes)
  {
    surfaces_->bind(slave, master);
    for (const PointList &list : lists_.all())
      {
        const PointList near = lists_.points_within(list, reach, PointShare());
        for (const ListedPoint &point : near.points)
          {
            const auto &s = this->slave().corners(point.slave_facet);
            const auto &m = this->master().corners(point.projection.facet);
            slave_nodes.insert(slave_nodes.end(), s.begin(), s.end());
            master_nodes.insert(master_nodes.end(), m.begin(), m.end());
          }
      }
  }

  void ContactPass::append_points(std::vector<ContactPoint> &points, const bool swapped) const
  {
    for (const PointList &list : lists_.all())
      for (const ListedPoint &point : list.points)
        if (point.pressure > 0.)
          {
            ContactPoint out;
            out.swapped      = swapped;
            out.position     = surfaces_->slave.position(point.slave_facet, point.rule_point);
            out.slave_facet  = point.slave_facet;
            out.master_facet = point.projection.facet;
            out.xi           = point.projection.xi;
            out.eta          = point.projection.eta;
            out.gap          = point.gap;
            out.pressure     = point.pressure;
            points.push_back(out);
          }
  }

  void ContactPass::append_springs(const ContactLaw           &law,
                                   const double                penalty,
                                   const bool                  swapped,
                                   std::vector<ContactSpring> &springs)
  {
    for (const PointList &list : lists_.all())
      {
        std::vector<const ListedPoint *> points;
        std::vector<PressedPoint>        pressed;
        for (const ListedPoint &point : list.points)
          if (point.pressure > 0.)
            {
              const double stiffness =
                surfaces_->slave.stiffness(point.slave_facet, point.rule_point);
              points.push_back(&point);
              pressed.push_back({-point.gap, penalty * stiffness * point.area});
            }
        law.evaluate(pressed);
        for (std::size_t i = 0; i < points.size(); ++i)
          {
            springs.push_back(make_spring(*surfaces_, *points[i], pressed[i]));
            springs.back().swapped = swapped;
          }
      }
  }
} // namespace vfife
