// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Ease-off against the lag of the tooth contact analysis, backlash, forms of teeth, and what is
// said about teeth that cannot be.
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/base/errors.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/gear/unloaded_contact/tooth_form.h>

using namespace vfife;

/** Ease-off on the contact line of the conjugate flank at @p pitches, at cone distance L. */
double
on_contact_line(const GearPair &pair, const MeshSide side, const double pitches, const double L)
{
  // along L = const the pitches grow or fall with h all the way: bisection
  double     low = -3.3, high = 1.5;
  const auto ahead = [&](const double h) {
    return measure_ease_off(pair, side, {L, h}).pitches - pitches;
  };
  const bool grows = ahead(high) > ahead(low);
  for (unsigned int i = 0; i < 50; ++i)
    ((ahead((low + high) / 2) > 0.) == grows ? high : low) = (low + high) / 2;
  return measure_ease_off(pair, side, {L, (low + high) / 2}).ease_off;
}

/** The least ease-off on a contact line, over the arm, is the lag there. */
void check_ease_off(const GearPair &pair, const MeshSide side)
{
  const UnloadedContact contact(pair, side);
  const MeanContact    &mean = pair.mean_contact(side);
  check_below(side_name(side) + ": ease-off at the mean contact [mm]",
              std::abs(measure_ease_off(pair, side, mean.gear_L_h).ease_off),
              1e-11);
  for (const double p : {-0.5, 0.5})
    {
      const auto   point = contact.contact(contact.reference() + p * contact.pitch(), 0);
      const double arm   = std::abs(point.position.cross(point.normal)[2]);
      double       least = 1.;
      // golden section would do; steps of 0.02 mm miss the least by k 1e-4/2 mm^2 = 2e-8 mm
      for (double L = point.gear_L_h[0] - 1.5; L < point.gear_L_h[0] + 1.5; L += 0.02)
        least = std::min(least, on_contact_line(pair, side, p, L));
      // The flanks touch a little beside that line: with the relative curvature k of line contact
      // across it and that of the ease-off c, the gap there is less by c/k < 1 %.
      check(side_name(side) + ": least ease-off on a contact line is arm times lag, within c/k",
            least > arm * point.lag && least < 1.01 * arm * point.lag);
    }
}

void check_forms(const GearPair &pair)
{
  const ToothForms forms = measure_tooth_forms(pair);
  check_close("backlash [mm]", forms.backlash, 0.12, 2e-4); // the touching flanks lag by an arcsec
  const double gear[] = {2.690, 3.171, 3.486}, pinion[] = {4.756, 5.448, 6.157};
  for (unsigned int i = 0; i < 3; ++i)
    {
      check_close("gear thickness at the " + forms.gear[i].place,
                  forms.gear[i].thickness,
                  gear[i],
                  6e-4);
      check_close("pinion thickness at the " + forms.pinion[i].place,
                  forms.pinion[i].thickness,
                  pinion[i],
                  6e-4);
    }
  bool lands = true, clear = true;
  for (const auto *member : {&forms.pinion, &forms.gear})
    for (const ToothSection &section : *member)
      {
        lands = lands && section.tip_land > 1.6 && section.tip_land < 2.;
        // blank: 3.94 - 3.34 and 1.91 - 1.32
        clear = clear && section.root_clearance > 0.58 && section.root_clearance < 0.61 &&
                section.fillet_distance > 0. && section.regularity > 0.;
      }
  check("tip lands", lands);
  check("root clearance, no fillet interference, no undercut", clear);
  check("nothing is found wrong", forms.findings.causes().empty());
}

/** Findings of a changed pair, by entry. */
std::string found(const std::function<void(GearPairOptions &)> &change)
{
  GearPairOptions options = paper::options();
  change(options);
  const ToothForms forms = measure_tooth_forms(GearPair(options));
  std::string      list;
  for (const Findings::Cause &cause : forms.findings.causes())
    list += (list.empty() ? "" : ", ") + cause.entry;
  return list;
}

int main()
{
  const GearPair pair(paper::options());
  check_ease_off(pair, MeshSide::drive);
  check_ease_off(pair, MeshSide::coast);
  check_forms(pair);
  std::cout << "large edge radii on the pinion: " << found([](GearPairOptions &o) {
    o.pinion.concave.edge_radius = 0.9;
    o.pinion.convex.edge_radius  = 0.9;
  }) << std::endl;
  std::cout << "mating tips too high: "
            << found([](GearPairOptions &o) { o.gear.blank.mean_addendum = 1.9; }) << std::endl;
  return 0;
}
