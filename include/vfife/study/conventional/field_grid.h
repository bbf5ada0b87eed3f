// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_field_grid_h
#define vfife_study_conventional_field_grid_h

#include <vfife/fem/system/fem_space.h>
#include <vfife/output/formats/vtu_writer.h>

#include <vector>

namespace vfife
{
  /** One body of a space as field files show it, undeformed: with 8-node elements its nodes and own
   * elements, else all points and elements. Points of cubic elements move to evenly spaced places,
   * where VTK expects them. */
  class FieldGrid
  {
  public:
    FieldGrid(const FemSpace &space, const FemSpace::Part &part);
    /** Its nodes and elements, whose values are given in their order. */
    explicit FieldGrid(const Body &body);

    VtuGrid make_grid() const;

    const Body &body() const
    {
      return body_;
    }
    unsigned int n_points() const
    {
      return space_ ? part_.n_points : part_.n_nodes;
    }
    /** The place of a point in the body's own frame. */
    Vector3 reference(unsigned int point) const;

    /** Values at these points of @p n_components values at each point of the space. */
    std::vector<double> take(const double *values, unsigned int n_components) const;
    std::vector<double> take(const std::vector<double> &vectors) const
    {
      return take(vectors.data(), 3);
    }

  private:
    const Body         &body_;
    const FemSpace     *space_; ///< none: nodes alone
    FemSpace::Part      part_;
    std::vector<double> places_; ///< of all points, fixed frame [mm]
  };
} // namespace vfife

#endif
