// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Shape of the cells for every web of the paper in both directions, coarse and full template.

#include "../tests.h"

#include "paper_members.h"

#include <vfife/base/errors.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/mesh_quality.h>

#include <sstream>

using namespace vfife;

namespace
{
  // What the design asks for; measured are 0.54 (coarse) and 0.59 (full) at worst.
  constexpr double least_scaled_jacobian = .5;

  void
  check_shape(const std::string &name, const GearMember &member, const GearBodyOptions &options)
  {
    const MeshQuality quality =
      compute_mesh_quality(make_gear_body(member, options)->triangulation);
    check(name,
          quality.least_scaled_jacobian > least_scaled_jacobian && quality.least_determinant > 0.);
  }
  /**
   * Webs on the underside of the rim and fillets. Towards the apex a web at 55 or 70 deg would run
   * into the rim, and at 85 deg it leaves the underside at 14 deg: refused. Corner cells at the end
   * of a fillet have an angle of half an arc's step less than 180 deg: positive is asked for.
   */
  void check_attachment(const GearMember   &gear,
                        const WebAttachment attachment,
                        const WebDirection  direction,
                        const double        angle,
                        const double        thickness,
                        const double        fillet)
  {
    GearBodyOptions options   = coarse(GearBodyOptions());
    options.cells_lengthwise  = 6;
    options.web_attachment    = attachment;
    options.web_direction     = direction;
    options.web_angle         = angle * pi / 180.;
    options.web_thickness     = thickness;
    options.rim_fillet_radius = attachment == WebAttachment::toe ? .25 * fillet : fillet;
    options.hub_fillet_radius = 2. * fillet;
    std::ostringstream name;
    name << (attachment == WebAttachment::toe      ? "toe"
             : attachment == WebAttachment::middle ? "middle"
                                                   : "heel")
         << ", web " << thickness << " mm, " << angle << " deg, "
         << (direction == WebDirection::back ? "back" : "apex") << ", fillet " << fillet;
    const bool exists = attachment == WebAttachment::toe || direction == WebDirection::back;
    try
      {
        const MeshQuality quality =
          compute_mesh_quality(make_gear_body(gear, options)->triangulation);
        check(name.str(), exists && quality.least_determinant > 0.);
      }
    catch (const InputError &error)
      {
        check(name.str() + " refused", !exists && error.entry() == "gear/Body/web attachment");
      }
  }
} // namespace

int main()
{
  const GearMember gear = paper::gear(), pinion = paper::pinion();
  for (const auto direction : {WebDirection::back, WebDirection::apex})
    for (const double angle : {55., 70., 85.})
      for (const double thickness : {3.5, 5., 6.5})
        {
          GearBodyOptions options = coarse(GearBodyOptions());
          options.web_direction   = direction;
          options.web_angle       = angle * pi / 180.;
          options.web_thickness   = thickness;
          std::ostringstream name;
          name << "web " << thickness << " mm, " << angle << " deg, "
               << (direction == WebDirection::back ? "back" : "apex");
          check_shape(name.str(), gear, options);
        }

  GearBodyOptions without_web = coarse(GearBodyOptions());
  without_web.web             = WebKind::none;
  check_shape("gear without web", gear, without_web);
  check_shape("pinion", pinion, coarse(pinion_body_defaults()));

  const auto full_gear =
    compute_mesh_quality(make_gear_body(gear, GearBodyOptions())->triangulation);
  const auto full_pinion =
    compute_mesh_quality(make_gear_body(pinion, pinion_body_defaults())->triangulation);
  check("full pair: about 140,000 cells", full_gear.cells + full_pinion.cells == 140247);
  check("full pair: shape",
        full_gear.least_scaled_jacobian > .6 && full_pinion.least_scaled_jacobian > .6);
  check("full pair: least edge as the fillets have it",
        full_pinion.least_edge > .3 && full_gear.least_edge > .3);

  GearBodyOptions uncoarsened = coarse(GearBodyOptions());
  uncoarsened.cells_across    = 3;
  check_shape("web as fine as the teeth", gear, uncoarsened);

  for (const auto attachment : {WebAttachment::toe, WebAttachment::middle, WebAttachment::heel})
    for (const auto direction : {WebDirection::back, WebDirection::apex})
      for (const double angle : {55., 70., 85.})
        for (const double thickness : {3.5, 5., 6.5})
          for (const double fillet : {0., 2.})
            if (attachment != WebAttachment::toe || (fillet > 0. && thickness < 6.))
              check_attachment(gear, attachment, direction, angle, thickness, fillet);
  return 0;
}
