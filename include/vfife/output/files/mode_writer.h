// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_mode_writer_h
#define vfife_output_files_mode_writer_h

#include <vfife/output/formats/vtu_writer.h>

#include <string>
#include <vector>

namespace vfife
{
  class Body;
  class OutputFolder;
  struct MeshFields;

  /** Displacements of the points of a grid, 3 a point, under a name such as "mode 3". */
  struct NamedShape
  {
    std::string         name;
    std::vector<double> displacements;
    std::string         unit = ""; ///< of shapes, whose size is arbitrary: none
  };

  /** "mode 3, 1034.2 Hz", the third with @p index 2 and this frequency [Hz]. */
  std::string shape_name(std::size_t index, double frequency);

  /** Nodes and elements of @p body, undeformed in its place at time zero. */
  VtuGrid make_grid(const Body &body);

  /** Writes @p shapes as vectors and @p fields of the points of @p grid to the .vtu file @p name;
   * the writing rank only. */
  void write_shapes(const OutputFolder            &folder,
                    const std::string             &name,
                    VtuGrid                        grid,
                    const std::vector<NamedShape> &shapes,
                    std::vector<VtuArray>          fields = {});

  /**
   * Writes fields on the mesh on which they are computed, points between nodes included, to the
   * file
   * @p name + ".pvtu" and one .vtu file per rank beside it; nothing where there is no folder on a
   * disk. Collective.
   */
  void
  write_mesh_fields(const OutputFolder &folder, const std::string &name, const MeshFields &fields);
} // namespace vfife

#endif
