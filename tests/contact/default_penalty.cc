// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Hertz's approach by the penalty that general models have by default, 5 E*/h of facets of width h,
// over the width of the contact: within 3 %, or as far off as a warning says. Two spheres whose
// meshes match or not; a cylinder on a block against a fine mesh of the same blocks; a flat punch.
#include "../tests.h"
#include "pressed_blocks.h"

#include <vfife/model/model.h>
#include <vfife/study/cases/contact_resolution.h>

#include <memory>
#include <tuple>

using namespace test_surfaces;

constexpr double radius = 50., approach = 0.04, line_approach = 0.035; // [mm]
const double     modulus = 20000. / (2. * (1. - 0.09));                // E* [MPa]

ContactOptions default_options(const double facet, const ContactSurfaceKind surface)
{
  ContactOptions options = with_penalty(5. * modulus / facet);
  options.surface        = surface;
  options.edge_fading    = 0.; // planes of symmetry are no edges
  return options;
}

/** What a warning says of facets of width @p h in a contact of this half-width, or 3 %. */
double find_limit(const double h, const double half_width, const ContactSurfaceKind surface)
{
  const double said =
    ContactResolution(ContactPair(), 2. * half_width, h).find_approach_error(surface);
  return std::max(.03, said);
}

/** The half-width of the contact is 1 mm. */
void spheres(const ContactSurfaceKind surface)
{
  const double hertz = 4. / 3. * modulus * std::sqrt(.5 * radius) * std::pow(approach, 1.5);
  for (const double other : {.8, 1., 1.25}) // cells of the other body
    for (const double h : {2., 1.33, 1., .67, .5, .33})
      {
        const ElasticBlock up  = round_body(false, radius, 1., h, 8., 1.5),
                           low = round_body(false, radius, -1., other * h, 8., 1.5);
        const Pressed pressed(up, low, default_options(h, surface), approach);
        check_below("spheres: approach, within what is said",
                    std::abs(std::pow(hertz / (4. * pressed.force), 2. / 3.) - 1.) /
                      find_limit(h, 1., surface),
                    1.);
      }
}

/** A square punch of half-width 1 mm and of this height on a large block. Rigid contact of the
 * same meshes has 76.96, 76.74 and 76.63 N with 6, 8 and 10 facets in the half-width: the limit
 * of first order is the reference. */
void punches()
{
  constexpr double limit = 76.13;           // [N], of a quarter
  for (const double other : {.8, 1., 1.25}) // cells of the block
    for (const unsigned int n : {1, 2, 3})
      {
        const double h = 1. / n;
        ElasticBlock punch;
        for (unsigned int i = 0; i <= n; ++i)
          punch.x.push_back(i * h);
        punch.y = punch.depth = punch.x;
        punch.radius          = 0.;
        punch.into            = 1.;
        punch.reach           = 2.;
        punch.plane_strain    = false;
        punch.free_sides      = true;
        punch.material        = soft_material();
        punch.build();
        const ElasticBlock low = round_body(false, 0., -1., other * h, 8., 1.5);
        const Pressed pressed(punch, low, default_options(h, ContactSurfaceKind::flat_facets), .01);
        check_below("punch: force at the approach, within what is said",
                    std::abs(pressed.force / limit - 1.) /
                      std::max(.03, ContactResolution(ContactPair(), 2., h).find_punch_error()),
                    1.);
      }
}

Pressed press_line(const double h, const ContactSurfaceKind surface)
{
  static std::vector<std::unique_ptr<ElasticBlock>> kept; // Pressed refers to them
  for (const auto &[into, cell, curvature] :
       {std::make_tuple(1., h, radius), std::make_tuple(-1., 1.25 * h, 0.)})
    kept.push_back(
      std::make_unique<ElasticBlock>(round_body(true, curvature, into, cell, 20., 1.25)));
  return {*kept[kept.size() - 2], *kept.back(), default_options(h, surface), line_approach};
}

/** The approach of a line contact depends on the depth of the blocks: a little less than in
 * proportion to the force. */
void lines(const ContactSurfaceKind surface)
{
  const Pressed fine  = press_line(.1, ContactSurfaceKind::smooth_patches);
  const double  width = fine.half_width;
  for (const double part : {1., .67, .5, .33})
    check_below("line: force at the approach, within what is said",
                std::abs(press_line(part * width, surface).force / fine.force - 1.) /
                  find_limit(part * width, width, surface),
                1.);
}

int main()
{
  for (const auto surface : {ContactSurfaceKind::flat_facets, ContactSurfaceKind::smooth_patches})
    {
      spheres(surface);
      lines(surface);
    }
  punches();
  return 0;
}
