// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/body_mesh.h>

namespace vfife
{
  void create_triangulation(BodyMesh                     &mesh,
                            const std::vector<Vector3>   &nodes,
                            const std::vector<CellNodes> &hexahedra)
  {
    std::vector<dealii::Point<3>> points;
    points.reserve(nodes.size());
    for (const Vector3 &node : nodes)
      points.emplace_back(node[0], node[1], node[2]);

    std::vector<bool>                used(nodes.size(), false);
    std::vector<dealii::CellData<3>> cells(hexahedra.size());
    for (std::size_t e = 0; e < hexahedra.size(); ++e)
      for (unsigned int v = 0; v < 8; ++v)
        {
          cells[e].vertices[v]     = hexahedra[e][v];
          used.at(hexahedra[e][v]) = true;
        }
    for (std::size_t i = 0; i < used.size(); ++i)
      if (!used[i])
        throw InputError("mesh " + mesh.name + ": node " + std::to_string(i) +
                         " belongs to no element");

    mesh.triangulation.create_triangulation(points, cells, dealii::SubCellData());

    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      for (unsigned int v = 0; v < 8; ++v)
        if (cell->vertex_index(v) != hexahedra[cell->active_cell_index()][v])
          throw NumericalError("mesh " + mesh.name + ": deal.II renumbered element " +
                               std::to_string(cell->active_cell_index()));
  }
} // namespace vfife
