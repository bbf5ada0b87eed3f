// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_parameters_parameter_matrix_h
#define vfife_base_parameters_parameter_matrix_h

#include <Eigen/Core>

#include <string>

namespace vfife
{
  /**
   * Reads a real matrix that a user names in a parameter file, in the format Matrix Market
   * (https://math.nist.gov/MatrixMarket/formats.html): `coordinate` or `array`, `general` or
   * `symmetric`, of which the lower triangle is given.
   * @throws InputError where the file cannot be read, naming file and line.
   */
  Eigen::MatrixXd read_parameter_matrix(const std::string &path);
} // namespace vfife

#endif
