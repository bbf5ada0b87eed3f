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

/**
 * Pinions of few teeth at high ratios: near the toe another sheet of the generated surface comes
 * close to the flank. A face width that is a little larger changes the teeth a little, and the
 * flank's normals turn steadily over the tooth.
 */
void check_few_teeth()
{
  const auto propose = [](const unsigned int pinion, const unsigned int gear, const double width) {
    GearPairOptions options;
    options.proposal.pinion_teeth = pinion;
    options.proposal.gear_teeth   = gear;
    options.proposal.module       = 3.;
    options.proposal.face_width   = width;
    return GearPair(options);
  };
  const ToothForms narrow = measure_tooth_forms(propose(8, 79, 35.)),
                   wide   = measure_tooth_forms(propose(8, 79, 35.4));
  check_close("8/79: tip land of the pinion at the toe [mm]", wide.pinion[0].tip_land, 1.03, .005);
  check_close("8/79: regularity there", wide.pinion[0].regularity, .088, .001);
  for (unsigned int i = 0; i < 3; ++i)
    check_close("8/79: tip land of both face widths at the " + wide.pinion[i].place + " [mm]",
                wide.pinion[i].tip_land,
                narrow.pinion[i].tip_land,
                .01);
  check("8/79: nothing is found wrong", wide.findings.causes().empty());
  for (const auto &teeth :
       {std::pair<unsigned int, unsigned int>(8, 79), {6, 60}, {7, 50}, {8, 60}})
    {
      const GearPair    pair   = propose(teeth.first, teeth.second, 0.);
      const GearMember &pinion = pair.pinion();
      const Blank      &blank  = pinion.blank();
      constexpr int     n = 20, m = 10;
      double            turn = 0.;
      bool              left = true;
      for (const FlankSide side : {FlankSide::concave, FlankSide::convex})
        for (int j = 0; j <= m; ++j)
          {
            Vector3 last = Vector3::Zero();
            for (int i = 0; i <= n; ++i)
              {
                const Flank &flank = pinion.generated_flank(side);
                const double L     = blank.inner_cone_distance() + i * blank.face_width / n;
                const double low =
                  flank.cone_coordinates(flank.fillet_at(L, pinion.fillet_end(side)).position)[1];
                const GeneratedPoint point =
                  flank.point_at(L, low + j * (blank.addendum(L) - low) / m);
                left = left && flank.is_left(point);
                if (i > 0)
                  turn = largest_of(turn, (point.normal - last).norm());
                last = point.normal;
              }
          }
      const std::string name = std::to_string(teeth.first) + "/" + std::to_string(teeth.second);
      check(name + ": all points are left by the cutter", left);
      check_below(name + ": turn of the normals over a twentieth of the face", turn, .2);
    }
}

int main()
{
  check_few_teeth();
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
