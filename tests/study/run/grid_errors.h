// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_run_grid_errors_h
#define vfife_tests_study_run_grid_errors_h

#include "../quick_pair.h"

/** Transmission errors by the contact's own grid in a folder of a loaded analysis [arcsec], one per
 * position; pressure.csv has a row per tooth pair. */
inline std::vector<double> grid_errors(const std::string &folder)
{
  const Columns            pressure = read_columns(folder + "/pressure.csv");
  std::map<double, double> errors;
  for (std::size_t i = 0; i < pressure.at("position").size(); ++i)
    errors[pressure.at("position")[i]] = pressure.at("transmission error")[i];
  std::vector<double> curve;
  for (const auto &error : errors)
    curve.push_back(error.second);
  return curve;
}

#endif
