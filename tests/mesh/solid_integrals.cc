// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Volume, centre and inertias: closed forms, and gear meshes that converge to the true body.

#include "../tests.h"

#include "paper_members.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_meridian.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

using namespace vfife;

void check_block()
{
  dealii::Triangulation<3> block;
  dealii::GridGenerator::subdivided_hyper_rectangle(block,
                                                    {2, 3, 2},
                                                    dealii::Point<3>(-2., -2., 1.),
                                                    dealii::Point<3>(2., 2., 7.));
  // a shear keeps the volume and moves the centre: cells are no boxes any more
  dealii::GridTools::transform(
    [](const dealii::Point<3> &p) {
      return dealii::Point<3>(p[0], p[1], p[2] + .3 * p[0] + .2 * p[1]);
    },
    block);
  const SolidIntegrals sum = compute_solid_integrals(block);
  check_close("block: volume", sum.volume, 96., 1e-12);
  check_close("block: centre", sum.centre(), 4., 1e-13);
  check_close("block: polar", sum.polar(), 96. * (16. + 16.) / 12., 1e-11);
  check_close("block: transverse",
              sum.transverse(),
              96. * (.5 * 32. + 36. + .13 * 16.) / 12.,
              1e-10);
}

void check_revolution()
{
  const double R = 5., r = 3., l = 4., V = pi * (R * R - r * r) * l;
  const auto   ring = compute_solid_integrals({{r, 1.}, {R, 1.}, {R, 1. + l}, {r, 1. + l}});
  check_close("ring: volume", ring.volume, V, 1e-12);
  check_close("ring: centre", ring.centre(), 3., 1e-14);
  check_close("ring: polar", ring.polar(), V * (R * R + r * r) / 2., 1e-11);
  check_close("ring: transverse",
              ring.transverse(),
              V * (3. * (R * R + r * r) + l * l) / 12.,
              1e-11);
  // a cone of radius R and height l, in the other sense
  const auto   cone = compute_solid_integrals({{0., l}, {R, 0.}, {0., 0.}});
  const double v    = pi * R * R * l / 3.;
  check_close("cone: volume", cone.volume, v, 1e-13);
  check_close("cone: centre", cone.centre(), l / 4., 1e-14);
  check_close("cone: polar", cone.polar(), .3 * v * R * R, 1e-12);
  check_close("cone: transverse", cone.transverse(), v * (12. * R * R + 3. * l * l) / 80., 1e-12);
}

SolidIntegrals of_mesh(const GearMember &member, GearBodyOptions options, const unsigned int n)
{
  options.refinements = n;
  return compute_solid_integrals(make_gear_body(member, options)->triangulation);
}

/** New nodes stand on the true surfaces, so differences fall to a quarter with each refinement;
 * what is left after extrapolating them is of fourth order. */
void check_convergence(const std::string     &name,
                       const GearMember      &member,
                       const GearBodyOptions &options,
                       const double           remainder)
{
  const SolidIntegrals exact = compute_true_integrals(member, options);
  const SolidIntegrals first = of_mesh(member, options, 0), second = of_mesh(member, options, 1);
  const auto           compare = [&](const std::string &what, const auto &value) {
    const double one = value(first) / value(exact) - 1., two = value(second) / value(exact) - 1.;
    check_below(name + ": " + what, one, 5e-3);
    check_below(name + ": " + what + ", refined", two, 1.4e-3);
    check_below(name + ": " + what + ", extrapolated", (4. * two - one) / 3., remainder);
  };
  compare("volume", [](const SolidIntegrals &s) { return s.volume; });
  compare("centre", [](const SolidIntegrals &s) { return s.centre(); });
  compare("polar inertia", [](const SolidIntegrals &s) { return s.polar(); });
  compare("transverse inertia", [](const SolidIntegrals &s) { return s.transverse(); });
}

/** Fillets of the web: their area in the meridian is known where wall and web meet at an angle.
 */
void check_web_fillets(const GearMember &gear)
{
  GearBodyOptions options;
  options.web_attachment    = WebAttachment::middle;
  const double sharp        = compute_true_integrals(gear, options).volume;
  options.hub_fillet_radius = 4.;
  const double round        = compute_true_integrals(gear, options).volume;
  // Between two lines at an angle a and the arc tangent to both: area t R - R^2 (pi - a)/2,
  // t = R/tan(a/2); its centroid is on the bisector, by Pappus within a mm of the hub.
  double       area = 0.;
  const double R    = options.hub_fillet_radius;
  for (const double a : {options.web_angle, pi - options.web_angle})
    area += R * R / std::tan(a / 2.) - R * R * (pi - a) / 2.;
  const double place = (round - sharp) / (2. * pi * area);
  check("hub fillets: area at a radius just outside the hub",
        place > options.hub_radius && place < options.hub_radius + 1.5);
}

int main()
{
  check_block();
  check_revolution();

  const GearMember gear = paper::gear(), pinion = paper::pinion();
  check_convergence("pinion", pinion, coarse(pinion_body_defaults()), 1e-5);
  GearBodyOptions options = coarse(GearBodyOptions());
  // The first row under the root leads from the teeth's toe to the mitre: a sliver of 13 mm^3 that
  // the true body has not.
  check_convergence("gear, web at the toe", gear, options, 5e-5);
  options.web_attachment   = WebAttachment::middle;
  options.cells_lengthwise = 6;
  check_convergence("gear, web in the middle", gear, options, 1e-5);
  options.web = WebKind::none;
  check_convergence("gear without web", gear, options, 1e-5);
  check_web_fillets(gear);
  return 0;
}
