// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/types.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body.h>
#include <vfife/output/files/mode_writer.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/vtu_writer.h>

#include <cstdio>
#include <utility>

namespace vfife
{
  std::string shape_name(const std::size_t index, const double frequency)
  {
    char text[64];
    std::snprintf(text, sizeof text, "mode %zu, %.1f Hz", index + 1, frequency);
    return text;
  }

  VtuGrid make_grid(const Body &body)
  {
    VtuGrid grid;
    for (const Vector3 &X : body.node_positions())
      grid.add_point(body.placement(X));
    for (const auto &element : body.elements())
      grid.cells.insert(grid.cells.end(), element.begin(), element.end());
    return grid;
  }

  void write_shapes(const OutputFolder            &folder,
                    const std::string             &name,
                    VtuGrid                        grid,
                    const std::vector<NamedShape> &shapes,
                    std::vector<VtuArray>          fields)
  {
    if (!folder.is_writer())
      return;
    for (const NamedShape &shape : shapes)
      grid.point_data.push_back(
        {shape.name, shape.unit, 3, {shape.displacements.begin(), shape.displacements.end()}});
    for (VtuArray &field : fields)
      grid.point_data.push_back(std::move(field));
    folder.write_file(name, [&](std::ostream &out) { write_vtu(out, grid, not_known); });
  }
} // namespace vfife
