// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_pressure_facets_passed_h
#define vfife_study_pressure_facets_passed_h

#include <vfife/fem/pressure/flank_pair.h>

#include <map>
#include <utility>

namespace vfife
{
  struct Model;

  /**
   * How many facets of a flank the contact passes per gear mesh: the mesh excites the pair with
   * orders of the gear mesh near these numbers, and contact points with so many times these as a
   * facet has points in that direction.
   */
  class FacetsPassed
  {
  public:
    /** Contacts at the next one of positions that are @p spacing gear meshes apart. */
    FacetsPassed(const Model &model, double spacing);

    void add(const std::vector<ToothPressure> &teeth);

    /** Of a @p side, 0 slave and 1 master: along the face and along the profile. Means over the
     * ways of all contacts; zero where no contact was seen twice. */
    Vector2 find(unsigned int side) const;

  private:
    /** Middle of a contact on a flank, and the sides of the facet there, along the face first. */
    struct Place
    {
      Vector3                     middle = Vector3::Zero();
      Eigen::Matrix<double, 3, 2> sides;
    };

    const Model                                                          &model_;
    double                                                                spacing_;
    std::map<std::pair<unsigned int, unsigned int>, std::array<Place, 2>> last_; ///< by groups
    std::array<Vector2, 2>                                                sums_;
    unsigned int                                                          n_ = 0;
  };
} // namespace vfife

#endif
