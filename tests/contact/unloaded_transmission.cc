// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The meshed reference pair turned slowly without load: where the contact module lets the flanks
// touch, against the tooth contact analysis on the generated flanks, for what the facets stand for
// and three mesh densities. Bounds: measured values of doc/verification/geometry.md, rounded up.
#include "../gear/paper_pair.h"
#include "../tests.h"
#include "rigid_pair.h"

#include <tuple>

using namespace rigid_pair;

struct Density
{
  const char  *name;
  unsigned int gear_lengthwise, pinion_lengthwise, flank_rows;
  double       true_flank, smooth_patches, flat_facets; ///< bounds of the difference [arcsec]
};

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
      const FacetSurface slave = flanks_of(pair.pinion(),
                                           flanks_alone(pinion_body_defaults(),
                                                        density.pinion_lengthwise,
                                                        density.flank_rows),
                                           pair.pinion_side(MeshSide::drive));
      const FacetSurface master =
        flanks_of(pair.gear(),
                  flanks_alone(GearBodyOptions(), density.gear_lengthwise, density.flank_rows),
                  pair.gear_side(MeshSide::drive));
      const std::tuple<const char *, ContactSurfaceKind, double> kinds[] = {
        {"true flank", ContactSurfaceKind::true_flank, density.true_flank},
        {"smooth patches", ContactSurfaceKind::smooth_patches, density.smooth_patches},
        {"flat facets", ContactSurfaceKind::flat_facets, density.flat_facets}};
      for (const auto &[name, kind, bound] : kinds)
        {
          const auto        lags = unloaded_lags(pair, analysis, slave, master, kind);
          const std::string what = std::string(density.name) + " mesh, " + name;
          check(what + ": the flanks touch everywhere", lags.size() == exact.size());
          check_below(what + ": difference from the generated flanks [arcsec]",
                      largest_difference(lags, exact),
                      bound);
        }
    }
  return 0;
}
