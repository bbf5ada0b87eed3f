// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_figures_h
#define vfife_output_files_figures_h

#include <vfife/base/text/json.h>

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class OutputFolder;

  /** A number with its unit, as written. */
  struct Figure
  {
    double      value = 0;
    std::string unit;
  };

  /** Figures in the order in which they are written. */
  using NamedFigures = std::vector<std::pair<std::string, Figure>>;

  /** {"value": , "unit": } */
  Json figure_json(double value, const std::string &unit);

  /** {name: {"value": , "unit": }...} */
  Json figures_json(const NamedFigures &figures);

  /** The text of a JSON file; bytes that are no UTF-8 (names of files) are replaced, numbers that
   * are not finite become null. */
  std::string json_text(const Json &json);

  /** Writes a JSON file into the folder; only the writing rank does. */
  void write_json(const OutputFolder &folder, const std::string &name, const Json &json);
} // namespace vfife

#endif
