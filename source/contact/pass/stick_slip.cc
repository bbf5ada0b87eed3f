// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/contact/pass/stick_slip.h>

#include <algorithm>
#include <unordered_map>

namespace vfife
{
  bool StickSlip::set_mode(const FrictionMode mode)
  {
    const bool other = mode != mode_;
    mode_            = mode;
    return other;
  }

  void StickSlip::begin(const SurfaceInteraction &interaction,
                        const double              step,
                        std::vector<PointList>   &lists)
  {
    acts_ = interaction.friction != nullptr && mode_ != FrictionMode::none;
    step_ = step;
    for (PointList &list : lists)
      list.anchors.resize(acts_ ? list.points.size() : 0);
  }

  void StickSlip::use_restored(std::vector<PointList> &lists)
  {
    if (!acts_ || restored_.empty())
      return;
    for (PointList &list : lists)
      place_anchors(restored_, list);
    restored_.clear();
  }

  void StickSlip::open_anchor(PointList &list, const unsigned int point, const bool located)
  {
    ContactAnchor    &anchor = list.anchors[point];
    const Projection &p      = list.points[point].projection;
    if (mode_ == FrictionMode::follows)
      {
        // The spring lets go, after its force has acted on half of the way since the evaluation
        // before, as all forces of central differences do.
        list.released += anchor.energy;
        if (located && anchor.elastic > 0. && step_ > 0.)
          {
            const ListedPoint &opened = list.points[point];
            const TangentBasis basis(surfaces_.master,
                                     p,
                                     surfaces_.slave.position(opened.slave_facet,
                                                              opened.rule_point),
                                     surfaces_.normal(p));
            const Vector3      way     = slip_way(opened, basis, step_);
            SurfaceGeometry   &master  = surfaces_.master;
            const Vector3      stretch = master.state(p.facet).position(p.xi, p.eta) - way -
                                    master.state(anchor.facet).position(anchor.xi, anchor.eta);
            list.released += anchor.energy / (anchor.elastic * anchor.elastic) * stretch.dot(way);
          }
        anchor = ContactAnchor();
      }
    else if (located && !anchor.holds())
      {
        // Where a load step begins, for points that may come to touch within it.
        anchor.facet = p.facet;
        anchor.xi    = p.xi;
        anchor.eta   = p.eta;
      }
  }

  Vector3
  StickSlip::slip_way(const ListedPoint &point, const TangentBasis &basis, const double time) const
  {
    Vector3 way = Vector3::Zero();
    if (!(time > 0.))
      return way;
    // The velocity on which a tangential force and what balances its moment work.
    const SurfaceGeometry &of_slave  = surfaces_.slave.surface();
    const SurfaceGeometry &of_master = surfaces_.master;
    const auto             weights   = bilinear_weights(point.projection.xi, point.projection.eta);
    const auto            &shape     = surfaces_.slave.rule()[point.rule_point].shape;
    const auto            &slave     = of_slave.corners(point.slave_facet);
    const auto            &master    = of_master.corners(point.projection.facet);
    const Vector3          along     = basis.dual_xi.normalized();
    const Vector3          across    = basis.normal.cross(along);
    for (const Vector3 &direction : {along, across})
      {
        double speed = 0.;
        for (unsigned int k = 0; k < 4; ++k)
          speed += shape[k] * direction.dot(of_slave.velocity(slave[k])) +
                   (basis.couple_share(direction, k) * basis.normal - weights[k] * direction)
                     .dot(of_master.velocity(master[k]));
        way += time * speed * direction;
      }
    return way;
  }

  FrictionForce StickSlip::stick(PointList                &list,
                                 const Touch              &touch,
                                 const TouchingPoint      &touching,
                                 const SurfaceInteraction &interaction)
  {
    // 1. The displacement along the surface since the point came to stick, between two places of
    // the master: zero in any common rigid motion. A point that comes to touch does so on the way
    // since the evaluation before.
    const bool          follows = mode_ == FrictionMode::follows;
    const ListedPoint  &point   = list.points[touch.point];
    ContactAnchor      &anchor  = list.anchors[touch.point];
    const TangentBasis &basis   = touch.basis;
    const Projection   &p       = point.projection;
    SurfaceGeometry    &master  = surfaces_.master;
    if (!anchor.holds())
      {
        const Vector3 way = follows ? slip_way(point, basis, step_) : Vector3(Vector3::Zero());
        anchor.facet      = p.facet;
        anchor.xi         = p.xi - basis.dual_xi.dot(way);
        anchor.eta        = p.eta - basis.dual_eta.dot(way);
      }
    Vector3 displacement = master.state(p.facet).position(p.xi, p.eta) -
                           master.state(anchor.facet).position(anchor.xi, anchor.eta);
    displacement -= basis.normal.dot(displacement) * basis.normal;

    // 2. Spring and slider. At rest and in a search for an equilibrium nothing slips.
    const double k =
      std::min(touching.stiffness * interaction.tangential_penalty, interaction.tangential_limit);
    const FrictionLaw &law = *interaction.friction;
    const double speed = law.depends_on_speed() && follows ? slip_way(point, basis, 1.).norm() : 0.;
    const SliderResponse response =
      slide(law, {touching.pressure, speed, k, anchor.elastic}, displacement.norm());
    const Vector3 elastic = response.elastic_part * displacement;
    FrictionForce friction;
    friction.force  = (-k * touching.area) * elastic;
    friction.energy = response.energy * touching.area;

    // 3. In time the anchor follows a point that slides, at the distance that the spring keeps.
    if (follows)
      {
        friction.loss = response.loss * touching.area;
        if (response.slid > 0.)
          {
            anchor.facet = p.facet;
            anchor.xi    = p.xi - basis.dual_xi.dot(elastic);
            anchor.eta   = p.eta - basis.dual_eta.dot(elastic);
          }
        anchor.elastic = response.elastic;
        anchor.energy  = friction.energy;
      }
    return friction;
  }

  void StickSlip::append_anchors(const unsigned int          pass,
                                 const PointList            &list,
                                 std::vector<AnchorOfPoint> &anchors)
  {
    for (std::size_t i = 0; i < list.anchors.size(); ++i)
      if (list.anchors[i].holds())
        anchors.push_back({pass,
                           list.slave_group,
                           list.master_group,
                           list.points[i].slave_facet,
                           list.points[i].rule_point,
                           list.anchors[i]});
  }

  void StickSlip::renew_anchors(const std::vector<AnchorOfPoint> &anchors, PointList &list) const
  {
    if (!acts_)
      return;
    list.anchors.assign(list.points.size(), ContactAnchor());
    place_anchors(anchors, list);
  }

  void StickSlip::place_anchors(const std::vector<AnchorOfPoint> &anchors, PointList &list) const
  {
    if (anchors.empty())
      return;
    // By facet and point of the slave.
    std::unordered_map<std::size_t, const ContactAnchor *> by_point;
    for (const AnchorOfPoint &a : anchors)
      if (a.slave_group == list.slave_group && a.master_group == list.master_group)
        by_point[surfaces_.slave.number(a.slave_facet, a.rule_point)] = &a.anchor;
    for (std::size_t i = 0; i < list.points.size(); ++i)
      {
        const ListedPoint &point = list.points[i];
        const auto         found =
          by_point.find(surfaces_.slave.number(point.slave_facet, point.rule_point));
        if (found != by_point.end())
          list.anchors[i] = *found->second;
      }
  }
} // namespace vfife
