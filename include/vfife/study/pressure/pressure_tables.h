// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_pressure_pressure_tables_h
#define vfife_study_pressure_pressure_tables_h

#include <vfife/base/text/table.h>
#include <vfife/fem/pressure/flank_pair.h>
#include <vfife/gear/blank_outline.h>
#include <vfife/output/files/figures.h>

#include <array>
#include <vector>

namespace vfife
{
  /** Where a point of a flank at radius and height @p r_z [mm] of its body frame is: along the face
   * from the mean cone distance, > 0 to the heel, and along the profile from the pitch cone, > 0 to
   * the tip [mm]. */
  Vector2 place_on_flank(const BlankOutline &blank, const Vector2 &r_z);

  /** What a row of the tables is of. */
  enum class PressureRows
  {
    positions, ///< of a loaded tooth contact analysis
    instants   ///< of a run, with their time
  };

  /** Columns of pressure.csv: a row a position and tooth pair that carries on its own grid. */
  Table make_pressure_table(PressureRows rows);

  /** Columns of pressure_field.csv: a row a position, tooth pair and cell of its grid that carries.
   */
  Table make_pressure_field_table(PressureRows rows);

  /** Outlines of pinion and gear. */
  using PairOutlines = std::array<BlankOutline, 2>;

  /** Pressures of teeth on their own grids, position by position. */
  class PressureTables
  {
  public:
    /** The model must outlive this. */
    PressureTables(const Model &model, const PairOutlines &outlines, PressureRows rows);

    struct Position
    {
      double position           = 0; ///< [mesh cycles]
      double transmission_error = 0; ///< [arcsec]
      double time               = 0; ///< of an instant [s]
    };

    /** The teeth that carry at a position. */
    void add(const Position &position, const std::vector<ToothPressure> &teeth);

    Table &teeth()
    {
      return teeth_;
    }
    const Table &teeth() const
    {
      return teeth_;
    }
    Table &cells()
    {
      return cells_;
    }
    const Table &cells() const
    {
      return cells_;
    }

    /** The largest pressures of all positions; none where no tooth has carried. */
    NamedFigures list_figures() const;

  private:
    void add_tooth(const Position &position, double torque, const ToothPressure &tooth);

    const Model &model_;
    PairOutlines outlines_;
    PressureRows rows_;
    Table        teeth_, cells_;
  };

  namespace column
  {
    constexpr char largest_pressure_inside[] = "largest pressure inside";
  } // namespace column
} // namespace vfife

#endif
