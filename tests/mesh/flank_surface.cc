// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Flank surfaces: nodes and normals on the true flank, offsets that lead to it between the nodes,
// orientation, neighbours.

#include "../tests.h"

#include "paper_members.h"

#include <vfife/mesh/gear/flank_surface.h>
#include <vfife/mesh/gear/gear_body.h>

#include <random>

using namespace vfife;

namespace
{
  Vector2 cone_coordinates(const GearMember &member, const Vector3 &x)
  {
    return member.blank().cone_coordinates({std::hypot(x[0], x[1]), x[2]});
  }

  /** Lagrange polynomial k of the offset abscissae. */
  double lagrange(const unsigned int k, const double x)
  {
    static const std::vector<double> abscissae = offset_abscissae();
    double                           value     = 1.;
    for (unsigned int j = 0; j < 5; ++j)
      if (j != k)
        value *= (x - abscissae[j]) / (abscissae[k] - abscissae[j]);
    return value;
  }

  void check_nodes(const GearMember   &member,
                   const FlankSide     side,
                   const BodyMesh     &mesh,
                   const FacetSurface &surface)
  {
    double            distance = 0., turn = 0., mesh_distance = 0.;
    const std::size_t per_tooth = surface.nodes.size() / surface.n_groups;
    for (std::size_t i = 0; i < surface.nodes.size(); ++i)
      {
        const Matrix3 back =
          rotation_about(Vector3::UnitZ(), -2. * pi * (i / per_tooth) / surface.n_groups);
        const Vector3 x          = back * surface.positions[i];
        const Vector2 L_h        = cone_coordinates(member, x);
        const auto    true_point = member.flank_point(side, L_h[0], L_h[1]);
        distance                 = largest_of(distance, (true_point.position - x).norm());
        turn          = largest_of(turn, (true_point.normal + back * surface.normals[i]).norm());
        const auto &v = mesh.triangulation.get_vertices()[surface.nodes[i]];
        mesh_distance =
          largest_of(mesh_distance, (Vector3(v[0], v[1], v[2]) - surface.positions[i]).norm());
      }
    const std::string name = member.name() + " " + surface.name;
    check_below(name + ": nodes on the true flank [mm]", distance, 1e-9);
    check_below(name + ": outward normals", turn, 1e-9);
    check_below(name + ": positions are those of the mesh", mesh_distance, 1e-9);
  }

  void check_facets(const GearMember      &member,
                    const FacetSurface    &surface,
                    const GearBodyOptions &options)
  {
    bool               outward = true, grouped = true, corners = true;
    unsigned int       open      = 0;
    const unsigned int per_tooth = options.cells_lengthwise * options.flank_rows;
    for (unsigned int f = 0; f < surface.facets.size(); ++f)
      {
        const auto   &c      = surface.facets[f];
        const Vector3 normal = (surface.positions[c[2]] - surface.positions[c[0]])
                                 .cross(surface.positions[c[3]] - surface.positions[c[1]])
                                 .normalized();
        for (const unsigned int corner : c)
          outward = outward && normal.dot(surface.normals[corner]) > .98;
        grouped =
          grouped && surface.group[f] == f / per_tooth && surface.offset_row[f] == f % per_tooth;
        for (const unsigned int neighbour : surface.neighbours[f])
          open += neighbour == FacetSurface::no_facet ? 1 : 0;
        for (const unsigned int k : {0, 4, 20, 24})
          corners = corners && surface.offsets[25 * surface.offset_row[f] + k] == 0.;
      }
    const std::string name = member.name() + " " + surface.name;
    check(name + ": facets face outward", outward);
    check(name + ": groups are teeth, rows are shared",
          grouped && surface.n_groups == member.blank().teeth &&
            surface.facets.size() == std::size_t(per_tooth) * surface.n_groups);
    check(name + ": no offset at corners", corners);
    // The edges by heights of nodes over the pitch cone and by cone distances.
    const Blank &blank = member.blank();
    bool         edges = true;
    for (unsigned int f = 0; f < surface.facets.size(); ++f)
      for (unsigned int side = 0; side < 4; ++side)
        {
          const unsigned int a = surface.facets[f][side], b = surface.facets[f][(side + 1) % 4];
          const Vector2      one  = cone_coordinates(member, surface.positions[a]);
          const Vector2      two  = cone_coordinates(member, surface.positions[b]);
          const double       heel = blank.outer_cone_distance;
          const bool         end  = std::abs(one[0] - two[0]) < 1e-6 &&
                           std::abs(std::abs(one[0] - heel + 0.5 * blank.face_width) -
                                    0.5 * blank.face_width) < 1e-6;
          const bool tip    = one[1] > 0. && two[1] > 0. && std::abs(one[0] - two[0]) > 1e-6;
          const bool border = surface.neighbours[f][side] == FacetSurface::no_facet;
          edges             = edges && (surface.edges[f][side] != 0) == (border && (tip || end));
        }
    check(name + ": edges are tip and ends", edges);
    check(name + ": borders are the ends, flank start and tip",
          open == 2 * (options.cells_lengthwise + options.flank_rows) * surface.n_groups);
  }

  /** 10 nm is a hundredth of the ripple of the transmission error that contact has to resolve. */
  void check_offsets(const GearMember &member, const FlankSide side, const FacetSurface &surface)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> uniform(0., 1.);
    double                                 largest = 0., without = 0.;
    const std::size_t                      rows = surface.offsets.size() / 25;
    for (unsigned int sample = 0; sample < 4000; ++sample)
      {
        const unsigned int f  = sample % rows; // tooth 0
        const double       xi = uniform(random), eta = uniform(random);
        const double       weights[4] = {(1. - xi) * (1. - eta),
                                         xi * (1. - eta),
                                         xi * eta,
                                         (1. - xi) * eta};
        Vector3            point = Vector3::Zero(), normal = Vector3::Zero();
        for (unsigned int k = 0; k < 4; ++k)
          {
            point += weights[k] * surface.positions[surface.facets[f][k]];
            normal += weights[k] * surface.normals[surface.facets[f][k]];
          }
        double offset = 0.;
        for (unsigned int j = 0; j < 5; ++j)
          for (unsigned int i = 0; i < 5; ++i)
            offset += lagrange(i, xi) * lagrange(j, eta) *
                      surface.offsets[25 * surface.offset_row[f] + 5 * j + i];
        for (const bool with : {false, true})
          {
            const Vector3 y   = point + (with ? offset : 0.) * normal.normalized();
            const Vector2 L_h = cone_coordinates(member, y);
            const auto    x   = member.flank_point(side, L_h[0], L_h[1]);
            double       &far = with ? largest : without;
            far               = largest_of(far, std::abs((x.position - y).dot(x.normal)));
          }
      }
    const std::string name = member.name() + " " + surface.name;
    check_below(name + ": distance of the offset surface from the true flank [mm]", largest, 1e-5);
    check(name + ": plain facets are much farther away", without > 20. * largest);
  }

  void check_member(const GearMember &member, const GearBodyOptions &options)
  {
    const auto mesh = make_gear_body(member, options);
    for (const FlankSide side : {FlankSide::concave, FlankSide::convex})
      {
        const auto &surface = mesh->surfaces.at(side == FlankSide::concave ? "concave" : "convex");
        check_nodes(member, side, *mesh, surface);
        check_facets(member, surface, options);
        check_offsets(member, side, surface);
      }
  }
} // namespace

int main()
{
  GearBodyOptions gear = coarse(GearBodyOptions());
  gear.web             = WebKind::none;
  check_member(paper::gear(), gear);
  check_member(paper::pinion(), coarse(pinion_body_defaults()));
  return 0;
}
