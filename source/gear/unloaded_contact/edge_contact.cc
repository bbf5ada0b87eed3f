// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/newton.h>
#include <vfife/gear/unloaded_contact/edge_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    /** Steps in which an edge is followed, and how far at most: then other pairs carry long ago
     * [pitches]. */
    constexpr double edge_step = 0.01, farthest_edge = 0.5;

    /** Slack on the border that the edge itself is [mm]: Newton leaves 1e-12. */
    constexpr double on_border = 1e-9;
  } // namespace

  EdgeContact::EdgeContact(const GearPair             &pair,
                           const MeshSide              side,
                           const UnloadedContact      &flanks,
                           const UnloadedContactPoint &end,
                           const double                direction)
    : contact_(flanks.equations())
    , pinion_blank_(pair.pinion().blank())
    , gear_blank_(pair.gear().blank())
    , mean_(pair.mean_contact(side))
    , side_(side)
    , speed_ratio_(pair.speed_ratio())
    , turn_(pair.pinion().turn(pair.pinion_side(side)))
    , pitch_(pair.pinion().pitch())
  {
    // Which edge it is; over a fillet there is none.
    const PairBorder border = flanks.nearest_border(end);
    on_pinion_              = border.on_pinion;
    edge_                   = border.border;
    border_                 = border.name();
    if (edge_ == FlankBorder::fillet)
      return;

    // Outwards from the path's end in even steps with secant prediction, until Newton fails or a
    // point leaves the edge or the other flank.
    const double first = end.rot1 + turn_;
    Unknowns     x;
    x << end.pinion.t, end.pinion.phi, end.gear.t, end.gear.phi, end.rot2;
    Unknowns previous = x;
    for (unsigned int i = 0; i * edge_step <= farthest_edge; ++i)
      {
        const double   rotation = first + direction * i * edge_step * pitch_;
        const Unknowns last     = x;
        x += x - previous;
        if (!solve(rotation, x))
          return;
        previous                     = last;
        const EdgeContactPoint point = point_of(rotation, x);
        if (!is_on_flanks(point))
          return;
        points_.push_back(point);
        unknowns_.push_back(x);
        if (i == 0)
          previous = x; // the first step goes from the path's end onto the edge
      }
  }

  const std::string &EdgeContact::border() const
  {
    return border_;
  }

  const std::vector<EdgeContactPoint> &EdgeContact::points() const
  {
    return points_;
  }

  std::optional<EdgeContactPoint> EdgeContact::at(const double rot1) const
  {
    if (points_.empty())
      return {};
    const double low  = std::min(points_.front().rot1, points_.back().rot1),
                 high = std::max(points_.front().rot1, points_.back().rot1);
    if (rot1 < low || rot1 > high)
      return {};
    // Newton starts from the nearest of the points that were followed.
    const auto i = static_cast<std::size_t>(
      std::lround(std::abs(rot1 - points_.front().rot1) / (edge_step * pitch_)));
    Unknowns     x        = unknowns_[std::min(i, unknowns_.size() - 1)];
    const double rotation = rot1 + turn_;
    if (!solve(rotation, x))
      return {};
    return point_of(rotation, x);
  }

  double EdgeContact::edge_distance(const Vector2 &L_h) const
  {
    return edge_distances(on_pinion_ ? pinion_blank_ : gear_blank_,
                          L_h)[static_cast<unsigned int>(edge_)];
  }

  Vector2 EdgeContact::distance_gradient(const SurfaceDerivatives &d) const
  {
    const Blank &blank = on_pinion_ ? pinion_blank_ : gear_blank_;
    // edge_distance is linear in (L, h), and these are linear in (r, z)
    const Vector2 zero = Vector2::Zero();
    const Vector2 by_L_h(edge_distance({1., 0.}) - edge_distance(zero),
                         edge_distance({0., 1.}) - edge_distance(zero));
    const double  r     = d.point.position.head<2>().norm();
    const auto    along = [&](const Vector3 &change) {
      const double dr = d.point.position.head<2>().dot(change.head<2>()) / r;
      return by_L_h.dot(blank.cone_direction({dr, change[2]}));
    };
    return {along(d.position_t), along(d.position_phi)};
  }

  double EdgeContact::tangency(const double rotation, const Unknowns &x) const
  {
    // Along the edge g(t, phi) = 0 the tangent is g_t X_phi - g_phi X_t.
    const auto pinion = contact_.pinion().derivatives(x[0], x[1]),
               gear   = contact_.gear().derivatives(x[2], x[3]);
    const Matrix3 R1  = turned_frame(contact_.pinion_frame(), rotation).rotation,
                  R2  = turned_frame(contact_.gear_frame(), x[4]).rotation;
    const auto   &own = on_pinion_ ? pinion : gear;
    const Vector2 g   = distance_gradient(own);
    const Vector3 tangent =
      (on_pinion_ ? R1 : R2) * (g[0] * own.position_phi - g[1] * own.position_t).normalized();
    return tangent.dot(on_pinion_ ? Vector3(R2 * gear.point.normal)
                                  : Vector3(R1 * pinion.point.normal));
  }

  void EdgeContact::evaluate(const double    rotation,
                             const Unknowns &x,
                             Unknowns       &residual,
                             Jacobian       &jacobian) const
  {
    // Rows 0-2: the points coincide, by the equations of flank contact for the unknowns that are
    // free; the pinion's rotation is given.
    constexpr FlankContact::Unknown free[5] = {FlankContact::t1,
                                               FlankContact::phi1,
                                               FlankContact::t2,
                                               FlankContact::phi2,
                                               FlankContact::rot2};
    FlankContact::Unknowns          all, all_residual;
    FlankContact::Jacobian          all_derivatives;
    all[FlankContact::rot1] = rotation;
    for (unsigned int i = 0; i < 5; ++i)
      all[free[i]] = x[i];
    contact_.evaluate(all, all_residual, all_derivatives);
    residual.head<3>() = all_residual.head<3>();
    for (unsigned int i = 0; i < 5; ++i)
      jacobian.col(i).head<3>() = all_derivatives.col(free[i]).head<3>();

    // Row 3: the member's own point is on its edge, g = 0.
    const Flank             &flank  = on_pinion_ ? contact_.pinion() : contact_.gear();
    const unsigned int       first  = on_pinion_ ? 0 : 2;
    const SurfaceDerivatives own    = flank.derivatives(x[first], x[first + 1]);
    const double             length = (on_pinion_ ? pinion_blank_ : gear_blank_).mean_cone_distance;
    residual[3] = edge_distance(flank.cone_coordinates(own.point.position)) / length;
    jacobian.row(3).setZero();
    jacobian.block<1, 2>(3, first) = distance_gradient(own).transpose() / length;

    // Row 4: e . n = 0, the edge against the other flank.
    // Second derivatives of the flanks are not at hand: central differences, exact to 1e-10.
    constexpr double step = 1e-5;
    residual[4]           = tangency(rotation, x);
    for (unsigned int i = 0; i < 5; ++i)
      {
        const Unknowns change = step * Unknowns::Unit(i);
        jacobian(4, i) =
          (tangency(rotation, x + change) - tangency(rotation, x - change)) / (2. * step);
      }
  }

  bool EdgeContact::solve(const double rotation, Unknowns &x) const
  {
    return solve_newton<5>(
      [&](const Unknowns &trial, Unknowns &residual, Jacobian &jacobian) {
        evaluate(rotation, trial, residual, jacobian);
      },
      x);
  }

  EdgeContactPoint EdgeContact::point_of(const double rotation, const Unknowns &x) const
  {
    EdgeContactPoint point;
    point.rot1       = rotation - turn_;
    point.rot2       = x[4];
    point.lag        = mean_.lag(side_, speed_ratio_, rotation, x[4]);
    point.pinion     = contact_.pinion().evaluate(x[0], x[1]);
    point.gear       = contact_.gear().evaluate(x[2], x[3]);
    point.pinion_L_h = contact_.pinion().cone_coordinates(point.pinion.position);
    point.gear_L_h   = contact_.gear().cone_coordinates(point.gear.position);
    return point;
  }

  bool EdgeContact::is_on_flanks(const EdgeContactPoint &point) const
  {
    for (const auto &distances :
         {border_distances(pinion_blank_, contact_.pinion(), point.pinion, point.pinion_L_h),
          border_distances(gear_blank_, contact_.gear(), point.gear, point.gear_L_h)})
      for (const double distance : distances)
        if (distance < -on_border)
          return false;
    return true;
  }

  PairContact::PairContact(const GearPair          &pair,
                           const MeshSide           side,
                           const std::optional<int> teeth)
    : contact_(pair, side, teeth)
  {
    // the path on the flanks, then what edges add at either end
    const auto range = contact_.path_range();
    path_            = Vector2(range.first, range.second) / contact_.pitch();
    whole_           = path_;
    for (const unsigned int end : {0u, 1u})
      {
        edges_.emplace_back(pair,
                            side,
                            contact_,
                            contact_.contact(contact_.reference() + path_[end] * contact_.pitch(),
                                             0),
                            end == 0 ? -1. : 1.);
        if (!edges_.back().points().empty())
          whole_[end] =
            (edges_.back().points().back().rot1 - contact_.reference()) / contact_.pitch();
      }
  }

  const UnloadedContact &PairContact::flanks() const
  {
    return contact_;
  }

  const EdgeContact &PairContact::edge(const unsigned int end) const
  {
    return edges_[end];
  }

  const Vector2 &PairContact::path() const
  {
    return path_;
  }

  const Vector2 &PairContact::whole() const
  {
    return whole_;
  }

  double PairContact::lag(const double pitches) const
  {
    const double rot1 = contact_.reference() + pitches * contact_.pitch();
    if (pitches >= path_[0] && pitches <= path_[1])
      return contact_.contact(rot1, 0).lag;
    const auto point = edges_[pitches < path_[0] ? 0 : 1].at(rot1);
    return point ? point->lag : std::numeric_limits<double>::infinity();
  }

  double PairContact::least_lag(const double pitches) const
  {
    // pair 0 stands where pair k will stand k pitches later
    double least = std::numeric_limits<double>::infinity();
    for (int k = static_cast<int>(std::ceil(whole_[0] - pitches)); pitches + k <= whole_[1]; ++k)
      least = std::min(least, lag(pitches + k));
    return least;
  }
} // namespace vfife
