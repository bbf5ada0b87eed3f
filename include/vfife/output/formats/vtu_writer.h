// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_formats_vtu_writer_h
#define vfife_output_formats_vtu_writer_h

#include <vfife/base/types.h>
#include <vfife/element/stress.h>

#include <cstddef>
#include <cstdint>
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

  /** Hexahedra of one degree that share their points, in the fixed frame [mm]. */
  struct VtuGrid
  {
    unsigned int       degree = 1;   ///< 1, 2 or 3: degree + 1 evenly spaced points along each edge
    std::vector<float> points;       ///< x y z of each
    std::vector<unsigned int> cells; ///< points of each, in deal.II's lexicographic order
    std::vector<VtuArray>     point_data, cell_data;

    void         add_point(const Vector3 &x);
    unsigned int points_per_cell() const
    {
      return (degree + 1) * (degree + 1) * (degree + 1);
    }
    std::size_t n_cells() const
    {
      return cells.size() / points_per_cell();
    }
    /** The points of the cells, of each in VTK's order of files before version 2.2. */
    std::vector<std::int32_t> connectivity() const;
  };

  /** Writes @p grid as a .vtu file, numbers compressed, with @p time [s] unless it is not a number.
   */
  void write_vtu(std::ostream &out, const VtuGrid &grid, double time);

  /** Writes the .pvtu file of @p pieces, files in the same folder, that have arrays as @p grid. */
  void write_pvtu(std::ostream &out, const VtuGrid &grid, const std::vector<std::string> &pieces);
} // namespace vfife

#endif
