// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The meshed reference pair with errors of manufacture, turned slowly without load: where the
// contact module lets its flanks touch, by the offsets of their facets, against the tooth contact
// analysis of the moved flanks; with errors that all teeth share, and with teeth of their own.
#include "../gear/paper_pair.h"
#include "../tests.h"
#include "rigid_pair.h"

#include <vfife/gear/unloaded_contact/unequal_teeth.h>

#include <fstream>

using namespace rigid_pair;

constexpr double um = 1e-3;

bool is_well_inside(const GearPair             &pair,
                    const UnloadedContact      &contact,
                    const UnloadedContactPoint &point)
{
  const FlankContact &flanks = contact.equations();
  for (const auto &distances :
       {border_distances(pair.pinion().blank(), flanks.pinion(), point.pinion, point.pinion_L_h),
        border_distances(pair.gear().blank(), flanks.gear(), point.gear, point.gear_L_h)})
    if (*std::min_element(distances.begin(), distances.end()) < .2)
      return false;
  return true;
}

/** What tooth contact analysis has for a whole mesh of tooth pairs, and the mesh. */
void compare(const std::string &name, const GearPairOptions &options, const bool equal)
{
  const GearPair pair(options);
  for (const MeshSide side : {MeshSide::drive, MeshSide::coast})
    {
      const FacetSurface pinion   = flanks_of(pair.pinion(),
                                            flanks_alone(pinion_body_defaults(), 12, 5),
                                            pair.pinion_side(side)),
                         gear     = flanks_of(pair.gear(),
                                          flanks_alone(GearBodyOptions(), 8, 5),
                                          pair.gear_side(side));
      const std::size_t per_tooth = gear.facets.size() / gear.n_groups;
      check(name + ", " + side_name(side) + ": rows of offsets as many as teeth differ",
            gear.offsets.size() ==
              (equal ? 1 : gear.n_groups) * per_tooth * gear.offset_points * gear.offset_points);
      test_surfaces::MovingSurface slave(pinion), master(gear);
      Contact                      contact(pinion, gear, ContactOptions());
      UnequalTeeth                 teeth(pair, side);
      unsigned int                 compared   = 0;
      double                       difference = 0., least = 1e9, most = -1e9;
      // tooth after tooth from anywhere on, forwards and a little backwards
      for (const double first : {-2., 0., 31.})
        for (unsigned int i = 0; i < 9; ++i)
          {
            const double          p        = first + (i + .5) / 6.;
            const auto            position = teeth.at(p);
            const UnloadedContact own(pair, side, position.pair);
            // the mesh knows no edges, feet beyond a border are none; next to it the least gap is
            // looked for with points on one side alone
            if (!is_well_inside(
                  pair, own, own.contact(own.reference() + (p + position.pair) * own.pitch(), 0)))
              continue;
            ++compared;
            const double lag   = position.lag / arcsecond;
            const double found = find_lag(pair, side, p * own.pitch(), slave, master, contact);
            raise_to(difference, std::abs(found - lag));
            least = std::min(least, lag);
            most  = std::max(most, lag);
          }
      check_below(name + ", " + side_name(side) + ": difference of the mesh [arcsec]",
                  difference,
                  .05); // measured: 0.003
      check(name + ", " + side_name(side) + ": enough of it on flanks", compared >= 15);
      check(name + ", " + side_name(side) + ": errors show", most - least > 3.);
    }
}

/** Deviations of 5 x 9 points, as a worn and twisted flank has. */
void write_grid(const std::string &file)
{
  std::ofstream out(file);
  for (int row = 4; row >= 0; --row)
    for (int column = 0; column < 9; ++column)
      {
        const double u = column / 8., v = row / 4.;
        out << 8. * std::sin(3. * u) * (v - .5) - 6. * (u - .6) * (u - .6) - 5. * v * v
            << (column < 8 ? ", " : "\n");
      }
}

int main()
{
  write_grid("grid.csv");
  GearPairOptions options;
  for (const bool of_gear : {true, false})
    {
      options                    = paper::options();
      MemberErrorOptions &errors = of_gear ? options.gear_errors : options.pinion_errors;
      for (FlankErrorOptions *flank : {&errors.concave, &errors.convex})
        {
          flank->terms      = {4. * um, -6. * um, 3. * um, 7. * um, 5. * um};
          flank->topography = "grid.csv";
          flank->margins    = {.05, .05};
        }
      compare(of_gear ? "form of the gear" : "form of the pinion", options, true);
    }

  options                                    = paper::options();
  options.gear_errors.eccentricity           = 15. * um;
  options.gear_errors.eccentricity_direction = 1.;
  options.gear_errors.wobble                 = 10. * um;
  options.pinion_errors.eccentricity         = 8. * um;
  options.pinion_errors.wobble               = 5. * um;
  options.pinion_errors.wobble_direction     = -2.;
  for (FlankErrorOptions *flank : {&options.gear_errors.concave, &options.gear_errors.convex})
    {
      flank->pitch_amplitude  = 10. * um;
      flank->pitch_order      = 9;
      flank->topography       = "grid.csv";
      flank->topography_teeth = {"1", "2", "78"};
      // the grid ends where nothing touches: it is constant beyond, with a kink
      flank->margins = {0., 0.};
    }
  compare("unequal teeth", options, false);
  return 0;
}
