// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "phasor_rows.h"

namespace vfife
{
  PhasorRows make_phasor_rows(const Assembly               &assembly,
                              const unsigned int            harmonic,
                              const std::vector<SectorRow> &rows)
  {
    const Unknowns                      &unknowns = assembly.unknowns();
    const std::size_t                    copy     = 3 * std::size_t(assembly.space().n_points());
    const double                         angle    = harmonic * assembly.space().sector_angle();
    std::vector<Eigen::Triplet<Complex>> entries;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const SectorTerm &term : rows[i])
        for (unsigned int part = 0; part < unknowns.n_copies(); ++part)
          {
            const Complex phase =
              std::polar(1., term.sector * angle) * (part == 0 ? Complex(1.) : Complex(0., 1.));
            for (unsigned int c = 0; c < 3; ++c)
              {
                const std::size_t row = part * copy + 3 * std::size_t(term.point) + c;
                for (const auto *t = unknowns.begin(row); t != unknowns.end(row); ++t)
                  entries.emplace_back(i, t->unknown, phase * (term.weight[c] * t->coefficient));
              }
          }
    PhasorRows matrix(rows.size(), unknowns.n());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
} // namespace vfife
