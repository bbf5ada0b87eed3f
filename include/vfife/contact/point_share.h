// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_point_share_h
#define vfife_contact_point_share_h

namespace vfife
{
  /** Which of the points of a pair of groups a rank looks at: those of the slave facets f with
   * f % number == place. Several ranks share a pair by their places; number is 0 where a rank has
   * nothing to do with it. */
  struct PointShare
  {
    unsigned int place = 0, number = 1;

    bool empty() const
    {
      return number == 0;
    }
    bool has(const unsigned int slave_facet) const
    {
      return number > 0 && slave_facet % number == place;
    }
    bool operator==(const PointShare &other) const
    {
      return place == other.place && number == other.number;
    }
  };
} // namespace vfife

#endif
