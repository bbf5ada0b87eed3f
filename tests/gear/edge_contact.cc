// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Edges beyond the ends of the path of contact against a search over points of the limited flanks;
// hand-over; transmission error with either member driving.
#include "../tests.h"
#include "gap_search.h"
#include "paper_pair.h"

#include <vfife/gear/unloaded_contact/contact_analysis.h>

#include <limits>

using namespace vfife;

/**
 * Lag of pair 0 from points alone: the least one over a grid of points of the pinion's limited
 * flank at which the gear's limited flank stands at the same (r, z).
 */
class LimitedFlanks
{
public:
  LimitedFlanks(const GearPair &pair, const MeshSide side)
    : pair_(pair)
    , side_(side)
    , one_(pair.pinion().blank())
    , two_(pair.gear().blank())
    , pinion_(pair.pinion().generated_flank(pair.pinion_side(side)))
    , gear_(pair.gear().generated_flank(pair.gear_side(side)))
  {
  }

  double least_lag(const double rot1) const
  {
    // lower right corner of the zone in both directions, then closer and closer about the best
    Vector2 low(one_.inner_cone_distance(), -3.5), high(one_.outer_cone_distance, 4.5), best = low;
    double  least = std::numeric_limits<double>::infinity();
    for (unsigned int round = 0; round < 14; ++round)
      {
        constexpr int n = 60;
        for (int i = 0; i <= n; ++i)
          for (int j = 0; j <= n; ++j)
            {
              Vector2 x(low[0] + (high[0] - low[0]) * i / n, low[1] + (high[1] - low[1]) * j / n);
              // the pinion's own tip is tried exactly, the gear's is met from inside
              x[1]             = std::min(x[1], one_.addendum(x[0]));
              const double lag = lag_at(x, rot1);
              if (lag < least)
                {
                  least = lag;
                  best  = x;
                }
            }
        const Vector2 half = (high - low) / 5.;
        low                = (best - half).cwiseMax(Vector2(one_.inner_cone_distance(), -3.5));
        high               = (best + half).cwiseMin(Vector2(one_.outer_cone_distance, 4.5));
      }
    return least;
  }

private:
  double lag_at(const Vector2 &x, const double rot1) const
  {
    constexpr double none   = std::numeric_limits<double>::infinity();
    const double     turned = rot1 + pair_.pinion().turn(pair_.pinion_side(side_));
    try
      {
        const GeneratedPoint point = pinion_.point_at(x[0], x[1]);
        if (point.s < pinion_.straight_start())
          return none;
        const Vector3 P   = pair_.pinion_placement(turned)(point.position);
        const Vector2 L_h = gear_.cone_coordinates(P);
        if (L_h[0] < two_.inner_cone_distance() || L_h[0] > two_.outer_cone_distance ||
            L_h[1] > two_.addendum(L_h[0]) || L_h[1] < -3.8)
          return none;
        const GeneratedPoint gear = gear_.point_at(L_h[0], L_h[1]);
        if (gear.s < gear_.straight_start())
          return none;
        const MeanContact &mean = pair_.mean_contact(side_);
        const double       rot2 =
          std::remainder(polar_angle(P) - polar_angle(gear.position) - mean.rot2, 2. * pi);
        const double deviation = rot2 + pair_.speed_ratio() * (turned - mean.rot1);
        return side_ == MeshSide::drive ? deviation : -deviation;
      }
    catch (const std::exception &)
      {
        return none;
      }
  }

  const GearPair &pair_;
  MeshSide        side_;
  Blank           one_, two_;
  const Flank    &pinion_, &gear_;
};

/** @p reach: how far beyond its ends the path is looked at [pitches]. */
void check_edges(const std::string &name,
                 const GearPair    &pair,
                 const MeshSide     side,
                 const double       reach = .2)
{
  const PairContact   contact(pair, side);
  const LimitedFlanks search(pair, side);
  for (const unsigned int end : {0u, 1u})
    {
      const EdgeContact &edge      = contact.edge(end);
      const std::string  here      = name + ", " + edge.border();
      const double       direction = end == 0 ? -1. : 1.;
      // the edge takes over smoothly: the same lag, and normals still opposite
      check_close(here + ": lag at the path's end [arcsec]",
                  edge.points().front().lag / arcsecond,
                  contact.lag(contact.path()[end]) / arcsecond,
                  1e-6);
      double worst = 0.;
      for (const double beyond : {.15 * reach, .5 * reach, reach})
        {
          const double p    = contact.path()[end] + direction * beyond;
          const double rot1 = contact.flanks().reference() + p * contact.flanks().pitch();
          raise_to(worst, std::abs(contact.lag(p) - search.least_lag(rot1)) / arcsecond);
          check(here + ": carries later than the flank that is not there",
                contact.lag(p) > contact.flanks().contact(rot1, 0).lag);
        }
      // the grid meets the gear's tip from inside only
      check_below(here + ": lag against the search [arcsec]", worst, 0.02);
    }
}

/** What drives and how it turns only decides side and sense. */
void check_driving(const GearPair &pair)
{
  ContactAnalysisOptions options;
  const auto errors = [&](const DrivingMember driving, const TurningDirection direction) {
    options.driving   = driving;
    options.direction = direction;
    const Table table = transmission_table(pair, options);
    return std::make_pair(table.numbers("driver angle"), table.numbers("transmission error"));
  };
  const auto forward = errors(DrivingMember::pinion, TurningDirection::forward);
  const auto back    = errors(DrivingMember::gear, TurningDirection::reverse);
  check("two pitches", forward.first.size() == 41 && back.first.size() == 41);
  // both on the drive side: the same positions, passed the other way round
  const double ratio = pair.speed_ratio();
  double       worst = 0., worst_angle = 0.;
  for (unsigned int i = 0; i < 41; ++i)
    {
      const double lag = -forward.second[40 - i];
      raise_to(worst, std::abs(back.second[i] + lag / ratio));
      raise_to(worst_angle,
               std::abs(back.first[i] - (-ratio * forward.first[40 - i] + lag / 3600.)));
    }
  check_below("driving gear: lag of the pinion at its own axis [arcsec]", worst, 1e-9);
  check_below("driving gear: angle [deg]", worst_angle, 1e-12);
  // kinematics without the table: gear held to its angle, pinion turned until it touches
  const auto            coast = errors(DrivingMember::gear, TurningDirection::forward);
  const UnloadedContact contact(pair, MeshSide::coast);
  const double          p = 0.3, rot1 = contact.reference() + p * contact.pitch();
  const double          lag = contact.touching(rot1).lag;
  check_close("driving gear forward: coast side [arcsec]",
              coast.second[20 + 6],
              -lag / ratio / arcsecond,
              1e-6);
  check("the driven member lags",
        *std::max_element(coast.second.begin(), coast.second.end()) < 1e-6);
}

int main()
{
  const GearPair pair(paper::options());
  check_edges("drive", pair, MeshSide::drive);
  check_edges("coast", pair, MeshSide::coast);
  check_driving(pair);

  // A pinion so short that the path leaves it at toe and heel.
  GearPairOptions narrow                  = paper::options();
  narrow.pinion.blank.face_width          = 8.;
  narrow.pinion.blank.outer_cone_distance = narrow.pinion.blank.mean_cone_distance + 4.;
  const GearPair short_pair(narrow);
  check_edges("short pinion", short_pair, MeshSide::drive, .06);
  const PairContact short_contact(short_pair, MeshSide::drive);
  check_close("short pinion: one pair of teeth carries alone [arcsec]",
              short_contact.least_lag(-.2) / arcsecond,
              LimitedFlanks(short_pair, MeshSide::drive)
                  .least_lag(short_contact.flanks().reference() -
                             .2 * short_contact.flanks().pitch()) /
                arcsecond,
              .02);

  // At the ends of its path the pair a pitch nearer to the middle carries.
  const ContactAnalysis short_analysis =
    analyse_contact(short_pair, MeshSide::drive, ContactAnalysisOptions());
  for (const unsigned int end : {0u, 1u})
    {
      const PathEnd &here = short_analysis.ends[end];
      const double   rot1 = short_contact.flanks().reference() +
                          (here.place + (end == 0 ? 1. : -1.)) * short_contact.flanks().pitch();
      check_close("short pinion, " + here.border + ": approach before edge contact [arcsec]",
                  here.approach / arcsecond,
                  (here.lag - LimitedFlanks(short_pair, MeshSide::drive).least_lag(rot1)) /
                    arcsecond,
                  .01);
    }

  // misaligned so far that the path leaves the flanks before the next pair takes over
  GearPairOptions options    = paper::options();
  options.pinion_axial_shift = .1;
  const GearPair        shifted(options);
  const ContactAnalysis a = analyse_contact(shifted, MeshSide::drive, ContactAnalysisOptions());
  check("shifted: transfer on an edge", a.hands_over && a.over_an_edge);
  const LimitedFlanks   search(shifted, MeshSide::drive);
  const UnloadedContact contact(shifted, MeshSide::drive);
  for (const int k : {0, -1})
    check_close("shifted: lag at the transfer point, pair " + std::to_string(k) + " [arcsec]",
                search.least_lag(contact.reference() + (a.hand_over + k) * contact.pitch()) /
                  arcsecond,
                a.hand_over_lag / arcsecond,
                0.02);
  return 0;
}
