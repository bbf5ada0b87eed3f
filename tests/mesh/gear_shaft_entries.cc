// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of shafts of gear bodies: size of the cells, levels asked for, what is refused.

#include "../read_entries.h"
#include "../refusal.h"
#include "../tests.h"

#include "paper_members.h"
#include "sector_copies.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_body_check.h>
#include <vfife/mesh/gear/gear_shaft_check.h>
#include <vfife/mesh/node_set_names.h>

#include <iostream>
#include <set>

using namespace vfife;

namespace
{
  /** Entries, and levels that are asked for. */
  void check_division(const GearGeometry &pinion)
  {
    GearBodyOptions options = coarse(pinion_body_defaults());
    check("no shaft by default",
          !options.shaft.present() &&
            make_gear_body(pinion, options)->node_sets.count(node_set::shaft) == 0);
    read_entries(options,
                 "subsection Shaft\n set sections = 80 200 40 20\n"
                 "set axial element size = 0.004 m\n set radial element size = 2.5\nend\n");
    options.shaft.levels  = {85.25, 150.125};
    const auto       mesh = make_gear_body(pinion, options);
    std::set<double> heights, radii;
    const auto       add = [](const double value, std::set<double> &values) {
      const auto next = values.lower_bound(value - 1e-9);
      if (next == values.end() || *next > value + 1e-9)
        values.insert(value);
    };
    for (const unsigned int node : mesh->node_sets.at(node_set::shaft_surface))
      add(vertex(*mesh, node)[2], heights);
    for (const unsigned int node : mesh->node_sets.at(node_set::shaft))
      add(vertex(*mesh, node).head<2>().norm(), radii);
    check("levels are ends of cells", heights.count(85.25) == 1 && heights.count(150.125) == 1);
    const Vector2 hub     = ends_of(*mesh, node_set::bore);
    double        longest = 0., widest = 0.;
    for (auto z = std::next(heights.begin()); z != heights.end(); ++z)
      if (*z <= hub[0] + 1e-9 || *std::prev(z) >= hub[1] - 1e-9)
        longest = largest_of(longest, *z - *std::prev(z));
    for (auto r = std::next(radii.begin()); r != radii.end(); ++r)
      widest = largest_of(widest, *r - *std::prev(r));
    check("axial cell size", longest <= 4. && longest > 3.);
    check("radial cell size", widest <= 2.5 && widest > 1.25);
  }

  /** @p text is refused, and so by name. */
  void refuse(const std::string         &what,
              const GearGeometry        &gear,
              GearBodyOptions            options,
              const std::string         &text,
              const std::vector<double> &levels = {})
  {
    options.shaft.text   = text;
    options.shaft.levels = levels;
    std::cout << what << ": ";
    print_refused_entry([&] {
      check_gear_body("Gear pair/Pinion", options, gear.blank());
      check_gear_shaft("Gear pair/Pinion/Shaft", gear, options);
    });
  }

  void check_refusals(const GearGeometry &gear, const GearGeometry &pinion)
  {
    GearBodyOptions body = coarse(pinion_body_defaults());
    refuse("solid", pinion, body, "80 200 40");
    refuse("no number", pinion, body, "80 200 40 x");
    refuse("crossing", pinion, body, "80 200 40 20, 190 210 35 15");
    refuse("a gap", pinion, body, "80 150 40 20, 151 200 40 20");
    refuse("an edge alone", pinion, body, "80 150 40 20, 150 200 20 10");
    refuse("beside the hub", pinion, body, "140 200 40 20");
    refuse("into the hub", pinion, body, "80 120 40 20");
    refuse("thicker", pinion, body, "80 200 41 20");
    refuse("two within", pinion, body, "80 110 40 20, 110 200 40 20");
    refuse("under the toe", pinion, body, "98 200 40 20, 97 98 60 20");
    refuse("onto the toe", pinion, body, "98 200 40 20, 94 98 80 20");
    refuse("level in the hub", pinion, body, "80 200 40 20", {120.});
    refuse("level beyond the end", pinion, body, "80 200 40 20", {201.});
    refuse("before the teeth", gear, coarse(GearBodyOptions()), "35 200 100 60, 30 35 220 60");
    body.web = WebKind::none;
    refuse("without a bore", pinion, body, "80 200 40 20");

    // Apart from the toe, whose face leans over the shaft.
    body            = coarse(pinion_body_defaults());
    body.shaft.text = "90 200 40 20, 85 90 70 20";
    check_gear_shaft("", pinion, body);
  }
} // namespace

int main()
{
  const GearMember gear = paper::gear(), pinion = paper::pinion();
  check_division(pinion);
  check_refusals(gear, pinion);
  return 0;
}
