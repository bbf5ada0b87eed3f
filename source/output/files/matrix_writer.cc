// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/output/files/matrix_writer.h>
#include <vfife/output/files/output_folder.h>

#include <iomanip>
#include <limits>
#include <ostream>

namespace vfife
{
  void write_matrix_market(const OutputFolder    &folder,
                           const std::string     &name,
                           const Eigen::MatrixXd &matrix,
                           const std::string     &comment)
  {
    if (!folder.is_writer())
      return;
    folder.write_file(name, [&](std::ostream &out) {
      out << "%%MatrixMarket matrix coordinate real general\n% " << comment << '\n'
          << matrix.rows() << ' ' << matrix.cols() << ' ' << (matrix.array() != 0.).count() << '\n'
          << std::setprecision(std::numeric_limits<double>::max_digits10);
      for (Eigen::Index k = 0; k < matrix.cols(); ++k)
        for (Eigen::Index i = 0; i < matrix.rows(); ++i)
          if (matrix(i, k) != 0.)
            out << i + 1 << ' ' << k + 1 << ' ' << matrix(i, k) << '\n';
    });
  }
} // namespace vfife
