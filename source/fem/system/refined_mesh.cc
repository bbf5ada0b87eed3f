// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "refined_mesh.h"

#include <vfife/base/errors.h>
#include <vfife/model/load_shares.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    using Cell = RefinedMesh::Cell;

    /** The element of the coarsest mesh that has the cell in it. */
    unsigned int root_of(Cell cell)
    {
      while (cell->level() > 0)
        cell = cell->parent();
      return cell->index();
    }

    /** Marks the vertices of the active cells' faces that lie on face @p f of a cell. */
    void mark_face(const Cell &cell, const unsigned int f, std::vector<bool> &marked)
    {
      if (cell->is_active())
        {
          for (unsigned int v = 0; v < 4; ++v)
            marked[cell->face(f)->vertex_index(v)] = true;
          return;
        }
      for (unsigned int c = 0; c < 8; ++c)
        if ((c >> (f / 2) & 1u) == f % 2)
          mark_face(cell->child(c), f, marked);
    }

    /** Flags the active cells that touch the set by a corner. */
    void flag_around(const Body                      &body,
                     const std::vector<unsigned int> &nodes,
                     dealii::Triangulation<3>        &mesh)
    {
      std::vector<bool> marked(mesh.n_vertices(), false);
      for (const unsigned int node : nodes)
        marked[node] = true;
      for (const BoundaryFace &face : find_boundary_faces(body, nodes))
        mark_face(Cell(&mesh, 0, face.element), face.number, marked);
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          if (marked[cell->vertex_index(v)])
            cell->set_refine_flag();
    }

    /** Flags the neighbours of flagged cells in other sectors, so that both sides of a border are
     * divided alike. */
    void flag_across_borders(const BodyStructure &structure, dealii::Triangulation<3> &mesh)
    {
      const auto sector_of = [&](const Cell &cell) {
        return structure.sector_of_element(root_of(cell));
      };
      for (bool changed = structure.n_sectors() > 1; changed;)
        {
          changed = false;
          for (const auto &cell : mesh.active_cell_iterators())
            for (unsigned int f = 0; cell->refine_flag_set() && f < 6; ++f)
              if (!cell->at_boundary(f) && cell->neighbor(f)->is_active() &&
                  cell->neighbor(f)->level() == cell->level() &&
                  !cell->neighbor(f)->refine_flag_set() &&
                  sector_of(cell->neighbor(f)) != sector_of(cell))
                {
                  cell->neighbor(f)->set_refine_flag();
                  changed = true;
                }
        }
    }

    /** Flags the active cells below @p cell that are divided below @p other. */
    bool flag_as(const Cell &other, const Cell &cell)
    {
      if (cell->is_active())
        {
          if (!other->has_children())
            return false;
          cell->set_refine_flag();
          return true;
        }
      bool any = false;
      for (unsigned int c = 0; c < 8; ++c)
        any = flag_as(other->child(c), cell->child(c)) || any;
      return any;
    }
  } // namespace

  RefinedMesh::RefinedMesh(const Body                                   &body,
                           const std::vector<LocalRefinement>           &refinements,
                           const std::vector<std::vector<unsigned int>> &divisions)
    : triangulation_(&body.mesh().triangulation)
  {
    if (triangulation_->n_levels() > 1 && triangulation_->has_hanging_nodes())
      throw InputError("body \"" + body.name() +
                       "\": its locally refined mesh has hanging nodes, which the finite element "
                       "solver does not support. Refine it everywhere");
    for (unsigned int step = 1;; ++step)
      {
        if (std::none_of(refinements.begin(), refinements.end(), [&](const LocalRefinement &asked) {
              return asked.times >= step;
            }))
          break;
        copy(body);
        for (const LocalRefinement &asked : refinements)
          if (asked.times >= step && is_everywhere(asked))
            own_->set_all_refine_flags();
          else if (asked.times >= step)
            for (const std::vector<unsigned int> &nodes : nodes_of_refinement(asked, body))
              flag_around(body, nodes, *own_);
        flag_across_borders(body.structure(), *own_);
        own_->execute_coarsening_and_refinement();
      }
    for (const std::vector<unsigned int> &division : divisions)
      {
        if (division.empty())
          continue;
        copy(body);
        list_elements();
        for (const unsigned int e : division)
          Cell(elements_[e].cell)->set_refine_flag();
        own_->execute_coarsening_and_refinement();
      }
    list_elements();
  }

  void RefinedMesh::copy(const Body &body)
  {
    if (own_)
      return;
    own_ = std::make_unique<dealii::Triangulation<3>>();
    own_->copy_triangulation(body.mesh().triangulation);
    triangulation_ = own_.get();
  }

  RefinedMesh::RefinedMesh(const std::vector<Vector3>   &nodes,
                           const std::vector<CellNodes> &elements,
                           const RefinedMesh            &whole)
    : own_(std::make_unique<dealii::Triangulation<3>>())
    , triangulation_(own_.get())
  {
    BodyMesh mesh;
    create_triangulation(mesh, nodes, elements);
    own_->copy_triangulation(mesh.triangulation);
    for (bool any = whole.is_refined(); any;)
      {
        any = false;
        for (unsigned int e = 0; e < elements.size(); ++e)
          any = flag_as(Cell(whole.triangulation_, 0, e), Cell(own_.get(), 0, e)) || any;
        if (any)
          own_->execute_coarsening_and_refinement();
      }
    list_elements();
    for (std::size_t e = 0; e < elements_.size(); ++e)
      if (elements_[e].parent != whole.elements_[e].parent ||
          elements_[e].cell->level() != whole.elements_[e].cell->level())
        throw NumericalError("a sector of a body is divided differently from the whole body");
  }

  void RefinedMesh::list_elements()
  {
    elements_.clear();
    first_.clear();
    is_refined_                      = own_ && own_->n_levels() > 1;
    constexpr unsigned int all_faces = 63;
    const auto             add       = [&](const Cell &cell) {
      first_.push_back(elements_.size());
      add_elements(cell, first_.size() - 1, all_faces);
    };
    // A body's mesh that has levels of its own counts by its active cells.
    if (is_refined_)
      for (const auto &cell : triangulation_->cell_iterators_on_level(0))
        add(cell);
    else
      for (const auto &cell : triangulation_->active_cell_iterators())
        add(cell);
    first_.push_back(elements_.size());
  }

  void
  RefinedMesh::add_elements(const Cell &cell, const unsigned int parent, const unsigned int faces)
  {
    if (cell->is_active())
      {
        elements_.push_back({cell, parent, faces});
        return;
      }
    for (unsigned int c = 0; c < 8; ++c)
      {
        unsigned int outer = 0;
        for (unsigned int f = 0; f < 6; ++f)
          if ((c >> (f / 2) & 1u) == f % 2)
            outer |= faces & (1u << f);
        add_elements(cell->child(c), parent, outer);
      }
  }
} // namespace vfife
