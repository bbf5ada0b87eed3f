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

    /** Cosine between the normals below which slave and master count as facing each other. */
    constexpr double facing_cosine = -0.2;

    inline void add_to(double *forces, const unsigned int node, const Vector3 &f)
    {
      double *target = forces + 3 * static_cast<std::size_t>(node);
      target[0] += f[0];
      target[1] += f[1];
      target[2] += f[2];
    }

    /** Weight and its slope: 0 at t = 0, 1 from t = 1 on, without kink. */
    struct SmoothStep
    {
      double value, slope;

      explicit SmoothStep(const double t)
        : value(t <= 0.   ? 0.
                : t >= 1. ? 1.
                          : t * t * (3. - 2. * t))
        , slope(t <= 0. || t >= 1. ? 0. : 6. * t * (1. - t))
      {
      }
    };
  } // namespace


  ContactPass::Fading ContactPass::fading(const Projection &p) const
  {
    Fading             fading;
    const unsigned int border = master_.border_sides(p.facet);
    if (border == 0 || edge_fading_ <= 0.)
      return fading;
    // The product of a step from each border side, so that corners fade in both directions.
    const double     scale = 1. / edge_fading_;
    const SmoothStep one((border & 8u) != 0 ? p.xi * scale : 1.);
    const SmoothStep two((border & 2u) != 0 ? (1. - p.xi) * scale : 1.);
    const SmoothStep three((border & 1u) != 0 ? p.eta * scale : 1.);
    const SmoothStep four((border & 4u) != 0 ? (1. - p.eta) * scale : 1.);
    const double     along_xi = one.value * two.value, along_eta = three.value * four.value;
    fading.weight    = along_xi * along_eta;
    fading.slope_xi  = scale * (one.slope * two.value - one.value * two.slope) * along_eta;
    fading.slope_eta = scale * (three.slope * four.value - three.value * four.slope) * along_xi;
    return fading;
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


  void ContactPass::find_gaps(Pair &pair)
  {
    const double path =
      slave_path_.length(pair.slave_group) + master_path_.length(pair.master_group);
    pair.touching.clear();
    for (unsigned int i = 0; i < pair.points.size(); ++i)
      {
        // Asleep: the gap was too wide to have closed since.
        if (path < pair.awake_at[i])
          continue;
        ListedPoint  &point = pair.points[i];
        const Vector3 x     = slave_point(point.slave_facet, point.rule_point);
        point.pressure      = 0.;
        if (!locate(pair, point, x, path, pair.awake_at[i]))
          {
            if (has_friction_)
              open(pair, i, false);
            continue;
          }
        // lambda counts in lengths of m, the gap between the true surfaces in mm.
        const Projection &p      = point.projection;
        const double      length = master_.state(p.facet).normal(p.xi, p.eta).norm();
        point.gap = p.lambda * length - master_.offset(p.facet, p.xi, p.eta) - point.slave_offset;
        // Open: sleep. Closed: touching, unless it is deep enough to belong to the other side of a
        // thin body.
        if (point.gap >= 0.)
          pair.awake_at[i] = path + sleep_per_gap * point.gap;
        else if (point.gap > -depth_limit_)
          {
            pair.touching.push_back(i);
            continue;
          }
        if (has_friction_)
          open(pair, i, true);
      }
  }


  void ContactPass::press_pair(Pair                     &pair,
                               const SurfaceInteraction &interaction,
                               GroupPairResult          &result,
                               double                   *slave_forces,
                               double                   *master_forces)
  {
    // Penetrations of all touching points go through the law at once, then each point presses.
    pressed_.resize(pair.touching.size());
    for (std::size_t i = 0; i < pressed_.size(); ++i)
      {
        pressed_[i].penetration = -pair.points[pair.touching[i]].gap;
        pressed_[i].penalty     = interaction.penalty;
      }
    interaction.law.evaluate(pressed_);
    for (std::size_t i = 0; i < pressed_.size(); ++i)
      {
        const unsigned int point  = pair.touching[i];
        ContactAnchor     *anchor = has_friction_ ? &pair.anchors[point] : nullptr;
        if (!press(pair.points[point],
                   pressed_[i],
                   interaction,
                   anchor,
                   result,
                   slave_forces,
                   master_forces) &&
            has_friction_)
          open(pair, point, true);
      }
    result.friction_loss += pair.released;
    pair.released = 0.;
  }


  bool ContactPass::press(ListedPoint              &point,
                          const PressedPoint       &elastic,
                          const SurfaceInteraction &interaction,
                          ContactAnchor            *anchor,
                          GroupPairResult          &result,
                          double                   *slave_forces,
                          double                   *master_forces)
  {
    const Vector3 x      = slave_point(point.slave_facet, point.rule_point);
    const Vector3 normal = master_.state(point.projection.facet)
                             .normal(point.projection.xi, point.projection.eta)
                             .normalized();
    // Surfaces that do not face each other do not press.
    const Vector3 slave_normal = slave_.vector_area(point.slave_facet);
    if (normal.dot(slave_normal) > facing_cosine * slave_normal.norm())
      return false;
    const Projection &p        = point.projection;
    const Fading      fade     = fading(p);
    const double      area     = point.area * fade.weight;
    result.largest_penetration = std::max(result.largest_penetration, -point.gap);
    if (area <= 0.)
      return false;

    const auto        &shape          = rule_[point.rule_point].shape;
    const auto         weights        = bilinear_weights(p.xi, p.eta);
    const auto        &slave_corners  = slave_.corners(point.slave_facet);
    const auto        &master_corners = master_.corners(p.facet);
    const TangentBasis basis(*this, point, x, normal);

    // Pressure: elastic, and damped where the gap's rate counts.
    double gap_rate = 0.;
    if (interaction.damping > 0.)
      {
        Vector3 velocity = Vector3::Zero(); // of the slave's point over the master's
        for (unsigned int k = 0; k < 4; ++k)
          velocity += shape[k] * slave_.velocity(slave_corners[k]) -
                      weights[k] * master_.velocity(master_corners[k]);
        const Vector3 slip = basis.slip(velocity, normal, master_, master_corners);
        gap_rate           = normal.dot(velocity) - basis.slope_xi * basis.dual_xi.dot(slip) -
                   basis.slope_eta * basis.dual_eta.dot(slip);
      }
    const double pressure = interaction.pressure(elastic.pressure, gap_rate);
    // What acts on the slave's area: a faded edge is soft and sinks in deeply, but carries little.
    point.pressure          = fade.weight * pressure;
    result.largest_pressure = std::max(result.largest_pressure, point.pressure);
    result.energy += elastic.energy * area;
    result.damping_power -= (pressure - elastic.pressure) * gap_rate * area;
    if (pressure <= 0.)
      return false;

    // The force is the slope of the energy w E(-g) A of the contact law: along the normal with the
    // gap, and along the facet where gap or weight change as the point slides.
    const double weight_energy = elastic.energy * point.area;
    const double along_xi      = pressure * area * basis.slope_xi + weight_energy * fade.slope_xi;
    const double along_eta     = pressure * area * basis.slope_eta + weight_energy * fade.slope_eta;
    Vector3      tangential    = -along_xi * basis.dual_xi - along_eta * basis.dual_eta;
    if (anchor != nullptr)
      tangential += stick(p, normal, basis, pressure, area, interaction, *anchor, result);
    // Opposite forces on the corners of both facets, by the weights of the point in each.
    basis.balance_couple(tangential, normal, master_corners, master_forces);

    const Vector3 force = (pressure * area) * normal + tangential;
    for (unsigned int k = 0; k < 4; ++k)
      {
        add_to(slave_forces, slave_corners[k], shape[k] * force);
        add_to(master_forces, master_corners[k], -weights[k] * force);
      }
    result.force += force;
    result.moment += x.cross(force);
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
        pressed_.clear();
        for (const ListedPoint &point : pair.points)
          if (point.pressure > 0.)
            {
              points.push_back(&point);
              pressed_.push_back({-point.gap, penalty * point.area});
            }
        law.evaluate(pressed_);
        for (std::size_t i = 0; i < points.size(); ++i)
          {
            springs.push_back(make_spring(*points[i], pressed_[i]));
            springs.back().swapped = swapped;
          }
      }
  }


  ContactSpring ContactPass::make_spring(const ListedPoint &point, const PressedPoint &elastic)
  {
    const Projection  &p = point.projection;
    const Vector3      x = slave_point(point.slave_facet, point.rule_point);
    const Vector3      n = master_.state(p.facet).normal(p.xi, p.eta).normalized();
    const TangentBasis basis(*this, point, x, n);
    const Fading       fade = fading(p);
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


  ContactPass::TangentBasis::TangentBasis(ContactPass       &pass,
                                          const ListedPoint &point,
                                          const Vector3     &x,
                                          const Vector3     &normal)
  {
    // Dual vectors of y_xi, y_eta, n; slopes of bilinear weights in the order (0,0), (1,0), (1,1),
    // (0,1).
    const Projection &p      = point.projection;
    const FacetState &state  = pass.master_.state(p.facet);
    const Vector3     y_xi   = state.along_xi(p.eta);
    const Vector3     y_eta  = state.along_eta(p.xi);
    const auto        offset = pass.master_.offset_gradient(p.facet, p.xi, p.eta);
    const double      by_det = 1. / y_xi.dot(y_eta.cross(normal));
    distance                 = (x - state.position(p.xi, p.eta)).dot(normal);
    dual_xi                  = by_det * y_eta.cross(normal);
    dual_eta                 = by_det * normal.cross(y_xi);
    slope_xi                 = normal.dot(y_xi) + offset[0];
    slope_eta                = normal.dot(y_eta) + offset[1];
    shape_xi                 = {{p.eta - 1., 1. - p.eta, p.eta, -p.eta}};
    shape_eta                = {{p.xi - 1., -p.xi, p.xi, 1. - p.xi}};
  }


  Vector3 ContactPass::TangentBasis::slip(const Vector3                     &relative_velocity,
                                          const Vector3                     &normal,
                                          const SurfaceGeometry             &master,
                                          const std::array<unsigned int, 4> &corners) const
  {
    // The velocity that the balancing forces work on completes the slip, which then vanishes for
    // any rigid motion of both bodies together.
    double tilt_xi = 0., tilt_eta = 0.;
    for (unsigned int k = 0; k < 4; ++k)
      {
        const double v_n = normal.dot(master.velocity(corners[k]));
        tilt_xi += shape_xi[k] * v_n;
        tilt_eta += shape_eta[k] * v_n;
      }
    return relative_velocity - normal.dot(relative_velocity) * normal +
           distance * (tilt_xi * dual_xi + tilt_eta * dual_eta);
  }


  void ContactPass::TangentBasis::balance_couple(const Vector3                     &force,
                                                 const Vector3                     &normal,
                                                 const std::array<unsigned int, 4> &corners,
                                                 double *master_forces) const
  {
    // Slave and master points are apart by `distance` along the normal (gap and offsets), so a
    // tangential force makes a couple. Normal forces h_k n on the master's corners balance it: h_k
    // = alpha N_k,xi + beta N_k,eta sum to zero and have the moment (alpha y_xi + beta y_eta) x n.
    const double alpha = distance * force.dot(dual_xi);
    const double beta  = distance * force.dot(dual_eta);
    for (unsigned int k = 0; k < 4; ++k)
      add_to(master_forces, corners[k], (alpha * shape_xi[k] + beta * shape_eta[k]) * normal);
  }
} // namespace vfife
