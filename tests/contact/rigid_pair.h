// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_contact_rigid_pair_h
#define vfife_tests_contact_rigid_pair_h

#include "surfaces.h"

#include <vfife/gear/unloaded_contact/unloaded_contact.h>
#include <vfife/mesh/gear/gear_body.h>

/** A meshed pair whose bodies turn as rigid ones until their flanks touch. */
namespace rigid_pair
{
  using namespace vfife;

  constexpr unsigned int positions_per_pitch = 16;

  /** Cells of a body that has flanks and little else. */
  inline GearBodyOptions
  flanks_alone(GearBodyOptions options, const unsigned int lengthwise, const unsigned int rows)
  {
    options.web              = WebKind::none;
    options.cells_across     = 2;
    options.rim_rows         = 1;
    options.cells_lengthwise = lengthwise;
    options.flank_rows       = rows;
    return options;
  }

  inline FacetSurface
  flanks_of(const GearGeometry &gear, const GearBodyOptions &options, const FlankSide side)
  {
    return make_gear_body(gear, options)
      ->surfaces.at(side == FlankSide::concave ? "concave" : "convex");
  }

  /** Lag of the gear [arcsec] at a turn of the pinion from the mean contact: the rotation at which
   * the smallest gap is zero; NaN where there is none. */
  inline double find_lag(const GearPair               &pair,
                         const MeshSide                side,
                         const double                  turn,
                         test_surfaces::MovingSurface &slave,
                         test_surfaces::MovingSurface &master,
                         Contact                      &contact)
  {
    const MeanContact &mean = pair.mean_contact(side);
    slave.place(
      pair.pinion_placement(mean.rot1 - pair.pinion().turn(pair.pinion_side(side)) + turn));
    const double rigid = mean.rot2 - turn * pair.speed_ratio();
    const double sign  = side == MeshSide::drive ? 1. : -1.;
    const auto   gap   = [&](const double lag) {
      master.place(pair.gear_placement(rigid + sign * lag));
      contact.find_candidates(slave.body, master.body, 0.3);
      return contact.smallest_gap(slave.motion(), master.motion(), 0.1).gap;
    };
    // secant method from two angles near the touch
    double a = 0., b = 20. * arcsecond, gap_a = gap(a), gap_b = gap(b);
    for (unsigned int k = 0; k < 12 && std::abs(gap_b) > 1e-9; ++k)
      {
        const double next = b - gap_b * (b - a) / (gap_b - gap_a);
        a                 = b;
        gap_a             = gap_b;
        b                 = next;
        gap_b             = gap(b);
      }
    return std::abs(gap_b) < 1e-7 ? b / arcsecond : std::nan("");
  }

  /** Lags [arcsec] over one pitch of the drive side; empty where the flanks do not touch. */
  inline std::vector<double> unloaded_lags(const GearPair          &pair,
                                           const UnloadedContact   &analysis,
                                           const FacetSurface      &pinion,
                                           const FacetSurface      &gear,
                                           const ContactSurfaceKind kind)
  {
    ContactOptions options;
    options.surface = kind;
    test_surfaces::MovingSurface slave(pinion), master(gear);
    Contact                      contact(pinion, gear, options);
    std::vector<double>          lags;
    for (unsigned int i = 0; i < positions_per_pitch; ++i)
      {
        const double turn = analysis.pitch() * (i + 0.5) / positions_per_pitch;
        lags.push_back(find_lag(pair, MeshSide::drive, turn, slave, master, contact));
        if (std::isnan(lags.back()))
          return {};
      }
    return lags;
  }
} // namespace rigid_pair

#endif
