// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_fem_system_refined_mesh_h
#define vfife_source_fem_system_refined_mesh_h

#include <vfife/fem/system/fem_space_options.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>

#include <memory>
#include <vector>

namespace vfife
{
  /**
   * The mesh of a body or of one of its sectors, some elements divided. Vertices of the body's mesh
   * keep their numbers. Elements are listed in the order of the body's, those that an element is
   * divided into one after the other.
   */
  class RefinedMesh
  {
  public:
    using Cell = dealii::Triangulation<3>::cell_iterator;
    struct Element
    {
      Cell         cell;
      unsigned int parent; ///< element of the body
      unsigned int faces;  ///< bit f: face f lies on that of the parent
    };

    /** Throws InputError for a mesh with hanging nodes of its own. @p refinements divide both sides
     * of a border between sectors alike; then each step of @p divisions divides the elements with
     * these numbers. */
    RefinedMesh(const Body                                   &body,
                const std::vector<LocalRefinement>           &refinements,
                const std::vector<std::vector<unsigned int>> &divisions = {});

    /** Sector 0 with its own nodes, divided as in the @p whole body. */
    RefinedMesh(const std::vector<Vector3>   &nodes,
                const std::vector<CellNodes> &elements,
                const RefinedMesh            &whole);

    const dealii::Triangulation<3> &triangulation() const
    {
      return *triangulation_;
    }
    bool is_refined() const
    {
      return is_refined_;
    }
    const std::vector<Element> &elements() const
    {
      return elements_;
    }
    /** The first element of the body's element @p parent; of the number of these, all. */
    unsigned int first_of(const unsigned int parent) const
    {
      return first_[parent];
    }
    unsigned int n_parents() const
    {
      return first_.size() - 1;
    }

  private:
    /** Makes the body's mesh an own one, which can be divided. */
    void copy(const Body &body);
    void list_elements();
    void add_elements(const Cell &cell, unsigned int parent, unsigned int faces);

    std::unique_ptr<dealii::Triangulation<3>> own_; ///< of divided meshes and of sectors
    const dealii::Triangulation<3>           *triangulation_;
    bool                                      is_refined_ = false;
    std::vector<Element>                      elements_;
    std::vector<unsigned int>                 first_;
  };
} // namespace vfife

#endif
