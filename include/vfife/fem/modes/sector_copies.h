// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_modes_sector_copies_h
#define vfife_fem_modes_sector_copies_h

#include <vfife/fem/system/fem_space.h>

#include <vector>

namespace vfife
{
  /** The points of a whole body as copies of the points of its sector 0, of any degree: element e
   * of sector k is the copy of element e of sector 0, point by point. */
  class SectorCopies
  {
  public:
    /** @p sector: FemSpace::sector_of() the body of @p part, of the same degree as @p whole. */
    SectorCopies(const FemSpace &sector, const FemSpace &whole, const FemSpace::Part &part);

    /** Of the sector, without images. */
    const std::vector<unsigned int> &own_points() const
    {
      return own_;
    }
    unsigned int n_points() const
    {
      return sector_of_.size();
    }
    /** Numbers of points of the whole body start at its part's first one. */
    unsigned int copy(const unsigned int point, const unsigned int sector) const
    {
      return copies_[sector][point];
    }
    unsigned int sector_of(const unsigned int point) const
    {
      return sector_of_[point];
    }
    /** The point of sector 0. */
    unsigned int original_of(const unsigned int point) const
    {
      return original_of_[point];
    }

  private:
    std::vector<unsigned int>              own_, sector_of_, original_of_;
    std::vector<std::vector<unsigned int>> copies_; ///< by sector and point
  };
} // namespace vfife

#endif
