// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Tip chamfers: where flanks and paths of contact end, what is left of the top land, their entries,
// refusals.
#include "../read_entries.h"
#include "../refusal.h"
#include "../tests.h"
#include "paper_pair.h"

#include <vfife/gear/errors/flank_area.h>
#include <vfife/gear/unloaded_contact/tooth_form.h>
#include <vfife/gear/unloaded_contact/unloaded_contact.h>

using namespace vfife;

namespace
{
  GearPairOptions
  chamfered(GearPairOptions options, const std::string &pinion, const std::string &gear)
  {
    read_entries(options,
                 "subsection Pinion\n set tip chamfer = " + pinion +
                   "\nend\nsubsection Gear\n set tip chamfer = " + gear + "\nend\n");
    return options;
  }

  void check_flanks(const GearMember &member, const double chamfer)
  {
    const Blank &blank = member.blank();
    for (const double L : {blank.inner_cone_distance(), blank.outer_cone_distance})
      check_close(member.name() + ": end of the flank [mm]",
                  blank.flank_tip(L),
                  blank.addendum(L) - chamfer,
                  0.);
    check_close(member.name() + ": end of the area of the flank [mm]",
                FlankArea(member, FlankSide::concave).point_at({0., 1.})[1],
                blank.addendum(blank.inner_cone_distance()) - chamfer,
                1e-12);
  }

  /** The ends of the path are on tips: it ends where the chamfers start. */
  void check_path(const GearPair &pair, const GearPair &sharp)
  {
    const UnloadedContact contact(pair, MeshSide::drive);
    const auto            range = contact.path_range(),
               longer           = UnloadedContact(sharp, MeshSide::drive).path_range();
    check("chamfers shorten both ends of the path",
          range.first > longer.first && range.second < longer.second);
    for (const double end : {range.first, range.second})
      {
        const UnloadedContactPoint point  = contact.contact(contact.reference() + end, 0);
        const PairBorder           border = contact.nearest_border(point);
        const Blank               &blank = (border.on_pinion ? pair.pinion() : pair.gear()).blank();
        const Vector2             &L_h   = border.on_pinion ? point.pinion_L_h : point.gear_L_h;
        check("the path ends at a tip, not at the " + border.name(),
              border.border == FlankBorder::tip);
        check_close("height of its end over the pitch cone [mm]",
                    L_h[1],
                    blank.addendum(L_h[0]) - blank.tip_chamfer,
                    1e-6);
      }
  }

  /** The tip land loses both chamfers, in proportion to the transverse thickness. */
  void check_forms(const GearPair &pair, const GearPair &sharp)
  {
    const ToothForms forms = measure_tooth_forms(pair), before = measure_tooth_forms(sharp);
    bool             same = true;
    for (const bool is_pinion : {true, false})
      for (unsigned int i = 0; i < 3; ++i)
        {
          const GearMember   &member  = is_pinion ? pair.pinion() : pair.gear();
          const Blank        &blank   = member.blank();
          const ToothSection &section = (is_pinion ? forms.pinion : forms.gear)[i],
                             &other   = (is_pinion ? before.pinion : before.gear)[i];
          const double L              = section.cone_distance,
                       thickness      = member.tooth_thickness(L, blank.addendum(L));
          check_close(member.name() + ": tip land at the " + section.place + " [mm]",
                      section.tip_land,
                      other.tip_land * (1. - 2. * blank.tip_chamfer / thickness),
                      1e-12);
          same = same && section.thickness == other.thickness &&
                 section.root_clearance == other.root_clearance;
        }
    check("thickness and root clearance are the same", same);
    check("nothing is found wrong", forms.findings.causes().empty());
  }

  void check_entries()
  {
    // A proposal sets blanks, but no chamfers.
    GearPairOptions proposed;
    proposed.proposal.pinion_teeth = 17;
    proposed.proposal.gear_teeth   = 43;
    proposed.proposal.module       = 4.;
    const GearPairOptions options  = chamfered(proposed, "0.2 mm", "0.1 mm");
    options.check();
    const GearPairOptions completed = options.completed(), sharp = proposed.completed();
    check("chamfers of a proposed pair",
          completed.pinion.blank.tip_chamfer == .2 && completed.gear.blank.tip_chamfer == .1 &&
            completed.pinion.concave.radial_distance == sharp.pinion.concave.radial_distance);
    check("chamfers alone are no pair",
          has_text(message_of([] { chamfered({}, "0.2 mm", "0.1 mm").check(); }),
                   "expected a gear pair, got none"));

    print_refused_entry([] { chamfered(paper::options(), "3 mm", "0 mm").check(); });
    print_refused_entry([] { chamfered(paper::options(), "0 mm", "1.1 mm").check(); });
    check("a negative chamfer is refused", refuses([] {
            GearPairOptions negative        = paper::options();
            negative.gear.blank.tip_chamfer = -.1;
            negative.check();
          }));
    // The top land is 2.109 mm wide at the toe (as in tests/mesh/surface_layer): 0.4 of it.
    check("a chamfer that leaves too little top land is refused",
          has_text(entry_and_message_of(
                     [] { GearPair(chamfered(paper::options(), "1 mm", "0 mm")); }),
                   "Gear pair/Pinion/tip chamfer: expected at most 0.84 mm, because the top land "
                   "without chamfers is 2.109"));
  }
} // namespace

int main()
{
  const GearPair sharp(paper::options()), pair(chamfered(paper::options(), "0.3 mm", "0.2 mm"));
  check_flanks(sharp.pinion(), 0.);
  check_flanks(pair.pinion(), .3);
  check_flanks(pair.gear(), .2);
  check_path(pair, sharp);
  check_forms(pair, sharp);
  check_entries();
  return 0;
}
