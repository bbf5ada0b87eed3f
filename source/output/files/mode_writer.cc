// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body.h>
#include <vfife/output/files/mode_writer.h>
#include <vfife/output/files/output_folder.h>

#include <deal.II/base/data_out_base.h>

namespace vfife
{
  void write_shapes(const OutputFolder              &folder,
                    const std::string               &name,
                    const Body                      &body,
                    const std::vector<NamedShape>   &shapes,
                    const std::vector<NamedScalars> &scalars)
  {
    if (!folder.is_writer())
      return;
    // Names of the rows of a patch's data: three of one name a vector, then the scalars.
    using Patch  = dealii::DataOutBase::Patch<3, 3>;
    using Interp = dealii::DataComponentInterpretation::DataComponentInterpretation;
    std::vector<std::string>                                                 names;
    std::vector<std::tuple<unsigned int, unsigned int, std::string, Interp>> vectors;
    for (const NamedShape &shape : shapes)
      {
        vectors.emplace_back(names.size(),
                             names.size() + 2,
                             shape.name,
                             dealii::DataComponentInterpretation::component_is_part_of_vector);
        names.insert(names.end(), 3, shape.name);
      }
    for (const NamedScalars &scalar : scalars)
      names.push_back(scalar.name);

    // A patch an element: its corners in the fixed frame at time zero and the data there.
    std::vector<Patch> patches(body.n_elements());
    for (unsigned int e = 0; e < body.n_elements(); ++e)
      {
        Patch &patch         = patches[e];
        patch.patch_index    = e;
        patch.reference_cell = dealii::ReferenceCells::Hexahedron;
        // A row for each name, a column for each corner.
        patch.data.reinit(names.size(), 8);
        for (unsigned int v = 0; v < 8; ++v)
          {
            const std::size_t node = body.elements()[e][v];
            const Vector3     x    = body.placement(body.node_positions()[node]);
            for (std::size_t s = 0; s < scalars.size(); ++s)
              patch.data(3 * shapes.size() + s, v) = scalars[s].values[node];
            for (unsigned int c = 0; c < 3; ++c)
              {
                patch.vertices[v][c] = x[c];
                for (std::size_t s = 0; s < shapes.size(); ++s)
                  patch.data(3 * s + c, v) = shapes[s].displacements[3 * node + c];
              }
          }
      }
    dealii::DataOutBase::VtkFlags flags;
    flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
    folder.write_file(name, [&](std::ostream &out) {
      dealii::DataOutBase::write_vtu(patches, names, vectors, flags, out);
    });
  }
} // namespace vfife
