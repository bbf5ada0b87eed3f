// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/gear/unloaded_contact/unloaded_contact.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Farthest a tooth pair is followed from the mean contact [pitches]; no spiral bevel pair has
     * more overlap. */
    constexpr double farthest = 4.;

    /** Inside all four borders. */
    bool is_on_flank(const Blank          &blank,
                     const Flank          &flank,
                     const GeneratedPoint &point,
                     const Vector2        &L_h)
    {
      for (const double distance : border_distances(blank, flank, point, L_h))
        if (distance < 0.)
          return false;
      return true;
    }
  } // namespace

  std::array<double, 3> edge_distances(const Blank &blank, const Vector2 &L_h)
  {
    return {{L_h[0] - blank.inner_cone_distance(),
             blank.outer_cone_distance - L_h[0],
             blank.flank_tip(L_h[0]) - L_h[1]}};
  }

  std::array<double, 4> border_distances(const Blank          &blank,
                                         const Flank          &flank,
                                         const GeneratedPoint &point,
                                         const Vector2        &L_h)
  {
    const auto edges = edge_distances(blank, L_h);
    return {{edges[0], edges[1], edges[2], point.s - flank.straight_start()}};
  }

  std::string PairBorder::name() const
  {
    constexpr const char *names[] = {" toe", " heel", " tip", " fillet"};
    return (on_pinion ? "pinion" : "gear") + std::string(names[static_cast<unsigned int>(border)]);
  }

  std::pair<unsigned int, unsigned int>
  teeth_of_pair(const GearPair &pair, const MeshSide side, const int k)
  {
    const auto tooth = [](const int number, const unsigned int teeth) {
      const int z = static_cast<int>(teeth);
      return static_cast<unsigned int>((number % z + z) % z);
    };
    return {tooth(k, pair.pinion().blank().teeth),
            tooth(side == MeshSide::drive ? -k : 1 - k, pair.gear().blank().teeth)};
  }

  namespace
  {
    FlankContact
    make_contact(const GearPair &pair, const MeshSide side, const std::optional<int> &teeth)
    {
      if (!teeth)
        return pair.flank_contact(side);
      const auto numbers = teeth_of_pair(pair, side, *teeth);
      return pair.flank_contact(side, numbers.first, numbers.second);
    }
  } // namespace

  UnloadedContact::UnloadedContact(const GearPair          &pair,
                                   const MeshSide           side,
                                   const std::optional<int> teeth)
    : side_(side)
    , contact_(make_contact(pair, side, teeth))
    , pinion_blank_(pair.pinion().blank())
    , gear_blank_(pair.gear().blank())
    , mean_(pair.mean_contact(side))
    , speed_ratio_(pair.speed_ratio())
    , turn_(pair.pinion().turn(pair.pinion_side(side)))
  {
  }

  const FlankContact &UnloadedContact::equations() const
  {
    return contact_;
  }

  double UnloadedContact::pitch() const
  {
    return 2. * pi / pinion_blank_.teeth;
  }

  double UnloadedContact::reference() const
  {
    return mean_.rot1 - turn_;
  }

  bool UnloadedContact::find(const double rot1, const int pair, UnloadedContactPoint &point) const
  {
    // The generated flanks of all pairs are the same: this one touches as pair 0 does later.
    const double target  = rot1 + turn_ + pair * pitch();
    const double pitches = (target - mean_.rot1) / pitch();
    if (std::abs(pitches) > farthest)
      return false;

    FlankContact::Unknowns x = mean_.unknowns();
    if (!contact_.follow(target, x))
      return false;

    const double gear_pitch = 2. * pi / gear_blank_.teeth;
    // rotations of the members, and of the gear by whole pitches onto its own tooth
    point.pair       = pair;
    point.rot1       = rot1;
    point.rot2       = x[FlankContact::rot2] + pair * gear_pitch;
    point.lag        = mean_.lag(side_, speed_ratio_, target, x[FlankContact::rot2]);
    point.pinion     = contact_.pinion().evaluate(x[FlankContact::t1], x[FlankContact::phi1]);
    point.gear       = contact_.gear().evaluate(x[FlankContact::t2], x[FlankContact::phi2]);
    point.pinion_L_h = contact_.pinion().cone_coordinates(point.pinion.position);
    point.gear_L_h   = contact_.gear().cone_coordinates(point.gear.position);
    const RigidMotion placement = turned_frame(contact_.gear_frame(), x[FlankContact::rot2]);
    point.position              = placement(point.gear.position);
    point.normal                = -(placement.rotation * point.gear.normal);
    point.inside                = is_inside(point);
    return true;
  }

  bool UnloadedContact::is_inside(const UnloadedContactPoint &point) const
  {
    return is_on_flank(pinion_blank_, contact_.pinion(), point.pinion, point.pinion_L_h) &&
           is_on_flank(gear_blank_, contact_.gear(), point.gear, point.gear_L_h);
  }

  UnloadedContactPoint UnloadedContact::contact(const double rot1, const int pair) const
  {
    UnloadedContactPoint point;
    if (!find(rot1, pair, point))
      {
        std::ostringstream message;
        message << "unloaded tooth contact analysis: the flanks of tooth pair " << pair
                << " do not touch at pinion rotation " << rot1 << " rad";
        throw NumericalError(message.str());
      }
    return point;
  }

  UnloadedContactPoint UnloadedContact::touching(const double rot1) const
  {
    // pair k passes its mean contact at reference - k pitches; those within two pitches of it can
    // be inside
    const int            middle = static_cast<int>(std::lround((reference() - rot1) / pitch()));
    UnloadedContactPoint best, point;
    bool                 found = false;
    for (int pair = middle - 2; pair <= middle + 2; ++pair)
      if (find(rot1, pair, point) && point.inside && (!found || point.lag < best.lag))
        {
          best  = point;
          found = true;
        }
    if (!found)
      {
        std::ostringstream message;
        message << "unloaded tooth contact analysis: at pinion rotation " << rot1
                << " rad no tooth pair touches inside its flanks (edge contact)";
        throw NumericalError(message.str());
      }
    return best;
  }

  ContactEllipse UnloadedContact::ellipse(const UnloadedContactPoint &point,
                                          const double                separation) const
  {
    const double gear_pitch = 2. * pi / gear_blank_.teeth;
    // back to the rotations of the generated flanks
    FlankContact::Unknowns x;
    x << point.pinion.t, point.pinion.phi, point.rot1 + turn_ + point.pair * pitch(), //
      point.gear.t, point.gear.phi, point.rot2 - point.pair * gear_pitch;
    return contact_.ellipse(x, separation);
  }

  PairBorder UnloadedContact::nearest_border(const UnloadedContactPoint &point) const
  {
    // least distance over both flanks; a point beyond a border has a negative one
    const std::array<double, 4> distances[] = {
      border_distances(gear_blank_, contact_.gear(), point.gear, point.gear_L_h),
      border_distances(pinion_blank_, contact_.pinion(), point.pinion, point.pinion_L_h)};
    double     least = std::numeric_limits<double>::infinity();
    PairBorder nearest;
    for (const bool on_pinion : {true, false})
      for (unsigned int i = 0; i < 4; ++i)
        if (distances[on_pinion ? 1 : 0][i] < least)
          {
            least   = distances[on_pinion ? 1 : 0][i];
            nearest = {on_pinion, static_cast<FlankBorder>(i)};
          }
    return nearest;
  }

  std::pair<double, double> UnloadedContact::path_range() const
  {
    constexpr double     walk = 0.05, tolerance = 5e-14; // pitches
    UnloadedContactPoint point;
    const auto           inside = [&](const double pitches) {
      return find(reference() + pitches * pitch(), 0, point) && point.inside;
    };
    // with mounting errors the path need not hold the rotation of the mean contact
    double start = 0.;
    for (unsigned int i = 0; !inside(start); ++i)
      {
        start = (i % 2 == 0 ? 1. : -1.) * (i / 2 + 1) * walk;
        if (std::abs(start) > 2.)
          throw NumericalError("flanks of the " + side_name(side_) +
                               " side: no contact inside the flanks for the given Gear "
                               "pair/Mounting; only edge contact is possible");
      }
    const auto border = [&](const double direction) {
      // walk outwards to the first point outside, then bisect: beyond the border the flanks may not
      // even touch, so that no distance tells how far it is
      double in = start, out = start + walk * direction;
      for (; inside(out); out += walk * direction) // ends at the farthest that is followed
        in = out;
      const auto ends =
        boost::math::tools::bisect([&](const double pitches) { return inside(pitches) ? 1. : -1.; },
                                   std::min(in, out),
                                   std::max(in, out),
                                   [](const double a, const double b) {
                                     return b - a < tolerance;
                                   });
      const double last   = direction > 0. ? ends.first : ends.second;
      const double beyond = direction > 0. ? ends.second : ends.first;
      // Where the flanks do not even touch beyond, the last point keeps clear of round-off.
      constexpr double clear = 1e-9;
      return (find(reference() + beyond * pitch(), 0, point) ? last : last - clear * direction) *
             pitch();
    };
    return {border(-1.), border(1.)};
  }
} // namespace vfife
