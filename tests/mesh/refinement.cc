// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Refinement of a coarse pair by p4est, globally and locally, puts new nodes on the generated
// flanks and fillets and on the cones of the blank; refined bodies are copies of a refined sector.

#include "../tests.h"

#include "coarsest.h"
#include "paper_members.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/gear/gear_manifolds.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <map>

using namespace vfife;

namespace
{
  /** Distance to the nearest tooth's copy of a point of tooth 0 that has the same L and h. */
  double distance_to_copy(const GearMember &member, const Vector3 &x, const Vector3 &of_tooth_0)
  {
    const double angle =
      std::remainder(std::atan2(x[1], x[0]) - std::atan2(of_tooth_0[1], of_tooth_0[0]),
                     member.pitch());
    return std::hypot(
      std::hypot(x[0], x[1]) * angle,
      (member.blank().coordinates_of(x) - member.blank().coordinates_of(of_tooth_0)).norm());
  }

  double distance_to_flank(const GearMember &member, const FlankSide side, const Vector3 &x)
  {
    const Vector2 L_h = member.blank().coordinates_of(x);
    return distance_to_copy(member, x, member.flank_point(side, L_h[0], L_h[1]).position);
  }

  /** By bisection of the interval (golden section), without derivatives. */
  double distance_to_fillet(const GearMember &member, const FlankSide side, const Vector3 &x)
  {
    const double L        = member.blank().coordinates_of(x)[0];
    const auto   distance = [&](const double lambda) {
      return distance_to_copy(member, x, member.fillet_point(side, L, lambda).position);
    };
    double           low = 0., high = member.fillet_end(side);
    constexpr double section = .61803398874989485;
    for (unsigned int i = 0; i < 50; ++i)
      {
        const double a = high - section * (high - low), b = low + section * (high - low);
        if (distance(a) < distance(b))
          high = b;
        else
          low = a;
      }
    return distance(.5 * (low + high));
  }

  /** Largest distances of the nodes on each boundary to its true surface [mm]. */
  std::map<std::string, double> measure(const dealii::Triangulation<3> &triangulation,
                                        const BodyMesh                 &mesh,
                                        const GearMember               &member,
                                        const GearBodyOptions          &options)
  {
    const Blank                                       &blank = member.blank();
    std::map<std::string, std::map<unsigned, Vector3>> nodes;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() != 0)
          for (unsigned int v = 0; v < 4; ++v)
            nodes[mesh.boundaries.at(face->boundary_id())][face->vertex_index(v)] =
              vector_of(face->vertex(v));

    std::map<std::string, double> worst;
    for (const auto &surface : nodes)
      for (const auto &node : surface.second)
        {
          const Vector3 &x    = node.second;
          const Vector2  L_h  = member.blank().coordinates_of(x);
          const auto    &name = surface.first;
          double         off  = 0.;
          if (name == surface_name::concave || name == surface_name::convex)
            off = distance_to_flank(
              member, name == surface_name::concave ? FlankSide::concave : FlankSide::convex, x);
          else if (name == node_set::concave_fillet || name == node_set::convex_fillet)
            off = distance_to_fillet(
              member, name == node_set::concave_fillet ? FlankSide::concave : FlankSide::convex, x);
          else if (name == node_set::tip)
            off = L_h[1] - blank.addendum(L_h[0]);
          else if (name == node_set::heel)
            off = L_h[0] - blank.outer_cone_distance;
          else if (name == node_set::bore)
            off = std::hypot(x[0], x[1]) - options.bore_radius;
          else if (name == node_set::web_front || name == node_set::web_back)
            {
              // distance across the web to a fixed point of the face where it meets the hub
              const Vector2 along(-std::sin(options.web_angle), std::cos(options.web_angle));
              const auto   &foot = mesh.triangulation.get_vertices()[mesh.node_sets.at(
                name == node_set::web_front ? node_set::node_A_front : node_set::node_A_back)[0]];
              const Vector2 step(std::hypot(x[0], x[1]) - std::hypot(foot[0], foot[1]),
                                 x[2] - foot[2]);
              off = along[0] * step[1] - along[1] * step[0];
            }
          else
            continue;
          worst[name] = largest_of(worst[name], std::abs(off));
        }
    return worst;
  }

  void check_p4est(const GearMember &member, const GearBodyOptions &options)
  {
    const auto mesh = make_gear_body(member, options);

    dealii::parallel::distributed::Triangulation<3> triangulation(MPI_COMM_WORLD);
    triangulation.copy_triangulation(mesh->triangulation);
    triangulation.refine_global(1);
    // Twice around the middle of the flanks of tooth 0.
    const Vector3 centre =
      member.flank_point(FlankSide::concave, member.blank().mean_cone_distance, 0.).position;
    for (unsigned int i = 0; i < 2; ++i)
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() && (vector_of(cell->center()) - centre).norm() < 5.)
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
      }
    for (const auto &surface : measure(triangulation, *mesh, member, options))
      check_below(member.name() + ": " + surface.first + " of p4est's mesh [mm]",
                  surface.second,
                  1e-6);
    const MeshQuality quality = compute_mesh_quality(triangulation);
    check(member.name() + ": p4est's cells are right-handed",
          quality.least_determinant > 0. && quality.least_scaled_jacobian > .3);
    check(member.name() + ": locally refined",
          triangulation.n_active_cells() > 8 * mesh->triangulation.n_active_cells() + 1000);
  }

  /** Facets of refined bodies: as many as there should be, with offsets a quarter as large. */
  void check_refined_body(const GearMember &member, GearBodyOptions options)
  {
    const auto coarse_mesh = make_gear_body(member, options);
    options.refinements    = 1;
    const auto        mesh = make_gear_body(member, options);
    const std::string name = member.name() + " refined: ";

    check(name + "cells",
          mesh->triangulation.n_active_cells() == 8 * coarse_mesh->triangulation.n_active_cells());
    const unsigned int nodes = mesh->triangulation.n_vertices() / mesh->structure.n_sectors();
    double             off   = 0.;
    for (unsigned int i = 0; i < mesh->triangulation.n_vertices(); ++i)
      off = largest_of(off,
                       (vector_of(mesh->triangulation.get_vertices()[i]) -
                        rotation_about(Vector3::UnitZ(), member.pitch() * (i / nodes)) *
                          vector_of(mesh->triangulation.get_vertices()[i % nodes]))
                         .norm());
    check_below(name + "copies of the sector's nodes [mm]", off, 1e-12);
    bool sets = true;
    for (const auto &set : coarse_mesh->node_sets)
      {
        const auto &refined = mesh->node_sets.at(set.first);
        sets                = sets && std::is_sorted(refined.begin(), refined.end()) &&
               (set.first.find("node A") == 0 ? refined.size() == set.second.size()
                                              : refined.size() > set.second.size());
      }
    check(name + "node sets", sets && mesh->node_sets.size() == coarse_mesh->node_sets.size());

    for (const char *side : {surface_name::concave, surface_name::convex})
      {
        const auto &before = coarse_mesh->surfaces.at(side), &after = mesh->surfaces.at(side);
        check(name + side + " facets",
              after.facets.size() == 4 * before.facets.size() &&
                after.nodes.size() == mesh->node_sets.at(side).size());
        check_close(name + side + " offsets fall with second order",
                    largest_size(after.offsets) / largest_size(before.offsets),
                    .25,
                    .03);
      }
    for (const auto &surface : measure(mesh->triangulation, *mesh, member, options))
      check_below(name + surface.first + " [mm]", surface.second, 1e-6);
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check_p4est(paper::gear(), coarsest({}));
  check_p4est(paper::pinion(), coarsest(pinion_body_defaults()));
  check_refined_body(paper::gear(), coarsest({}));
  check_refined_body(paper::pinion(), coarsest(pinion_body_defaults()));
  return 0;
}
