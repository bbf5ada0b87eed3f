// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/sample_measures.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/conventional/loaded_pressure.h>

#include <algorithm>
#include <sstream>

namespace vfife
{
  LoadedPressure::LoadedPressure(const Model        &model,
                                 const PairOutlines &outlines,
                                 Compliance         &compliance,
                                 const double        depth,
                                 const unsigned int  cells_across)
    : pressure_(compliance, depth, cells_across)
    , tables_(model, outlines, PressureRows::positions)
  {
  }

  double LoadedPressure::add_position(const double                 position,
                                      const double                 error,
                                      const PairEquilibrium       &equilibrium,
                                      const PairEquilibriumResult &result)
  {
    teeth_.clear();
    PairPressures found = pressure_.solve(equilibrium, result);
    errors_.push_back((error + found.lead) / arcsecond);
    tables_.add({position, errors_.back()}, found.teeth);
    teeth_   = std::move(found.teeth);
    largest_ = 0;
    for (const ToothPressure &tooth : teeth_)
      largest_ = std::max(largest_, tooth.grid.pressures[tooth.grid.largest()]);
    return found.lead;
  }

  std::string LoadedPressure::describe() const
  {
    if (errors_.empty())
      return "no pressures on their own grid";
    std::ostringstream text;
    text << "pressure on its own grid: " << teeth_.size() << " teeth, largest " << largest_
         << " MPa, transmission error " << errors_.back() << " arcsec";
    return text.str();
  }

  void LoadedPressure::write(const OutputFolder &folder) const
  {
    write_csv(folder, "pressure.csv", tables_.teeth());
    write_csv(folder, "pressure_field.csv", tables_.cells());
  }

  NamedFigures LoadedPressure::list_figures() const
  {
    NamedFigures figures = tables_.list_figures();
    if (errors_.empty())
      return figures;
    figures.push_back({"transmission error without penalty mean", {mean_of(errors_), "arcsec"}});
    if (errors_.size() > 1)
      figures.push_back(
        {"transmission error without penalty peak to peak", {peak_to_peak_of(errors_), "arcsec"}});
    return figures;
  }
} // namespace vfife
