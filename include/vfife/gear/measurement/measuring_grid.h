// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_measurement_measuring_grid_h
#define vfife_gear_measurement_measuring_grid_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/text/table.h>
#include <vfife/gear/errors/flank_area.h>

#include <string>
#include <vector>

namespace vfife
{
  /** Where a flank is measured. */
  struct MeasuringGrid
  {
    unsigned int rows    = 5; ///< from tip to root
    unsigned int columns = 9; ///< from toe to heel
    FlankMargins margins{0.1, 0.1};

    void declare(dealii::ParameterHandler &prm);

    /** (L, h) of its points, row by row from the tip, each from toe to heel [mm]. */
    std::vector<Vector2> places(const GearGeometry &gear, FlankSide side) const;
  };

  /**
   * The points of a flank of a tooth, turned onto tooth 0, as a measurement would find them: row
   * and column from 1, (L, h) and normal out of the metal of the flank without errors, position
   * with them, deviation along the normal [um]. MemberErrorOptions reads it as a topography.
   */
  Table compute_measuring_grid(const GearGeometry  &gear,
                               FlankSide            side,
                               unsigned int         tooth,
                               const MeasuringGrid &grid);

  /**
   * Points of a measured flank, in the body frame at tooth 0 [mm], from a file. Either a table with
   * the columns "x", "y", "z" and any number of rows, or deviations [um] from @p gear's flank at
   * the points of the grid with these margins, as a topography (its own size counts). Throws
   * InputError, also for positions on another flank or tooth.
   */
  std::vector<Vector3> read_measured_points(const std::string   &path,
                                            const GearGeometry  &gear,
                                            FlankSide            side,
                                            const MeasuringGrid &grid);
} // namespace vfife

#endif
