// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes that are finer at fillets and flanks: sizes of rows and columns as asked for.

#include "../tests.h"

#include "paper_members.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_section.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

using namespace vfife;

namespace
{
  Vector3 vertex(const BodyMesh &mesh, const unsigned int i)
  {
    const auto &x = mesh.triangulation.get_vertices()[i];
    return {x[0], x[1], x[2]};
  }

  /** Steps between sorted values. */
  std::vector<double> steps(std::vector<double> values)
  {
    std::sort(values.begin(), values.end());
    std::vector<double> result;
    for (unsigned int i = 1; i < values.size(); ++i)
      result.push_back(values[i] - values[i - 1]);
    return result;
  }

  void check_growth(const std::string         &name,
                    const std::vector<double> &sizes,
                    const unsigned int         cells,
                    const double               ratio)
  {
    bool monotone = sizes.size() == cells;
    for (unsigned int i = 1; i < sizes.size(); ++i)
      monotone = monotone && sizes[i] > sizes[i - 1];
    check(name + ": as many as asked for, growing", monotone);
    check_close(name + ": last over first", sizes.back() / sizes.front(), ratio, 1e-8 * ratio);
  }

  /** Nodes of tooth 0 at the heel: steps of the flank in h, of the tip in angle, of the rim's side
   * under the root in depth. */
  void check_body(const GearMember &member, const GearBodyOptions &options)
  {
    const auto         mesh  = make_gear_body(member, options);
    const unsigned int first = mesh->triangulation.n_vertices() / mesh->structure.n_sectors();
    const Blank       &blank = member.blank();
    const auto         L_h   = [&](const Vector3 &x) {
      return blank.cone_coordinates({std::hypot(x[0], x[1]), x[2]});
    };
    const auto at_heel = [&](const char *set) {
      std::vector<Vector3> result;
      for (const unsigned int node : mesh->node_sets.at(set))
        if (node < first &&
            std::abs(L_h(vertex(*mesh, node))[0] - blank.outer_cone_distance) < 1e-9)
          result.push_back(vertex(*mesh, node));
      return result;
    };

    std::vector<double> heights, angles, depths;
    for (const Vector3 &x : at_heel(surface_name::concave))
      heights.push_back(L_h(x)[1]);
    check_growth(member.name() + ", flank rows",
                 steps(heights),
                 options.flank_rows,
                 options.grading_towards_fillet);

    for (const Vector3 &x : at_heel(node_set::tip))
      angles.push_back(std::atan2(x[1], x[0]));
    std::vector<double> half = steps(angles);
    half.resize((options.cells_across + 1) / 2);
    check_growth(member.name() + ", columns",
                 half,
                 (options.cells_across + 1) / 2,
                 options.grading_towards_flank);

    const auto section = compute_gear_section(member, blank.outer_cone_distance, 1);
    for (const Vector3 &x : at_heel(node_set::heel))
      if (std::abs(std::remainder(std::atan2(x[1], x[0]) - section.left_angle, 2. * pi)) < 1e-9)
        depths.push_back(-L_h(x)[1]);
    check_growth(member.name() + ", rim rows",
                 steps(depths),
                 options.rim_rows,
                 options.grading_towards_fillet);

    const MeshQuality quality = compute_mesh_quality(mesh->triangulation);
    check(member.name() + ": scaled Jacobian",
          quality.least_determinant > 0. && quality.least_scaled_jacobian > .45);
  }

  /** At the heel, the concave fillet of tooth 0 has nodes at its bottom, at that fraction of its
   * arc and at its end. */
  void check_fillet_corner(const GearMember &member, const GearBodyOptions &options)
  {
    const auto         mesh  = make_gear_body(member, options);
    const unsigned int first = mesh->triangulation.n_vertices() / mesh->structure.n_sectors();
    const double       L     = member.blank().outer_cone_distance;
    const std::vector<Vector3> places = {
      member.fillet_point(FlankSide::concave, L, 0.).position,
      member
        .fillet_point(FlankSide::concave,
                      L,
                      options.fillet_corner * member.fillet_end(FlankSide::concave))
        .position,
      member.fillet_point(FlankSide::concave, L, member.fillet_end(FlankSide::concave)).position};
    unsigned int at_heel  = 0;
    double       distance = 0;
    for (const unsigned int node : mesh->node_sets.at(node_set::concave_fillet))
      {
        const Vector3 x = vertex(*mesh, node);
        if (node >= first ||
            std::abs(member.blank().cone_coordinates({std::hypot(x[0], x[1]), x[2]})[0] - L) > 1e-9)
          continue;
        ++at_heel;
        double nearest = 1e300;
        for (const Vector3 &place : places)
          nearest = std::min(nearest, (x - place).norm());
        distance = largest_of(distance, nearest);
      }
    check("fillet corner: nodes of the fillet at the heel", at_heel == places.size());
    check_below("fillet corner: their places [mm]", distance, 1e-8);
  }
} // namespace

int main()
{
  GearBodyOptions          gear_options, pinion_options = pinion_body_defaults();
  dealii::ParameterHandler prm;
  gear_options.declare(prm);
  prm.parse_input_from_string("subsection Body\n set body type = rim only\nend\n"
                              "subsection Mesh\n set elements along face width = 6\n"
                              "set grading towards fillet = 3\n"
                              "set grading towards flank = 2\nend\n");
  check_body(paper::gear(), gear_options);
  pinion_options.cells_lengthwise       = 8;
  pinion_options.grading_towards_fillet = 2.5;
  pinion_options.grading_towards_flank  = 1.5;
  check_body(paper::pinion(), pinion_options);
  prm.parse_input_from_string("subsection Mesh\n set fillet corner = 0.35\nend\n");
  check_fillet_corner(paper::gear(), gear_options);
  return 0;
}
