// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A layer of elements under flanks, fillets, tips and root lands: its thickness, the surface that
// it leaves as it was, and its refusal where the tooth is too thin.

#include "../refusal.h"
#include "../tests.h"

#include "paper_members.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_section.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/mesh/solid_integrals.h>

#include <algorithm>

using namespace vfife;

namespace
{
  Vector3 vertex(const BodyMesh &mesh, const unsigned int i)
  {
    const auto &x = mesh.triangulation.get_vertices()[i];
    return {x[0], x[1], x[2]};
  }

  /** Largest difference of the depth of moved profile points, normal to the true surface [mm]. */
  double error_of_depth(const GearMember &member, const double depth)
  {
    const Blank &blank = member.blank();
    double       worst = 0.;
    for (const double L : {blank.inner_cone_distance(), blank.outer_cone_distance})
      {
        const GearSection section = compute_gear_section(member, L, 3);
        const GearSection moved   = move_inward(member, section, default_fillet_corner, depth);
        for (const FlankSide side : {FlankSide::concave, FlankSide::convex})
          {
            const bool  lower   = side == member.lower_side();
            const auto &profile = lower ? section.lower : section.upper;
            const auto &inside  = lower ? moved.lower : moved.upper;
            for (unsigned int k = 0; k < profile.size(); ++k)
              {
                const SurfacePoint surface =
                  k < 2 ? member.fillet_point(side,
                                              L,
                                              k * default_fillet_corner * member.fillet_end(side))
                        : member.flank_point(side, L, profile[k][0]);
                const Vector3 x = position_of(blank, L, inside[k][0], inside[k][1]);
                worst = std::max(worst, std::abs(surface.normal.dot(x - surface.position) - depth));
              }
            worst = std::max(worst, std::abs(profile.back()[0] - inside.back()[0] - depth));
          }
      }
    return worst;
  }

  void check_body(const GearMember &member, GearBodyOptions options, const double depth)
  {
    const auto plain       = make_gear_body(member, options);
    options.surface_layer  = depth;
    const auto        mesh = make_gear_body(member, options);
    const std::string name = member.name() + ": ";
    check_close(name + "cells",
                mesh->triangulation.n_active_cells(),
                options.n_cells(member.blank()),
                0.);

    // All surfaces have the nodes that they have without a layer.
    for (const char *set : {surface_name::concave,
                            surface_name::convex,
                            node_set::concave_fillet,
                            node_set::convex_fillet,
                            node_set::tip,
                            node_set::root_land})
      {
        const auto &nodes = mesh->node_sets.at(set), &expected = plain->node_sets.at(set);
        double      distance = nodes.size() == expected.size() ? 0. : 1.;
        for (std::size_t i = 0; i < std::min(nodes.size(), expected.size()); ++i)
          {
            const Vector3 x     = vertex(*mesh, nodes[i]);
            double        least = 1.;
            for (const unsigned int node : expected)
              least = std::min(least, (vertex(*plain, node) - x).norm());
            distance = std::max(distance, least);
          }
        check_below(name + set + ", distance from the nodes without a layer [mm]", distance, 1e-9);
      }
    for (const char *side : {surface_name::concave, surface_name::convex})
      check(name + side + ": facets as without a layer",
            mesh->surfaces.at(side).facets == plain->surfaces.at(side).facets);
    for (const auto &[set, L] :
         {std::make_pair(node_set::toe, member.blank().inner_cone_distance()),
          std::make_pair(node_set::heel, member.blank().outer_cone_distance)})
      {
        const auto  &nodes = mesh->node_sets.at(set);
        unsigned int there = 0;
        for (const unsigned int node : nodes)
          there += std::abs(member.blank().coordinates_of(vertex(*mesh, node))[0] - L) < 1e-9;
        check(name + set + ": the layer's nodes too",
              there > plain->node_sets.at(set).size() / 2 &&
                nodes.size() > plain->node_sets.at(set).size());
      }
    const double volume = compute_solid_integrals(plain->triangulation).volume;
    check_close(name + "volume [mm^3]",
                compute_solid_integrals(mesh->triangulation).volume / volume,
                1.,
                1e-3);
    // Webs on the underside have distorted elements of their own.
    check(name + "scaled Jacobian",
          compute_mesh_quality(mesh->triangulation).least_scaled_jacobian >
            .85 * compute_mesh_quality(plain->triangulation).least_scaled_jacobian);
  }
} // namespace

int main()
{
  const GearMember pinion = paper::pinion(), gear = paper::gear();
  // The section is curved: the error falls with the square of the depth.
  const double error = error_of_depth(pinion, .6), half = error_of_depth(pinion, .3);
  check_below("error of the depth [mm]", error, .02);
  check_close("order of the error of the depth", std::log2(error / half), 2., .1);

  check_body(pinion, coarse(pinion_body_defaults()), .6);
  check_body(gear, coarse(GearBodyOptions()), .6);
  for (const WebAttachment place : {WebAttachment::middle, WebAttachment::heel})
    {
      GearBodyOptions options = coarse(GearBodyOptions());
      options.web_attachment  = place;
      check_body(gear, options, .6);
    }

  GearBodyOptions refined = coarse(pinion_body_defaults());
  refined.surface_layer   = .6;
  refined.refinements     = 1;
  check("refined: scaled Jacobian",
        compute_mesh_quality(make_gear_body(pinion, refined)->triangulation).least_scaled_jacobian >
          .4);

  GearBodyOptions thick = coarse(pinion_body_defaults());
  thick.surface_layer   = 1.5;
  print_refusal([&] { make_gear_body(pinion, thick); });
  return 0;
}
