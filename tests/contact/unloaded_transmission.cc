// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The meshed reference pair turned slowly without load: where the contact module lets the flanks
// touch, against the tooth contact analysis on the generated flanks, for what the facets stand for
// and three mesh densities. Bounds: measured values of doc/contact.md, rounded up.
#include "../gear/paper_pair.h"
#include "../tests.h"
#include "surfaces.h"

#include <vfife/gear/unloaded_contact/unloaded_contact.h>
#include <vfife/mesh/gear/gear_body.h>

#include <tuple>

using namespace test_surfaces;

namespace
{
  constexpr unsigned int positions_per_pitch = 16;

  struct Density
  {
    const char  *name;
    unsigned int gear_lengthwise, pinion_lengthwise, flank_rows;
    double       true_flank, smooth_patches, flat_facets; ///< bounds of the difference [arcsec]
  };

  /** Lags [arcsec] over one pitch, found as the gear's rotation at which the smallest gap is zero.
   */
  std::vector<double> unloaded_lags(const GearPair          &pair,
                                    const UnloadedContact   &analysis,
                                    const FacetSurface      &pinion,
                                    const FacetSurface      &gear,
                                    const ContactSurfaceKind kind)
  {
    ContactOptions options;
    options.surface = kind;
    MovingSurface       slave(pinion), master(gear);
    Contact             contact(pinion, gear, options);
    std::vector<double> lags;
    for (unsigned int i = 0; i < positions_per_pitch; ++i)
      {
        const double turn = analysis.pitch() * (i + 0.5) / positions_per_pitch;
        slave.place(pair.pinion_placement(pair.rot1_reference() + turn));
        const double rigid = pair.rot2_reference() - turn * pair.speed_ratio();
        const auto   gap   = [&](const double lag) {
          master.place(pair.gear_placement(rigid + lag));
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
        if (!(std::abs(gap_b) < 1e-7))
          return {};
        lags.push_back(b / arcsecond);
      }
    return lags;
  }
} // namespace

int main()
{
  const GearPair        pair(paper::options());
  const UnloadedContact analysis(pair);
  std::vector<double>   exact;
  for (unsigned int i = 0; i < positions_per_pitch; ++i)
    exact.push_back(
      analysis.touching(analysis.reference() + analysis.pitch() * (i + 0.5) / positions_per_pitch)
        .lag /
      arcsecond);

  for (const Density &density : {Density{"coarse", 4, 6, 3, 0.01, 0.11, 59.},
                                 Density{"middle", 8, 12, 5, 4e-4, 0.009, 17.},
                                 Density{"reference", 12, 18, 8, 1e-4, 0.002, 7.4}})
    {
      GearBodyOptions gear, pinion = pinion_body_defaults();
      gear.web                = WebKind::none;
      gear.cells_across       = 2;
      gear.rim_rows           = 1;
      gear.cells_lengthwise   = density.gear_lengthwise;
      gear.flank_rows         = density.flank_rows;
      pinion.cells_across     = 2;
      pinion.rim_rows         = 1;
      pinion.cells_lengthwise = density.pinion_lengthwise;
      pinion.flank_rows       = density.flank_rows;
      const auto surface_of   = [](const FlankSide side) {
        return side == FlankSide::concave ? "concave" : "convex";
      };
      const FacetSurface slave = make_gear_body(pair.pinion(), pinion)
                                   ->surfaces.at(surface_of(pair.pinion_side(MeshSide::drive)));
      const FacetSurface master =
        make_gear_body(pair.gear(), gear)->surfaces.at(surface_of(pair.gear_side(MeshSide::drive)));
      const std::tuple<const char *, ContactSurfaceKind, double> kinds[] = {
        {"true flank", ContactSurfaceKind::true_flank, density.true_flank},
        {"smooth patches", ContactSurfaceKind::smooth_patches, density.smooth_patches},
        {"flat facets", ContactSurfaceKind::flat_facets, density.flat_facets}};
      for (const auto &[name, kind, bound] : kinds)
        {
          const auto        lags = unloaded_lags(pair, analysis, slave, master, kind);
          const std::string what = std::string(density.name) + " mesh, " + name;
          check(what + ": the flanks touch everywhere", lags.size() == exact.size());
          double difference = 0.;
          for (std::size_t i = 0; i < lags.size(); ++i)
            difference = largest_of(difference, std::abs(lags[i] - exact[i]));
          check_below(what + ": difference from the generated flanks [arcsec]", difference, bound);
        }
    }
}
