// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_phasor_rows_h
#define vfife_fem_cyclic_phasor_rows_h

#include <vfife/base/complex.h>
#include <vfife/fem/cyclic/cyclic_body.h>

#include <Eigen/SparseCore>

namespace vfife
{
  using PhasorRows = Eigen::SparseMatrix<Complex, Eigen::RowMajor>;

  /** What the rows read of a harmonic's unknowns: phasors. The real part, transposed, are unit
   * forces along the rows, the same in all sectors but for the phase. */
  PhasorRows make_phasor_rows(const FemSystem              &system,
                              unsigned int                  harmonic,
                              const std::vector<SectorRow> &rows);
} // namespace vfife

#endif
