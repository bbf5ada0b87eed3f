// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of ContactPass that sticks and slides.
#include <vfife/contact/contact_pass.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace vfife
{
  void ContactPass::set_friction_mode(const FrictionMode mode)
  {
    if (mode == mode_)
      return;
    mode_ = mode;
    // A point that sleeps is to be looked at: held anchors are put under all points, and those of
    // open points go when sliding goes on.
    for (Pair &pair : pairs_)
      pair.awake_at.assign(pair.points.size(), -std::numeric_limits<double>::infinity());
  }


  void ContactPass::open(Pair &pair, const unsigned int i, const bool located)
  {
    ContactAnchor &anchor = pair.anchors[i];
    if (mode_ == FrictionMode::follows)
      {
        // The spring lets go, after its force has acted on half of the way since the evaluation
        // before, as all forces of central differences do.
        pair.released += anchor.energy;
        if (located && anchor.elastic > 0. && step_ > 0.)
          {
            const ListedPoint &point  = pair.points[i];
            const Projection  &p      = point.projection;
            const Vector3      normal = master_.state(p.facet).normal(p.xi, p.eta).normalized();
            const TangentBasis basis(master_,
                                     p,
                                     slave_point(point.slave_facet, point.rule_point),
                                     normal);
            const Vector3      way     = slip_way(point, normal, basis, step_);
            const Vector3      stretch = master_.state(p.facet).position(p.xi, p.eta) - way -
                                    master_.state(anchor.facet).position(anchor.xi, anchor.eta);
            pair.released += anchor.energy / (anchor.elastic * anchor.elastic) * stretch.dot(way);
          }
        anchor = ContactAnchor();
      }
    else if (located && !anchor.holds())
      {
        // Where a load step begins, for points that may come to touch within it.
        const Projection &p = pair.points[i].projection;
        anchor.facet        = p.facet;
        anchor.xi           = p.xi;
        anchor.eta          = p.eta;
      }
  }


  Vector3 ContactPass::slip_way(const ListedPoint  &point,
                                const Vector3      &normal,
                                const TangentBasis &basis,
                                const double        time) const
  {
    Vector3 way = Vector3::Zero();
    if (!(time > 0.))
      return way;
    // The velocity on which a tangential force and what balances its moment work.
    const auto    weights = bilinear_weights(point.projection.xi, point.projection.eta);
    const auto   &shape   = rule_[point.rule_point].shape;
    const auto   &slave   = slave_.corners(point.slave_facet);
    const auto   &master  = master_.corners(point.projection.facet);
    const Vector3 along = basis.dual_xi.normalized(), across = normal.cross(along);
    for (const Vector3 &direction : {along, across})
      {
        double speed = 0.;
        for (unsigned int k = 0; k < 4; ++k)
          speed += shape[k] * direction.dot(slave_.velocity(slave[k])) +
                   (basis.couple_share(direction, k) * normal - weights[k] * direction)
                     .dot(master_.velocity(master[k]));
        way += time * speed * direction;
      }
    return way;
  }


  Vector3 ContactPass::stick(const ListedPoint        &point,
                             const Vector3            &normal,
                             const TangentBasis       &basis,
                             const double              pressure,
                             const double              area,
                             const SurfaceInteraction &interaction,
                             ContactAnchor            &anchor,
                             GroupPairResult          &result)
  {
    // 1. The displacement along the surface since the point came to stick, between two places of
    // the master: zero in any common rigid motion. A point that comes to touch does so on the way
    // since the evaluation before.
    const Projection &p = point.projection;
    if (!anchor.holds())
      {
        const Vector3 way = mode_ == FrictionMode::follows ? slip_way(point, normal, basis, step_)
                                                           : Vector3(Vector3::Zero());
        anchor.facet      = p.facet;
        anchor.xi         = p.xi - basis.dual_xi.dot(way);
        anchor.eta        = p.eta - basis.dual_eta.dot(way);
      }
    Vector3 displacement = master_.state(p.facet).position(p.xi, p.eta) -
                           master_.state(anchor.facet).position(anchor.xi, anchor.eta);
    displacement -= normal.dot(displacement) * normal;

    // 2. Spring and slider. At rest and in a search for an equilibrium nothing slips.
    const double k =
      std::min(stiffness_of(point.slave_facet, point.rule_point) * interaction.tangential_penalty,
               interaction.tangential_limit);
    const FrictionLaw   &law   = *interaction.friction;
    const double         speed = law.depends_on_speed() && mode_ == FrictionMode::follows
                                   ? slip_way(point, normal, basis, 1.).norm()
                                   : 0.;
    const SliderResponse response =
      slide(law, {pressure, speed, k, anchor.elastic}, displacement.norm());
    const Vector3 elastic = response.elastic_part * displacement;
    result.energy += response.energy * area;

    // 3. In time the anchor follows a point that slides, at the distance that the spring keeps.
    if (mode_ == FrictionMode::follows)
      {
        result.friction_loss += response.loss * area;
        if (response.slid > 0.)
          {
            anchor.facet = p.facet;
            anchor.xi    = p.xi - basis.dual_xi.dot(elastic);
            anchor.eta   = p.eta - basis.dual_eta.dot(elastic);
          }
        anchor.elastic = response.elastic;
        anchor.energy  = response.energy * area;
      }
    return (-k * area) * elastic;
  }


  void ContactPass::append_anchors(const unsigned int          pass,
                                   const Pair                 &pair,
                                   std::vector<AnchorOfPoint> &anchors)
  {
    for (std::size_t i = 0; i < pair.anchors.size(); ++i)
      if (pair.anchors[i].holds())
        anchors.push_back({pass,
                           pair.slave_group,
                           pair.master_group,
                           pair.points[i].slave_facet,
                           pair.points[i].rule_point,
                           pair.anchors[i]});
  }


  void ContactPass::append_anchors(const unsigned int          pass,
                                   std::vector<AnchorOfPoint> &anchors) const
  {
    // Before the first forces of a run that goes on the points have none yet.
    anchors.insert(anchors.end(), restored_.begin(), restored_.end());
    for (const Pair &pair : pairs_)
      append_anchors(pass, pair, anchors);
  }


  void ContactPass::restore_anchors(const std::vector<AnchorOfPoint> &anchors)
  {
    restored_ = anchors;
  }


  bool ContactPass::has_restored_anchors() const
  {
    return !restored_.empty();
  }


  void ContactPass::place_anchors(const std::vector<AnchorOfPoint> &anchors, Pair &pair) const
  {
    if (anchors.empty())
      return;
    // By facet and point of the slave.
    const auto key = [this](const unsigned int facet, const unsigned int rule_point) {
      return static_cast<std::uint64_t>(facet) * rule_.size() + rule_point;
    };
    std::unordered_map<std::uint64_t, const ContactAnchor *> by_point;
    for (const AnchorOfPoint &a : anchors)
      if (a.slave_group == pair.slave_group && a.master_group == pair.master_group)
        by_point[key(a.slave_facet, a.rule_point)] = &a.anchor;
    for (std::size_t i = 0; i < pair.points.size(); ++i)
      {
        const auto found =
          by_point.find(key(pair.points[i].slave_facet, pair.points[i].rule_point));
        if (found != by_point.end())
          pair.anchors[i] = *found->second;
      }
  }
} // namespace vfife
