// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_stress_fillet_readings_h
#define vfife_tests_stress_fillet_readings_h

#include <vfife/output/measures/root_stress.h>
#include <vfife/study/fillets/facet_readings.h>

#include <deque>

/** Strains of all facets of fillets of sector 0. */
inline std::vector<vfife::PointReading> read_fillets(const vfife::FemSpace                 &sector,
                                                     const std::deque<vfife::MemberFillet> &fillets)
{
  using namespace vfife;
  std::vector<PointReading> readings;
  for (const MemberFillet &member : fillets)
    for (unsigned int column = 0; column < member.fillet.n_columns(); ++column)
      for (unsigned int row = Fillet::first_row; row < member.fillet.end_row(); ++row)
        for (PointReading &reading : read_facet(sector, member.fillet.facet(column, row, 0)))
          readings.push_back(std::move(reading));
  return readings;
}

#endif
