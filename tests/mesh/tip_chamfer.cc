// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies with tip chamfers: where the flanks end, nodes and faces of the chamfers, also refined and
// under a surface layer, volumes against the prisms that the chamfers take away.

#include "../refusal.h"
#include "../tests.h"

#include "paper_members.h"
#include "sector_copies.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_meridian.h>
#include <vfife/mesh/gear/gear_section.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>

#include <map>

using namespace vfife;

namespace
{
  /** On the straight line from the end of the flank to the corner of the top land, which is the
   * sharp edge turned into the tooth by the arc c. */
  Vector3 place_on_chamfer(const GearMember &member, const FlankSide side, const Vector2 &L_h)
  {
    const double  c = member.blank().tip_chamfer, L = L_h[0], tip = member.blank().addendum(L);
    const Vector3 end  = member.flank_point(side, L, tip - c).position,
                  edge = member.flank_point(side, L, tip).position;
    const double turn  = (side == member.lower_side() ? c : -c) / std::hypot(edge[0], edge[1]);
    const double part  = (L_h[1] - tip + c) / c;
    return (1. - part) * end + part * (rotation_about(Vector3::UnitZ(), turn) * edge);
  }

  void check_side(const BodyMesh        &mesh,
                  const GearMember      &member,
                  const FlankSide        side,
                  const GearBodyOptions &options)
  {
    const bool         concave    = side == FlankSide::concave;
    const char        *flank      = concave ? surface_name::concave : surface_name::convex;
    const char        *chamfer    = concave ? node_set::concave_chamfer : node_set::convex_chamfer;
    const Blank       &blank      = member.blank();
    const unsigned int n_sectors  = mesh.structure.n_sectors(),
                       per_sector = mesh.triangulation.n_vertices() / n_sectors;
    double distance               = 0.;
    for (const unsigned int node : mesh.node_sets.at(chamfer))
      {
        const Vector3 x = rotation_about(Vector3::UnitZ(), -member.pitch() * (node / per_sector)) *
                          vertex(mesh, node);
        distance = largest_of(distance,
                              (x - place_on_chamfer(member, side, blank.coordinates_of(x))).norm());
      }
    // Refined nodes are straight in height and angle, beside the chord by less than l^2/(4 r): l =
    // 0.5 mm, r = 35 mm.
    const std::string name = member.name() + " " + chamfer;
    check_below(name + ": nodes on a plane chamfer [mm]",
                distance,
                options.refinements == 0 ? 1e-9 : 2e-3);

    double highest = -1.;
    for (const Vector3 &x : mesh.surfaces.at(flank).positions)
      {
        const Vector2 L_h = blank.coordinates_of(x);
        highest           = largest_of(highest, L_h[1] - blank.addendum(L_h[0]));
      }
    check_close(name + ": the flank ends below the tip by [mm]", -highest, blank.tip_chamfer, 1e-9);

    std::map<std::string, std::size_t> faces;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() != 0)
          ++faces[mesh.boundaries.at(face->boundary_id())];
    check(name + ": faces of chamfer and flank",
          faces[chamfer] ==
              std::size_t(n_sectors) * options.cells_lengthwise * (1u << 2 * options.refinements) &&
            faces[flank] == mesh.surfaces.at(flank).facets.size());
  }

  void check_mesh(const GearMember &member, const GearBodyOptions &options)
  {
    const auto mesh = make_gear_body(member, options);
    check_close(member.name() + ": cells",
                mesh->triangulation.n_active_cells(),
                options.n_cells(member.blank()),
                0.);
    check_copies(*mesh);
    const MeshQuality quality = compute_mesh_quality(mesh->triangulation);
    check(member.name() + ": quality",
          quality.least_determinant > 0. && quality.least_scaled_jacobian > .3);
    for (const FlankSide side : {FlankSide::concave, FlankSide::convex})
      check_side(*mesh, member, side, options);
  }

  /** Two prisms a tooth of the section c^2/2, but for curved flanks and sectors of circles: of the
   * order of c over the radius of curvature. */
  template <typename MemberOf>
  void check_prisms(const MemberOf &member_of, const GearBodyOptions &options)
  {
    const GearMember sharp  = member_of(0.);
    const double     volume = compute_true_integrals(sharp, options).volume;
    for (const double c : {.4, .2})
      {
        const double taken = volume - compute_true_integrals(member_of(c), options).volume;
        check_below(sharp.name() + ": volume of the chamfers",
                    taken / (sharp.blank().teeth * sharp.blank().face_width * c * c) - 1.,
                    c / 40.);
      }
  }

  void check_convergence(const GearMember &member, GearBodyOptions options)
  {
    const double exact = compute_true_integrals(member, options).volume;
    const auto   error = [&] {
      return compute_mesh_quality(make_gear_body(member, options)->triangulation).volume / exact -
             1.;
    };
    const double first  = error();
    options.refinements = 1;
    check_below(member.name() + ": volume", first, 3e-3);
    check_close(member.name() + ": volume converges with second order", error() / first, .25, .05);
  }
} // namespace

int main()
{
  const GearBodyOptions solid = coarse(pinion_body_defaults()), web = coarse(GearBodyOptions());
  const GearMember      pinion = paper::pinion(.3), gear = paper::gear(.3);
  check_mesh(pinion, solid);
  GearBodyOptions refined = solid;
  refined.refinements     = 1;
  check_mesh(pinion, refined);

  GearBodyOptions solid_layer = solid, web_layer = web;
  solid_layer.surface_layer = web_layer.surface_layer = .6;
  check_mesh(pinion, solid_layer);
  check_mesh(gear, web_layer);
  check_mesh(paper::pinion(.05), solid_layer); // far thinner than the layer

  check_prisms([](const double c) { return paper::pinion(c); }, solid);
  check_prisms([](const double c) { return paper::gear(c); }, web);
  check_convergence(pinion, solid);
  check("without chamfers none of their sets",
        make_gear_body(paper::pinion(), solid)->node_sets.count(node_set::concave_chamfer) == 0);
  check("chamfers wider than the top land are refused",
        refuses([&] { make_gear_body(paper::pinion(1.1), solid); }));
  return 0;
}
