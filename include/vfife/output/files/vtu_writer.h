// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_vtu_writer_h
#define vfife_output_files_vtu_writer_h

#include <vfife/base/types.h>
#include <vfife/element/stress.h>
#include <vfife/mesh/body_mesh.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace vfife
{
  /** Numbers at the points or in the cells of a grid: one, three of a vector, six of a symmetric
   * tensor (xx yy zz xy yz zx), one after the other. */
  struct VtuArray
  {
    std::string        name, unit; ///< written as "name [unit]"; no unit: empty
    unsigned int       n_components = 1;
    std::vector<float> values       = {};
  };

  /** Arrays of a field file that show stresses [MPa], without values: along r, theta, z, the tensor
   * along the fixed axes, principal stresses, von Mises. */
  std::vector<VtuArray> make_stress_arrays();

  /** Appends the same stress in both axes to those arrays, which begin at @p arrays; returns the
   * one behind them. */
  std::vector<VtuArray>::iterator add_stress(const Stress                   &cylindrical,
                                             const Stress                   &fixed,
                                             std::vector<VtuArray>::iterator arrays);

  /** Hexahedra that share their points, in the fixed frame [mm]. */
  struct VtuGrid
  {
    std::vector<float>     points; ///< x y z of each
    std::vector<CellNodes> cells;  ///< by their points
    std::vector<VtuArray>  point_data, cell_data;

    void add_point(const Vector3 &x);
  };

  /** Writes @p grid as a .vtu file, numbers compressed, with @p time [s] unless it is not a number.
   */
  void write_vtu(std::ostream &out, const VtuGrid &grid, double time);

  /** Writes the .pvtu file of @p pieces, files in the same folder, that have arrays as @p grid. */
  void write_pvtu(std::ostream &out, const VtuGrid &grid, const std::vector<std::string> &pieces);
} // namespace vfife

#endif
