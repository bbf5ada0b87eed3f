// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "phasor_rows.h"

namespace vfife
{
  PhasorRows make_phasor_rows(const FemSystem              &system,
                              const unsigned int            harmonic,
                              const std::vector<SectorRow> &rows)
  {
    const FemConstraints                &constraints = system.constraints();
    const std::size_t                    copy        = 3 * std::size_t(system.space().n_points());
    const double                         angle       = harmonic * system.space().sector_angle();
    std::vector<Eigen::Triplet<Complex>> entries;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const SectorTerm &term : rows[i])
        for (unsigned int part = 0; part < constraints.n_copies(); ++part)
          {
            const Complex phase =
              std::polar(1., term.sector * angle) * (part == 0 ? Complex(1.) : Complex(0., 1.));
            for (unsigned int c = 0; c < 3; ++c)
              {
                const std::size_t row = part * copy + 3 * std::size_t(term.point) + c;
                for (const auto &[unknown, coefficient] : constraints.line(row))
                  entries.emplace_back(i, unknown, phase * (term.weight[c] * coefficient));
              }
          }
    PhasorRows matrix(rows.size(), constraints.n());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
} // namespace vfife
