// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/gear/spiral_bevel/gear_pair.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/conventional/loaded_contact_tables.h>
#include <vfife/study/conventional/loaded_pattern.h>
#include <vfife/study/conventional/loaded_pressure.h>

#include <algorithm>
#include <numeric>

namespace vfife
{
  namespace
  {
    /** The largest pressure of cells that are farther than the contact's width from all that carry
     * at an edge; 0: there is none. */
    double find_largest_inside(const GridPressure &grid)
    {
      double largest = 0;
      for (std::size_t i = 0; i < grid.cells.size(); ++i)
        {
          bool inside = true;
          for (std::size_t k = 0; inside && k < grid.cells.size(); ++k)
            inside = !grid.at_edge[k] ||
                     (grid.cells[i].position - grid.cells[k].position).norm() > grid.width;
          if (inside)
            largest = std::max(largest, grid.pressures[i]);
        }
      return largest;
    }
  } // namespace

  LoadedPressure::LoadedPressure(const GearPair    &pair,
                                 Compliance        &compliance,
                                 const double       depth,
                                 const unsigned int cells_across)
    : blanks_{{pair.pinion().blank(), pair.gear().blank()}}
    , pressure_(compliance, depth, cells_across)
    , teeth_(make_loaded_pressure_table())
    , cells_(make_loaded_pressure_field_table())
  {
  }

  void LoadedPressure::add_position(const double                 position,
                                    const double                 error,
                                    const PairEquilibrium       &equilibrium,
                                    const PairEquilibriumResult &result,
                                    Log                         &log)
  {
    const PairPressures found = pressure_.solve(equilibrium, result);
    errors_.push_back((error + found.lead) / arcsecond);
    double torque = 0, largest = 0;
    for (const ToothPressure &tooth : found.teeth)
      {
        torque += tooth.grid.moment;
        largest = std::max(largest, tooth.grid.pressures[tooth.grid.largest()]);
      }
    for (const ToothPressure &tooth : found.teeth)
      add_tooth(position, errors_.back(), torque, tooth);
    log.line("  pressure on its own grid: ",
             found.teeth.size(),
             " teeth, largest ",
             largest,
             " MPa, transmission error ",
             errors_.back(),
             " arcsec");
  }

  void LoadedPressure::add_tooth(const double         position,
                                 const double         error,
                                 const double         torque,
                                 const ToothPressure &tooth)
  {
    // The slave is the pinion's.
    const GridPressure &grid   = tooth.grid;
    const auto          places = [&](const std::size_t cell) {
      std::array<Vector2, 2> both;
      for (unsigned int side = 0; side < 2; ++side)
        {
          const Vector3 &x = tooth.places[side][cell];
          both[side] = place_on_flank(blanks_[side], Vector2(x.head<2>().norm(), x[2]));
        }
      return both;
    };
    const std::size_t largest = grid.largest();
    const auto        at      = places(largest);
    // Tooth 0 is in the middle of its mesh at position 0, the one before it (the last) a tooth mesh
    // later.
    const int teeth = blanks_[0].teeth, tooth_before = tooth.slave_group;
    const int after = tooth_before > teeth / 2 ? tooth_before - teeth : tooth_before;
    teeth_.add_row({position,
                    tooth.slave_group,
                    tooth.master_group,
                    position + after,
                    grid.force,
                    1e-3 * grid.moment,
                    grid.moment / torque,
                    grid.pressures[largest],
                    find_largest_inside(grid),
                    grid.at_edge[largest] ? 1 : 0,
                    grid.area,
                    grid.width,
                    grid.length,
                    at[0][0],
                    at[0][1],
                    at[1][0],
                    at[1][1],
                    error});
    for (std::size_t i = 0; i < grid.cells.size(); ++i)
      {
        const auto on = places(i);
        cells_.add_row({position,
                        tooth.slave_group,
                        tooth.master_group,
                        on[0][0],
                        on[0][1],
                        on[1][0],
                        on[1][1],
                        grid.pressures[i]});
      }
  }

  void LoadedPressure::write(const OutputFolder &folder) const
  {
    write_csv(folder, "pressure.csv", teeth_);
    write_csv(folder, "pressure_field.csv", cells_);
  }

  NamedFigures LoadedPressure::list_figures() const
  {
    NamedFigures figures;
    for (const char *name : {column::largest_pressure, column::largest_pressure_inside})
      {
        const std::vector<double> &values = teeth_.numbers(name);
        figures.push_back({std::string(name) + " on its own grid",
                           {*std::max_element(values.begin(), values.end()), "MPa"}});
      }
    const auto ends = std::minmax_element(errors_.begin(), errors_.end());
    figures.push_back(
      {"transmission error without penalty mean",
       {std::accumulate(errors_.begin(), errors_.end(), 0.) / errors_.size(), "arcsec"}});
    figures.push_back(
      {"transmission error without penalty peak to peak", {*ends.second - *ends.first, "arcsec"}});
    return figures;
  }
} // namespace vfife
