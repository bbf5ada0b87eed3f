// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_matrix_writer_h
#define vfife_output_files_matrix_writer_h

#include <Eigen/Core>

#include <string>

namespace vfife
{
  class OutputFolder;

  /** Writes the nonzero entries of a real matrix in the format Matrix Market (`coordinate real
   * general`), to all digits, with @p comment in a line of its own. Only the writing rank does. */
  void write_matrix_market(const OutputFolder    &folder,
                           const std::string     &name,
                           const Eigen::MatrixXd &matrix,
                           const std::string     &comment);
} // namespace vfife

#endif
