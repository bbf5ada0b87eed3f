// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// A gear body distributed over MPI ranks by p4est: refined everywhere it is the body that one rank
// makes, refined locally its new nodes stand on the generated flanks.

#include "../tests.h"

#include "coarsest.h"
#include "paper_members.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/mesh/solid_integrals.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

using namespace vfife;

namespace
{
  using Distributed = dealii::parallel::distributed::Triangulation<3>;

  double volume_of_owned(const Distributed &triangulation)
  {
    double sum = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        sum += cell->measure();
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  /** Largest distance about the axis of nodes on the flanks from the generated ones [mm]. */
  double
  largest_distance(const Distributed &triangulation, const BodyMesh &mesh, const GearMember &member)
  {
    double worst = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &face : cell->face_iterators())
          {
            const auto name = mesh.boundaries.find(face->boundary_id());
            if (!face->at_boundary() || name == mesh.boundaries.end() ||
                (name->second != surface_name::concave && name->second != surface_name::convex))
              continue;
            const FlankSide side =
              name->second == surface_name::concave ? FlankSide::concave : FlankSide::convex;
            for (unsigned int v = 0; v < 4; ++v)
              {
                const Vector3 x     = vector_of(face->vertex(v));
                const double  r     = std::hypot(x[0], x[1]);
                const Vector2 L_h   = member.blank().coordinates_of(x);
                const Vector3 flank = member.flank_point(side, L_h[0], L_h[1]).position;
                const double  angle = std::atan2(x[1], x[0]) - std::atan2(flank[1], flank[0]);
                worst = largest_of(worst, std::abs(r * std::remainder(angle, member.pitch())));
              }
          }
    return dealii::Utilities::MPI::max(worst, MPI_COMM_WORLD);
  }

  void check_member(const GearMember &member, GearBodyOptions options)
  {
    const std::string name = member.name() + ": ";
    const auto        mesh = make_gear_body(member, options);
    Distributed       triangulation(MPI_COMM_WORLD);
    triangulation.copy_triangulation(mesh->triangulation);
    triangulation.refine_global(1);
    options.refinements = 1;
    const auto refined  = make_gear_body(member, options);
    check(name + "cells, refined everywhere",
          triangulation.n_global_active_cells() == refined->triangulation.n_active_cells());
    check(name + "cells on every rank",
          dealii::Utilities::MPI::min(triangulation.n_locally_owned_active_cells(),
                                      MPI_COMM_WORLD) > 0);
    // round-off of 100,000 cells; the same nodes, so the same volume
    check_close(name + "volume over that of one rank's body",
                volume_of_owned(triangulation) /
                  compute_solid_integrals(refined->triangulation).volume,
                1.,
                1e-10);
    check_below(name + "flanks, refined everywhere [mm]",
                largest_distance(triangulation, *mesh, member),
                1e-6);

    const Vector3 centre =
      member.flank_point(FlankSide::convex, member.blank().mean_cone_distance, 0.).position;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && (vector_of(cell->center()) - centre).norm() < 8.)
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
    check(name + "more cells, with hanging nodes",
          triangulation.n_global_active_cells() > refined->triangulation.n_active_cells() + 100);
    check_below(name + "flanks, refined locally [mm]",
                largest_distance(triangulation, *mesh, member),
                1e-6);
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit); // rank 0 speaks

  check_member(paper::gear(), coarsest({}));
  check_member(paper::pinion(), coarsest(pinion_body_defaults()));
  return 0;
}
