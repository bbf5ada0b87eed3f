// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Gear bodies: numbering, exact copies, closed boundary, node sets, volumes against integrals over
// the gear itself, refusals.

#include "../read_entries.h"
#include "../refusal.h"
#include "../tests.h"

#include "paper_members.h"
#include "sector_copies.h"

#include <vfife/mesh/gear/conical_web.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_body_check.h>
#include <vfife/mesh/gear/gear_section.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>

using namespace vfife;

namespace
{
  void check_boundary(const BodyMesh &mesh, const unsigned int faces_per_sector)
  {
    check(mesh.name + ": faces of the boundary",
          check_closed(mesh) == std::size_t(faces_per_sector) * mesh.structure.n_sectors());
  }

  /**
   * Volume of the gear between its true flanks, fillets of two chords, cones and the bottom: r dL
   * dh dtheta integrated over h in closed form, along the outer profile and over L numerically.
   */
  double exact_volume(const GearMember &member, const GearBodyOptions &options)
  {
    const Blank       &blank = member.blank();
    const double       c = std::cos(blank.pitch_angle), s = std::sin(blank.pitch_angle);
    constexpr unsigned sections = 40, points = 200;
    double             volume = 0.;
    for (unsigned int i = 0; i <= sections; ++i)
      {
        const double L       = blank.inner_cone_distance() + blank.face_width * i / sections;
        const auto   section = compute_gear_section(member, L, 1);
        const auto   radius  = [&](const double h) { return L * s + h * c; };
        const double bottom  = options.web == WebKind::solid
                                 ? options.bore_radius
                                 : radius(section.root_height - options.rim_thickness);
        const auto   R       = [&](const double h) {
          return (radius(h) * radius(h) - bottom * bottom) / (2. * c);
        };
        const auto flank = [&](const FlankSide side, const std::vector<Vector2> &ends) {
          std::vector<Vector2> profile;
          const auto           add = [&](const Vector3 &x) {
            const double angle = std::atan2(x[1], x[0]);
            profile.emplace_back(blank.cone_coordinates({std::hypot(x[0], x[1]), x[2]})[1],
                                 ends[0][1] + std::remainder(angle - ends[0][1], 2. * pi));
          };
          for (const double part : {0., .6, 1.}) // the mesh has these three points of the fillet
            add(member.fillet_point(side, L, part * member.fillet_end(side)).position);
          const double start = profile.back()[0], tip = blank.addendum(L);
          for (unsigned int k = 0; k <= points; ++k)
            add(member.flank_point(side, L, start + (tip - start) * k / points).position);
          return profile;
        };
        auto                 lower   = flank(member.lower_side(), section.lower);
        auto                 upper   = flank(member.upper_side(), section.upper);
        std::vector<Vector2> outline = {{section.root_height, section.left_angle}};
        outline.insert(outline.end(), lower.begin(), lower.end());
        outline.insert(outline.end(), upper.rbegin(), upper.rend());
        outline.emplace_back(section.root_height, section.left_angle + section.pitch);
        double area = 0.;
        for (unsigned int k = 0; k + 1 < outline.size(); ++k)
          area +=
            .5 * (R(outline[k][0]) + R(outline[k + 1][0])) * (outline[k + 1][1] - outline[k][1]);
        const double simpson = i == 0 || i == sections ? 1. : (i % 2 == 1 ? 4. : 2.);
        volume += simpson / 3. * blank.face_width / sections * area * blank.teeth;
      }
    return volume;
  }

  GearBodyOptions doubled(GearBodyOptions options)
  {
    options.cells_lengthwise *= 2;
    options.cells_across *= 2;
    options.flank_rows *= 2;
    options.rim_rows *= 2;
    return options;
  }

  /** The cells are inscribed into curved faces: a second-order difference, on top of fillets held
   * at two points. */
  void check_volume(const GearMember &member, const GearBodyOptions &options)
  {
    const double exact = exact_volume(member, options);
    const double first =
      compute_mesh_quality(make_gear_body(member, options)->triangulation).volume / exact - 1.;
    const double second =
      compute_mesh_quality(make_gear_body(member, doubled(options))->triangulation).volume / exact -
      1.;
    check_below(member.name() + ": volume, relative to the integral over sections", first, 3e-3);
    check_below(member.name() + ": volume with twice the cells", second, 1e-3);
    check_close(member.name() + ": volume converges with second order", second / first, .25, .03);
  }

  void check_web(const BodyMesh &mesh, const GearMember &member, const GearBodyOptions &options)
  {
    const Blank &blank   = member.blank();
    const auto   root_at = [&](const double L) {
      return compute_gear_section(member, L, options.flank_rows).root_height;
    };
    const ConicalWeb web(blank,
                         options,
                         root_at(blank.inner_cone_distance()),
                         root_at(blank.outer_cone_distance));
    const Vector2    along(-std::sin(options.web_angle), std::cos(options.web_angle));
    const Vector2    normal(along[1], -along[0]);
    const auto       offsets = [&](const char *name) {
      Vector2 range(1e9, -1e9);
      for (const unsigned int i : mesh.node_sets.at(name))
        {
          const Vector3 x = vertex(mesh, i);
          const double  offset =
            normal.dot(Vector2(std::hypot(x[0], x[1]), x[2]) - web.point(.3, .5));
          range = {std::min(range[0], offset), std::max(range[1], offset)};
        }
      return range;
    };
    const Vector2 front = offsets(node_set::web_front), back = offsets(node_set::web_back);
    check_below("web: front face is a straight cone", front[1] - front[0], 1e-12);
    check_below("web: back face is a straight cone", back[1] - back[0], 1e-12);
    check_close("web: thickness", std::abs(back[0] - front[0]), options.web_thickness, 1e-12);

    bool   node_A_right = true;
    double mean_z[2]    = {0., 0.};
    for (const bool is_back : {false, true})
      {
        const auto &nodes =
          mesh.node_sets.at(is_back ? node_set::node_A_back : node_set::node_A_front);
        const auto &face = mesh.node_sets.at(is_back ? node_set::web_back : node_set::web_front);
        node_A_right     = node_A_right && nodes.size() == mesh.structure.n_sectors();
        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            const Vector3 x = vertex(mesh, nodes[k]);
            node_A_right =
              node_A_right && std::abs(std::hypot(x[0], x[1]) - options.hub_radius) < 1e-12 &&
              nodes[k] / (mesh.triangulation.n_vertices() / mesh.structure.n_sectors()) == k &&
              std::binary_search(face.begin(), face.end(), nodes[k]);
            mean_z[is_back ? 1 : 0] += x[2] / nodes.size();
          }
      }
    check("web: node A, one a sector where the web meets the hub", node_A_right);
    check_close("web: node A faces",
                mean_z[1] - mean_z[0],
                options.web_thickness / std::sin(options.web_angle),
                1e-11);

    bool bore_right = true;
    for (const unsigned int i : mesh.node_sets.at(node_set::bore))
      bore_right =
        bore_right && std::abs(vertex(mesh, i).head<2>().norm() - options.bore_radius) < 1e-12;
    check("web: bore radius", bore_right);

    // Web and hub come last in a sector. Pappus for web and hub; chords of 3-column sectors
    // take 1.2e-4 of it.
    const unsigned int cells = mesh.triangulation.n_active_cells() / mesh.structure.n_sectors();
    const unsigned int rim_cells =
      options.cells_lengthwise *
      ((options.flank_rows + 1) * options.cells_across + options.rim_rows * options.columns());
    double volume = 0.;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      if (cell->active_cell_index() % cells >= rim_cells)
        volume += cell->measure();
    const Vector2 corners[4] = {web.point(0., 0.),
                                web.point(0., 1.),
                                web.point(1., 1.),
                                web.point(1., 0.)};
    double        exact      = 0.;
    for (unsigned int k = 0; k < 4; ++k)
      {
        const Vector2 &a = corners[k], &b = corners[(k + 1) % 4];
        exact +=
          pi / 3. * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) * (b[1] - a[1]); // divergence theorem
      }
    exact = std::abs(exact) +
            pi * options.hub_length *
              (options.hub_radius * options.hub_radius - options.bore_radius * options.bore_radius);
    check_below("web and hub: volume, relative to Pappus", volume / exact - 1., 4e-4);
  }

  template <typename Change>
  bool refuses(const GearMember &member, const Change &change)
  {
    GearBodyOptions options = coarse(GearBodyOptions());
    change(options);
    return entry_and_message_of([&] {
             check_gear_body("Gear pair/Gear", options, member.blank());
           }).find("Gear pair/Gear/") == 0;
  }

  void check_refusals(const GearMember &gear)
  {
    using Options = GearBodyOptions;
    check("accepts the default", !refuses(gear, [](Options &) {}));
    check("refuses a negative thickness", refuses(gear, [](Options &o) { o.web_thickness = -1.; }));
    check("refuses a web thicker than the rim",
          refuses(gear, [](Options &o) { o.web_thickness = 9.; }));
    check("refuses a web angle of 0", refuses(gear, [](Options &o) { o.web_angle = 0.; }));
    check("refuses a web that runs along the rim",
          refuses(gear, [](Options &o) { o.web_angle = .2; }));
    check("refuses a hub as wide as the rim",
          refuses(gear, [](Options &o) { o.hub_radius = 100.; }));
    check("refuses a bore as wide as the hub",
          refuses(gear, [](Options &o) { o.bore_radius = 60.; }));
    check("refuses a short hub", refuses(gear, [](Options &o) { o.hub_length = 4.; }));
    check("refuses a rim without thickness",
          refuses(gear, [](Options &o) { o.rim_thickness = 0.; }));
    check("refuses a tiny element size", refuses(gear, [](Options &o) { o.element_size = .01; }));
    check("refuses too few rim rows", refuses(gear, [](Options &o) { o.rim_rows = 3; }));
    check("refuses a solid body without metal", refuses(gear, [](Options &o) {
            o.web         = WebKind::solid;
            o.bore_radius = 95.;
          }));
  }

  /** Half the element size makes many more cells of a body of the same volume. */
  void check_element_size(const GearMember &member, GearBodyOptions options)
  {
    const std::string name = member.name() + ": element size";
    options.element_size   = 3.;
    const auto first       = compute_mesh_quality(make_gear_body(member, options)->triangulation);
    options.element_size   = 1.5;
    const auto second      = compute_mesh_quality(make_gear_body(member, options)->triangulation);
    // across tooth and web, counts are at their least values already: not eight times
    check(name + ", cells", second.cells > 3 * first.cells);
    check(name + ", cells not inverted",
          first.least_scaled_jacobian > .3 && second.least_scaled_jacobian > .3);
    check(name + ", volume", std::abs(second.volume / first.volume - 1.) < 5e-3);
  }

  void check_declaration(const GearMember &gear)
  {
    GearBodyOptions options;
    read_entries(options,
                 "subsection Body\n set web thickness = 3.5 mm\n set web inclination = 55\n"
                 "set web direction = towards apex\nend\n"
                 "subsection Mesh\n set elements along profile = 4\nend\n");
    check("options are read",
          options.web_thickness == 3.5 && std::abs(options.web_angle - 55. * pi / 180.) < 1e-15 &&
            options.web_direction == WebDirection::apex && options.flank_rows == 4 &&
            options.web == WebKind::conical);
    check_gear_body("Gear pair/Gear", options, gear.blank());
  }
} // namespace

int main()
{
  const GearMember      gear = paper::gear(), pinion = paper::pinion();
  const GearBodyOptions with_web = coarse(GearBodyOptions()),
                        solid    = coarse(pinion_body_defaults());
  GearBodyOptions without_web    = with_web;
  without_web.web                = WebKind::none;

  const auto gear_mesh   = make_gear_body(gear, with_web),
             pinion_mesh = make_gear_body(pinion, solid);
  check_copies(*gear_mesh);
  check_copies(*pinion_mesh);
  // tooth sides and tip, root lands and bottom along the length; the two ends
  check_boundary(*pinion_mesh, 6 * (2 * 4 + 2 + 4 + 6) + 2 * (4 * 2 + 3 * 6));
  const auto rim_mesh = make_gear_body(gear, without_web);
  check_boundary(*rim_mesh, 4 * (2 * 4 + 2 + 4 + 6) + 2 * (4 * 2 + 4 * 6));
  // less twice the web's ends, more web faces (8 in the coarsening row) and hub
  check_boundary(*gear_mesh,
                 4 * (2 * 4 + 2 + 4 + 6) + 2 * (4 * 2 + 4 * 6) - 2 * 6 + 2 * (8 + 4 * 2) +
                   2 * (2 * 6 - 2 + 2 * 2));
  check("rim underside nodes",
        rim_mesh->node_sets.at(node_set::rim_underside).size() == 79u * 5 * 6);
  check("no web, no bore",
        rim_mesh->node_sets.count(node_set::bore) == 0 &&
          rim_mesh->node_sets.count(node_set::web_front) == 0);

  check_volume(pinion, solid);
  check_volume(gear, without_web);
  check_web(*gear_mesh, gear, with_web);
  check_element_size(gear, GearBodyOptions());
  check_element_size(pinion, pinion_body_defaults());
  check_refusals(gear);
  check_declaration(gear);
  return 0;
}
