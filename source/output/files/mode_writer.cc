// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/types.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/mesh_fields.h>
#include <vfife/model/body.h>
#include <vfife/output/files/mode_writer.h>
#include <vfife/output/files/output_folder.h>

#include <deal.II/numerics/data_out.h>

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

  void
  write_mesh_fields(const OutputFolder &folder, const std::string &name, const MeshFields &fields)
  {
    if (!folder.is_on_disk())
      return;
    dealii::DataOut<3>            out;
    const unsigned int            degree = fields.dofs.get_fe().degree;
    dealii::DataOutBase::VtkFlags flags;
    flags.write_higher_order_cells = degree > 1;
    out.set_flags(flags);
    out.attach_dof_handler(fields.dofs);
    const std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation> vectors(
      3, dealii::DataComponentInterpretation::component_is_part_of_vector);
    for (const auto &[field, values] : fields.fields)
      out.add_data_vector(*values,
                          std::vector<std::string>(3, field),
                          dealii::DataOut<3>::type_dof_data,
                          vectors);
    out.build_patches(fields.mapping, degree, dealii::DataOut<3>::curved_inner_cells);

    const Communicator      &ranks = folder.communicator();
    std::vector<std::string> pieces;
    for (unsigned int r = 0; r < ranks.size(); ++r)
      pieces.push_back(name + "_" + std::to_string(r) + ".vtu");
    folder.write_file(pieces[ranks.rank()], [&](std::ostream &file) { out.write_vtu(file); });
    if (!folder.is_writer())
      return;
    // The record names its pieces from its own folder.
    for (std::string &piece : pieces)
      piece.erase(0, piece.find_last_of('/') + 1);
    folder.write_file(name + ".pvtu",
                      [&](std::ostream &file) { out.write_pvtu_record(file, pieces); });
  }
} // namespace vfife
