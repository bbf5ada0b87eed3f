// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/modes/sector_copies.h>
#include <vfife/mesh/body_mesh.h>

namespace vfife
{
  SectorCopies::SectorCopies(const FemSpace       &sector,
                             const FemSpace       &whole,
                             const FemSpace::Part &part)
    : sector_of_(part.n_points)
    , original_of_(part.n_points)
    , copies_(whole.model().bodies[part.body].structure().n_sectors(),
              std::vector<unsigned int>(sector.n_points()))
  {
    std::vector<bool> is_image(sector.n_points(), false);
    for (const auto &image : sector.images())
      is_image[image.first] = true;
    for (unsigned int p = 0; p < sector.n_points(); ++p)
      if (!is_image[p])
        own_.push_back(p);
    for (unsigned int k = 0; k < copies_.size(); ++k)
      for (unsigned int e = 0; e < sector.n_elements(); ++e)
        for (unsigned int a = 0; a < sector.points_per_element(); ++a)
          {
            const unsigned int p = sector.element_points(e)[a];
            if (is_image[p])
              continue;
            const unsigned int point =
              whole.element_points(part.first_element + k * sector.n_elements() + e)[a] -
              part.first_point;
            copies_[k][p]       = point;
            sector_of_[point]   = k;
            original_of_[point] = p;
          }
  }
} // namespace vfife
