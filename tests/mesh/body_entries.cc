// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Entries of gear bodies and meshes that files hardly ever set: fillets of the web, bore and hub,
// element size, refinements; what each makes of the mesh.
#include "../read_entries.h"
#include "../tests.h"

#include "paper_members.h"

#include <vfife/mesh/gear/conical_web.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_body_sizes.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>

using namespace vfife;

namespace
{
  GearBodyOptions
  read(GearBodyOptions options, const std::string &body, const std::string &mesh = "")
  {
    read_entries(options, "subsection Body\n" + body + "end\nsubsection Mesh\n" + mesh + "end\n");
    return options;
  }

  /** (r, z) of a node. */
  Vector2 meridian_place(const BodyMesh &mesh, const unsigned int node)
  {
    const auto &x = mesh.triangulation.get_vertices()[node];
    return {std::hypot(x[0], x[1]), x[2]};
  }

  const std::string web = "set web attachment = middle\nset web thickness = 4\n";

  void hub(const GearMember &gear)
  {
    const auto mesh =
      make_gear_body(gear,
                     read(coarse(GearBodyOptions()),
                          "set hub radius = 55\nset bore radius = 45\nset hub length = 0.03 m\n"));
    double radius = 0, low = 1e9, high = -1e9;
    for (const unsigned int node : mesh->node_sets.at(node_set::bore))
      {
        const Vector2 place = meridian_place(*mesh, node);
        radius              = largest_of(radius, std::abs(place[0] - 45.));
        low                 = std::min(low, place[1]);
        high                = largest_of(high, place[1]);
      }
    check_below("bore radius: places of the bore's nodes [mm]", radius, 1e-12);
    check_close("hub length: of the bore [mm]", high - low, 30., 1e-12);
  }

  void fillets(const GearMember &gear)
  {
    const GearBodyOptions plain = read(coarse(GearBodyOptions()), web);
    const GearBodyOptions rounded =
      read(coarse(GearBodyOptions()),
           web + "set rim fillet radius = 1.5\nset hub fillet radius = 2 mm\n");
    // A face that meets its wall at the angle a touches an arc r/tan(a/2) from the corner; of both
    // faces together that makes the foot 2 r/sin(a) longer.
    const auto foot = [&](const GearBodyOptions &options) {
      const Blank     &blank = gear.blank();
      const ConicalWeb cone(blank,
                            options,
                            -blank.dedendum(blank.inner_cone_distance()),
                            -blank.dedendum(blank.outer_cone_distance));
      return (cone.wall_point(cone.wall_place(1.)) - cone.wall_point(cone.wall_place(0.))).norm();
    };
    check_close("rim fillet radius: foot of the web over that of a sharp one",
                foot(rounded) / foot(plain),
                (4. + 2 * 1.5) / 4.,
                1e-12);
    const auto at_hub = [&](const GearBodyOptions &options) {
      const auto mesh = make_gear_body(gear, options);
      return meridian_place(*mesh, mesh->node_sets.at(node_set::node_A_back).front())[1] -
             meridian_place(*mesh, mesh->node_sets.at(node_set::node_A_front).front())[1];
    };
    const double slope = std::sin(70. * pi / 180.);
    check_close("hub: between the nodes A of a sharp web [mm]", at_hub(plain), 4. / slope, 1e-11);
    check_close("hub fillet radius: between the nodes A [mm]",
                at_hub(rounded),
                (4. + 2 * 2.) / slope,
                1e-11);

    const auto count = [&](const std::string &rows) {
      const std::string radii = "set rim fillet radius = 1.5\nset hub fillet radius = 2\n";
      return make_gear_body(gear, read(coarse(GearBodyOptions()), web + radii, rows))
               ->triangulation.n_active_cells() /
             79;
    };
    // Behind the row that joins three columns into one, a row has two columns in a sector.
    check("fillet rows: two more at rim and hub, of two layers",
          count("set elements along web fillet = 3\n") -
              count("set elements along web fillet = 1\n") ==
            2 * (6 + 2) * 2);
  }

  /** Ends of the web's foot on the rim's underside, which is a straight line in the meridian. */
  void attachments(const GearMember &gear)
  {
    const Blank &blank     = gear.blank();
    const auto   underside = [&](const double L) {
      return blank.meridian_point({L, -blank.dedendum(L) - GearBodyOptions().rim_thickness});
    };
    const Vector2 inner = underside(blank.inner_cone_distance()),
                  outer = underside(blank.outer_cone_distance);
    for (const std::string &place : {std::string("middle"), std::string("heel")})
      {
        const GearBodyOptions options =
          read(coarse(GearBodyOptions()),
               "set web attachment = " + place + "\nset web thickness = 4\n");
        const ConicalWeb cone(blank,
                              options,
                              -blank.dedendum(blank.inner_cone_distance()),
                              -blank.dedendum(blank.outer_cone_distance));
        const Vector2    first = cone.wall_point(cone.wall_place(0.)),
                      last     = cone.wall_point(cone.wall_place(1.));
        if (place == "heel")
          check_below("web at the heel: where its foot ends [mm]", (last - outer).norm(), 1e-11);
        else
          check_below("web in the middle: middle of its foot [mm]",
                      (first + last - inner - outer).norm(),
                      1e-11);
      }
  }

  /** A gear without a web: straight down the back cone to the bore, whose radius sets how much of a
   * prism is there, over the width in the axis' direction. */
  void solid_gear(const GearMember &gear)
  {
    const auto make = [&](const std::string &bore) {
      return make_gear_body(gear,
                            read(coarse(GearBodyOptions()),
                                 "set body type = solid\nset bore radius = " + bore + "\n"));
    };
    const auto large = make("60"), small = make("55");
    double     radius = 0;
    for (const unsigned int node : large->node_sets.at(node_set::bore))
      radius = largest_of(radius, std::abs(meridian_place(*large, node)[0] - 60.));
    check_below("solid gear: places of the bore's nodes [mm]", radius, 1e-12);
    // Corners of the bore's polygon; between ends of equal slope all of its prism is as long, but
    // the columns of cells lean around the axis with the teeth, which costs some 3e-4.
    const std::size_t corners =
      large->node_sets.at(node_set::bore).size() / (coarse(GearBodyOptions()).cells_lengthwise + 1);
    const double part   = 2 * pi / corners;
    const double length = gear.blank().face_width / std::cos(gear.blank().pitch_angle);
    check_close("solid gear: volume between two bores over the prism's",
                (compute_mesh_quality(small->triangulation).volume -
                 compute_mesh_quality(large->triangulation).volume) /
                  (pi * std::sin(part) / part * (60. * 60. - 55. * 55.) * length),
                1.,
                1e-3);
  }

  void sizes(const GearMember &pinion)
  {
    const GearBodyOptions sized =
      with_counts_of_size(read(pinion_body_defaults(), "", "set element size = 3 mm\n"), pinion);
    // 30 mm of face, 3.34 + 1.91 mm of tooth; in between as the tooth is thick
    check("element size: cells lengthwise and flank rows",
          sized.cells_lengthwise == 10 && sized.flank_rows == 2 && sized.element_size == 0.);
    const double thickness = pinion.tooth_thickness(pinion.blank().mean_cone_distance, 0.);
    check("element size: cells across the tooth",
          sized.cells_across == std::max(2L, std::lround(thickness / 3)));
    const auto mesh =
      make_gear_body(pinion, read(pinion_body_defaults(), "", "set element size = 3\n"));
    check("element size: elements of the mesh",
          mesh->triangulation.n_active_cells() ==
            27u * 10 * (3 * sized.cells_across + sized.rim_rows * sized.columns()));

    const std::string few  = "set elements along face width = 2\nset elements across tooth = 2\n"
                             "set elements along profile = 2\nset elements through rim = 2\n";
    const auto        once = make_gear_body(pinion, read(pinion_body_defaults(), "", few));
    const auto        refined =
      make_gear_body(pinion, read(pinion_body_defaults(), "", few + "set refinements = 1\n"));
    check("refinements: eight times the elements",
          refined->triangulation.n_active_cells() == 8 * once->triangulation.n_active_cells());
    check_close("refinements: half the least edge",
                compute_mesh_quality(refined->triangulation).least_edge /
                  compute_mesh_quality(once->triangulation).least_edge,
                .5,
                .1);
  }
} // namespace

int main()
{
  const GearMember gear = paper::gear();
  hub(gear);
  fillets(gear);
  attachments(gear);
  solid_gear(gear);
  sizes(paper::pinion());
  return 0;
}
