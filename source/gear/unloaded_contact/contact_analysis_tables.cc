// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/gear/unloaded_contact/contact_analysis.h>

#include <cmath>

namespace vfife
{
  Table lag_table(const GearPair                     &pair,
                  const std::vector<ContactAnalysis> &sides,
                  const ContactAnalysisOptions       &options)
  {
    Table table;
    table.add_text_column("side");
    table.add_column("pitches", "-");
    // pairs 1, 0, -1 over p from -1 to 1: pair k stands where pair 0 will stand k pitches later
    table.add_column("pinion angle", "deg");
    table.add_column("pair", "-");
    table.add_column("lag", "arcsec");
    table.add_column("inside", "-");
    table.add_text_column("contact");
    const int n = static_cast<int>(options.points_per_pitch);
    for (const ContactAnalysis &analysis : sides)
      {
        const PairContact      whole(pair, analysis.side);
        const UnloadedContact &contact = whole.flanks();
        for (const int k : {1, 0, -1})
          {
            for (int i = -n; i <= n; ++i)
              {
                // the equations have solutions beyond the flanks; a little of that shows the curve
                const double pitches = i / static_cast<double>(n), own = pitches + k;
                if (own < whole.path()[0] - 0.1 || own > whole.path()[1] + 0.1)
                  continue;
                const double angle = pitches * contact.pitch();
                const auto   point = contact.contact(contact.reference() + angle, k);
                table.add_row({side_name(analysis.side),
                               pitches,
                               angle * 180. / pi,
                               k,
                               point.lag / arcsecond,
                               point.inside ? 1 : 0,
                               "flanks"});
              }
            // edges beyond both ends
            for (const unsigned int end : {0u, 1u})
              for (const EdgeContactPoint &point : whole.edge(end).points())
                {
                  const double angle   = point.rot1 - contact.reference() - k * contact.pitch();
                  const double pitches = angle / contact.pitch();
                  if (std::abs(pitches) <= 1.)
                    table.add_row({side_name(analysis.side),
                                   pitches,
                                   angle * 180. / pi,
                                   k,
                                   point.lag / arcsecond,
                                   1,
                                   whole.edge(end).border()});
                }
          }
      }
    return table;
  }

  Table transmission_table(const GearPair &pair, const ContactAnalysisOptions &options)
  {
    Table table;
    table.add_column("driver angle", "deg");
    table.add_column("transmission error", "arcsec");
    // the touching pair's lag over two pitches, seen from the driven member
    const PairContact contact(pair, options.working_side());
    const int         n     = static_cast<int>(options.points_per_pitch);
    const double      sense = options.direction == TurningDirection::forward ? 1. : -1.;
    const double      ratio = pair.speed_ratio();
    for (int i = -n; i <= n; ++i)
      {
        const double pitches = i / static_cast<double>(n);
        const double lag     = contact.least_lag(sense * pitches);
        const double turned  = pitches * contact.flanks().pitch(); // of the pinion
        if (!std::isfinite(lag))
          continue; // nothing touches: a gap in the curve
        // a driving gear is ahead of the exact ratio by the lag that the pinion has
        if (options.driving == DrivingMember::pinion)
          table.add_row({turned * 180. / pi, -lag / arcsecond});
        else
          table.add_row({(ratio * turned + lag) * 180. / pi, -lag / ratio / arcsecond});
      }
    return table;
  }

  Table path_table(const GearPair &pair, const std::vector<ContactAnalysis> &sides)
  {
    Table table;
    table.add_text_column("side");
    table.add_column("pitches", "-");
    table.add_column("lag", "arcsec");
    for (const std::string member : {"pinion", "gear"})
      {
        for (const char *coordinate : {" L", " h", " x", " y", " z"})
          table.add_column(member + coordinate, "mm");
        for (const char *axis : {" major L", " major h", " minor L", " minor h"})
          table.add_column(member + axis, "mm");
      }
    table.add_column("smaller relative curvature", "1/mm");
    table.add_column("larger relative curvature", "1/mm");
    table.add_column("semi-axis a", "mm");
    table.add_column("semi-axis b", "mm");
    table.add_column("major axis angle", "deg");
    for (const ContactAnalysis &analysis : sides)
      {
        const double turn1 = pair.pinion().turn(pair.pinion_side(analysis.side));
        const double turn2 = pair.gear().turn(pair.gear_side(analysis.side));
        for (const PathPoint &p : analysis.path)
          {
            const UnloadedContactPoint &point = p.contact;
            const Vector3 one = rotation_about(Vector3::UnitZ(), turn1) * point.pinion.position;
            const Vector3 two = rotation_about(Vector3::UnitZ(), turn2) * point.gear.position;
            const ContactEllipse &e = p.ellipse;
            table.add_row({side_name(analysis.side),
                           p.pitches,
                           point.lag / arcsecond,
                           point.pinion_L_h[0],
                           point.pinion_L_h[1],
                           one[0],
                           one[1],
                           one[2],
                           p.pinion_major[0],
                           p.pinion_major[1],
                           p.pinion_minor[0],
                           p.pinion_minor[1],
                           point.gear_L_h[0],
                           point.gear_L_h[1],
                           two[0],
                           two[1],
                           two[2],
                           p.gear_major[0],
                           p.gear_major[1],
                           p.gear_minor[0],
                           p.gear_minor[1],
                           e.relative_curvatures[0],
                           e.relative_curvatures[1],
                           e.semi_axes[0],
                           e.semi_axes[1],
                           p.major_angle * 180. / pi});
          }
      }
    return table;
  }
} // namespace vfife
