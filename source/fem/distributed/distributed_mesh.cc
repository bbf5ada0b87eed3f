// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "distributed_mesh.h"

#include "boundary_set.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/system/element_integrals.h>
#include <vfife/mesh/body_mesh.h>

#include <deal.II/distributed/tria.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    std::unique_ptr<dealii::Triangulation<3>> copy_to_ranks(const Body         &body,
                                                            const Communicator &communicator)
    {
      if (body.mesh().triangulation.n_levels() > 1)
        throw InputError("Fem/distributed",
                         "expected a mesh of one level, got levels in the mesh of body \"" +
                           body.name() + "\". Set no.");
#ifdef DEAL_II_WITH_P4EST
      auto mesh =
        std::make_unique<dealii::parallel::distributed::Triangulation<3>>(communicator.mpi());
      mesh->copy_triangulation(body.mesh().triangulation);
      return mesh;
#else
      (void)communicator;
      throw InputError("Fem/distributed",
                       "expected no, got yes. deal.II of this build has no p4est, which "
                       "distributes meshes. Set no, or build vfife with such a deal.II.");
#endif
    }
  } // namespace

  DistributedMesh::DistributedMesh(const Body                         &body,
                                   const std::vector<LocalRefinement> &refinements,
                                   const Communicator                 &communicator)
    : body_(body)
    , triangulation_(copy_to_ranks(body, communicator))
  {
    unsigned int steps = 0;
    for (const LocalRefinement &asked : refinements)
      steps = std::max(steps, asked.times);
    for (unsigned int step = 1; step <= steps; ++step)
      {
        for (const LocalRefinement &asked : refinements)
          if (asked.times >= step)
            flag_around(asked);
        triangulation_->execute_coarsening_and_refinement();
      }
  }

  void DistributedMesh::flag_around(const LocalRefinement &refinement)
  {
    if (is_everywhere(refinement))
      {
        triangulation_->set_all_refine_flags();
        return;
      }
    const std::vector<BoundaryFace> boundary = find_whole_boundary(body_);
    for (const std::vector<unsigned int> &nodes : nodes_of_refinement(refinement, body_))
      {
        const BoundarySet set(body_, nodes, boundary, true);
        for (const auto &cell : triangulation_->active_cell_iterators())
          if (cell->is_locally_owned())
            {
              const Place place = place_of(cell);
              for (unsigned int v = 0; v < 8; ++v)
                if (set.contains(nodes_around(place, dealii::GeometryInfo<3>::unit_cell_vertex(v))))
                  cell->set_refine_flag();
            }
      }
  }

  DistributedMesh::Place DistributedMesh::place_of(Cell cell) const
  {
    Place place;
    while (cell->level() > 0)
      {
        const Cell   parent = cell->parent();
        unsigned int child  = 0;
        while (parent->child(child) != cell)
          ++child;
        // Children lie in their parent as corners do, x fastest.
        for (unsigned int d = 0; d < 3; ++d)
          place.origin[d] = .5 * (place.origin[d] + (child >> d & 1u));
        place.size *= .5;
        cell = parent;
      }
    place.element = cell->index();
    return place;
  }

  std::vector<unsigned int> DistributedMesh::nodes_around(const Place            &place,
                                                          const dealii::Point<3> &unit) const
  {
    // Numbers are sums of powers of two where they are 0 or 1, and therefore exact.
    const auto               &corners = body_.elements()[place.element];
    std::vector<unsigned int> nodes;
    Vector3                   along;
    for (unsigned int d = 0; d < 3; ++d)
      along[d] = place.origin[d] + place.size * unit[d];
    for (const unsigned int v : corners_around(along))
      nodes.push_back(corners[v]);
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  bool DistributedMesh::is_on_face(const Place &place, const unsigned int f)
  {
    const unsigned int d = f / 2;
    return f % 2 == 0 ? place.origin[d] == 0. : place.origin[d] + place.size == 1.;
  }
} // namespace vfife
