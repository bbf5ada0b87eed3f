// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_fem_distributed_distributed_mesh_h
#define vfife_source_fem_distributed_distributed_mesh_h

#include <vfife/fem/system/fem_space_options.h>
#include <vfife/model/model.h>

#include <deal.II/grid/tria.h>

#include <memory>
#include <vector>

namespace vfife
{
  class Communicator;

  /**
   * The mesh of a body on several ranks: a dealii::parallel::distributed::Triangulation. Each rank
   * has all elements of the body as coarsest cells, and of the cells that they are divided into its
   * own and their neighbours.
   */
  class DistributedMesh
  {
  public:
    using Cell = dealii::Triangulation<3>::cell_iterator;

    /** Where a cell lies in the element of the body that it is or a part of: its unit coordinates
     * are @p origin + @p size times those of the cell. */
    struct Place
    {
      unsigned int     element = 0;
      dealii::Point<3> origin;
      double           size = 1;
    };

    /** Throws InputError where deal.II has no p4est, and for a mesh that is divided already.
     * Collective. */
    DistributedMesh(const Body                         &body,
                    const std::vector<LocalRefinement> &refinements,
                    const Communicator                 &communicator);

    const dealii::Triangulation<3> &triangulation() const
    {
      return *triangulation_;
    }
    const Body &body() const
    {
      return body_;
    }
    /** Whether some elements of the body are divided. */
    bool is_refined() const
    {
      return triangulation_->n_global_levels() > 1;
    }

    Place place_of(Cell cell) const;

    /** The nodes of the body between which a point lies, at unit coordinates @p unit of the cell:
     * one, two of an edge, four of a face, or the eight of the element; ascending. */
    std::vector<unsigned int> nodes_around(const Place &place, const dealii::Point<3> &unit) const;

    /** Whether face @p f of the cell lies on that of the element. */
    static bool is_on_face(const Place &place, unsigned int f);

  private:
    void flag_around(const LocalRefinement &refinement);

    const Body                               &body_;
    std::unique_ptr<dealii::Triangulation<3>> triangulation_;
  };
} // namespace vfife

#endif
