// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_files_grid_collector_h
#define vfife_mesh_files_grid_collector_h

#include "file_mesh.h"
#include "mesh_text.h"

#include <string>
#include <vector>

namespace vfife
{
  /** Hexahedra and faces of a format without names: cells have an id, which is that of a region
   * ("region 1") or, of quadrilaterals, of a boundary ("boundary 2"); 0 and less are none there. */
  class GridCollector
  {
  public:
    GridCollector(const std::string &path, MeshText &text);

    void        add_node(const Vector3 &x);
    std::size_t n_nodes() const;

    /** @p order: place in CellNodes of each of @p nodes. */
    void add_hexahedron(const std::vector<unsigned int> &nodes,
                        const unsigned int (&order)[8],
                        long         id,
                        unsigned int line);
    /** Nodes in turn. */
    void add_face(const std::vector<unsigned int> &nodes, long id, unsigned int line);

    void add_note(const std::string &note);
    void add_warning(const std::string &warning);

    FileMesh finish();

  private:
    const std::string &path_;
    MeshText          &text_;
    FileMesh           mesh_;
    FileMesh::Members  regions_;
    FileMesh::Surfaces surfaces_;
  };
} // namespace vfife

#endif
