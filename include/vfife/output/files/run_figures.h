// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_run_figures_h
#define vfife_output_files_run_figures_h

#include <vfife/output/files/figures.h>

#include <string>

namespace vfife
{
  class OutputFolder;
  class RootStress;

  /** What summary.json tells of a run, for tables of several runs. */
  struct RunFigures
  {
    std::string  status; ///< "finished", "failed"; empty: there is no summary that can be read
    std::string  failure;
    NamedFigures figures; ///< always the same names; NaN where the run has none
  };

  /** Reads summary.json in @p folder: steps, times, energy error, means and peaks of contact force
   * and transmission error over the steady part, parts of the transmission error. */
  RunFigures read_run_figures(const std::string &folder);

  /** Whether a figure of read_run_figures() says how a run was computed, as its steps, and not what
   * it has found. */
  bool tells_of_computation(const std::string &figure);

  /** The number at a JSON pointer of a JSON file (result_places.h), which may be that of a figure
   * or a switch (0 or 1); NaN where there is none. */
  double read_figure(const std::string &path, const std::string &pointer);

  /** The quantities of geometry.json in @p folder by the member's name and their own, as "gear web
   * thickness"; none where there is no such file, as of models without gears. */
  NamedFigures read_geometry(const std::string &folder);

  /** Root tension, compression and stress range of both members. */
  NamedFigures list_root_figures(const RootStress &stress);

  /** figures.json: what a study without a summary has found, for tables of cases. Only the writing
   * rank writes. */
  void write_own_figures(const OutputFolder &folder, const NamedFigures &figures);

  /** Figures by names that depend on the case, of the folder of each: those of figures.json, of
   * summary.json root stresses and stresses of probes per revolution. All cases with the same names
   * and units: NaN where one has no such figure. */
  std::vector<NamedFigures> read_own_figures(const std::vector<std::string> &folders);
} // namespace vfife

#endif
