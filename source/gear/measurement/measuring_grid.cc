// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_grid.h>
#include <vfife/base/parameters/parameter_table.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/gear/errors/member_error_options.h>
#include <vfife/gear/measurement/measuring_grid.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Whether the file is a table with positions. */
    bool has_positions(const Table &table)
    {
      return std::any_of(table.columns().begin(),
                         table.columns().end(),
                         [](const Table::Column &column) { return column.name == "x"; });
    }

    /** Positions, wherever they were taken; nothing where the file is no table with them. */
    std::optional<std::vector<Vector3>> read_positions(const std::string &path)
    {
      // What is no table has numbers alone.
      if (!has_headings(path))
        return {};
      const Table table = read_parameter_table(path);
      if (!has_positions(table))
        return {};
      const std::vector<double> x = find_column(table, path, "x", "mm"),
                                y = find_column(table, path, "y", "mm"),
                                z = find_column(table, path, "z", "mm");
      std::vector<Vector3> points;
      for (std::size_t i = 0; i < x.size(); ++i)
        points.emplace_back(x[i], y[i], z[i]);
      return points;
    }

    /** Throws InputError for a point of another flank or tooth, which no fit could follow: one that
     * lies more than half a tooth from the flank about the axis. */
    void check_positions(const std::vector<Vector3> &points,
                         const std::string          &path,
                         const GearGeometry         &gear,
                         const FlankSide             side)
    {
      for (const Vector3 &x : points)
        {
          const Vector2 L_h  = gear.blank().coordinates_of(x);
          const Vector3 foot = gear.flank_point(side, L_h[0], L_h[1]).position;
          const double turn = std::abs(std::remainder(polar_angle(foot) - polar_angle(x), 2. * pi));
          if (turn * std::hypot(x[0], x[1]) <= .5 * gear.tooth_thickness(L_h[0], L_h[1]))
            continue;
          std::ostringstream message;
          message << path << ": expected points of the " << name_of(side)
                  << " flank of tooth 0, got (" << x[0] << ", " << x[1] << ", " << x[2] << ") mm, "
                  << turn / degree
                  << " deg from this flank about the axis. Keep only points of one flank, and "
                     "rotate them to tooth 0";
          throw InputError(message.str());
        }
    }

    /** The points that have these deviations from the flank as it is designed. */
    std::vector<Vector3> read_deviations(const std::string   &path,
                                         const GearGeometry  &gear,
                                         const FlankSide      side,
                                         const MeasuringGrid &grid)
    {
      const Eigen::MatrixXd deviations  = read_deviation_grid(path);
      MeasuringGrid         own         = grid;
      own.rows                          = deviations.rows();
      own.columns                       = deviations.cols();
      const std::vector<Vector2> places = own.places(gear, side);
      std::vector<Vector3>       points;
      for (std::size_t i = 0; i < places.size(); ++i)
        {
          const SurfacePoint point = gear.flank_point(side, places[i][0], places[i][1]);
          points.push_back(point.position - micrometre *
                                              deviations(i / own.columns, i % own.columns) *
                                              point.normal);
        }
      return points;
    }
  } // namespace

  void MeasuringGrid::declare(dealii::ParameterHandler &prm)
  {
    declare_integer(prm, "rows", rows, "Grid points from tip to root", 2, 1000);
    declare_integer(prm, "columns", columns, "Grid points from toe to heel", 2, 1000);
    margins.declare(prm);
  }

  std::vector<Vector2> MeasuringGrid::places(const GearGeometry &gear, const FlankSide side) const
  {
    const FlankArea      area(gear, side, margins);
    std::vector<Vector2> places;
    for (unsigned int row = 0; row < rows; ++row)
      for (unsigned int column = 0; column < columns; ++column)
        places.push_back(area.point_at({column / (columns - 1.), 1. - row / (rows - 1.)}));
    return places;
  }

  Table compute_measuring_grid(const GearGeometry  &gear,
                               const FlankSide      side,
                               const unsigned int   tooth,
                               const MeasuringGrid &grid)
  {
    Table table{{"row", "-"}, {"column", "-"}};
    for (const char *name : {"L", "h", "x", "y", "z"})
      table.add_column(name, "mm");
    for (const char *name : {"normal x", "normal y", "normal z"})
      table.add_column(name, "-");
    table.add_column("deviation", "um");
    const std::vector<Vector2> places = grid.places(gear, side);
    for (unsigned int i = 0; i < places.size(); ++i)
      {
        const SurfacePoint point     = gear.flank_point(side, places[i][0], places[i][1]);
        const double       deviation = gear.deviation(side, tooth, point);
        const Vector3      normal = -point.normal, position = point.position + deviation * normal;
        table.add_row({i / grid.columns + 1,
                       i % grid.columns + 1,
                       places[i][0],
                       places[i][1],
                       position[0],
                       position[1],
                       position[2],
                       normal[0],
                       normal[1],
                       normal[2],
                       deviation / micrometre});
      }
    return table;
  }

  std::vector<Vector3> read_measured_points(const std::string   &path,
                                            const GearGeometry  &gear,
                                            const FlankSide      side,
                                            const MeasuringGrid &grid)
  {
    // Text has any ending, its content says what it is. A format with an ending of its own is asked
    // for before.
    if (const auto positions = read_positions(path))
      {
        check_positions(*positions, path, gear, side);
        return *positions;
      }
    return read_deviations(path, gear, side, grid);
  }
} // namespace vfife
