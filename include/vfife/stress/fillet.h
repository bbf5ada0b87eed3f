// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_stress_fillet_h
#define vfife_stress_fillet_h

#include <vfife/base/types.h>
#include <vfife/element/material.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  class Body;
  class BodyStructure;

  /**
   * The free surface of one side's fillet of all teeth of a gear body as a grid of facets: columns
   * from toe to heel, rows up the profile from the root land to the start of the flank. Beside the
   * fillet's own rows the grid knows one row of the root land below and one of the flank above,
   * onto which gauges may reach.
   */
  class Fillet
  {
  public:
    /**
     * @p side: "concave" or "convex", as the surfaces of its flanks. Throws InputError where the
     * body has no such fillet.
     */
    Fillet(const Body &body, const std::string &side);

    const std::string &side() const
    {
      return side_;
    }
    /** Of the elements under it. */
    const Material &material() const
    {
      return material_;
    }
    unsigned int n_teeth() const;
    /** Facets along the face. */
    unsigned int n_columns() const
    {
      return n_columns_;
    }
    /** Facets along the profile, the rows below and above the fillet included. */
    unsigned int n_rows() const
    {
      return n_rows_;
    }
    /** The fillet's own rows are first_row ... end_row() - 1. */
    static constexpr unsigned int first_row = 1;
    unsigned int                  end_row() const
    {
      return n_rows_ - 1;
    }

    /** Node of the body at the line @p column <= n_columns() and @p row <= n_rows() of a tooth. */
    unsigned int node(unsigned int column, unsigned int row, unsigned int tooth) const;

    /** Corners of a facet, counter-clockwise seen from outside; the first side runs along the face.
     */
    std::array<unsigned int, 4>
    facet(unsigned int column, unsigned int row, unsigned int tooth) const;

    /** Length along the line of nodes @p row from the toe [mm]. */
    double face_length(unsigned int column, unsigned int row) const
    {
      return face_[index(column, row)];
    }
    /** Length up the profile @p column from the fillet's bottom [mm], negative on the root land. */
    double profile_length(unsigned int column, unsigned int row) const
    {
      return profile_[index(column, row)];
    }

    /** Centre of a facet unrolled: (along the face, up the profile) [mm]. */
    Vector2 centre(unsigned int column, unsigned int row) const;

  private:
    std::size_t index(const unsigned int column, const unsigned int row) const
    {
      return std::size_t(column) * (n_rows_ + 1) + row;
    }
    void find_nodes(const Body &body);
    void measure(const Body &body);

    std::string               side_;
    Material                  material_;
    const BodyStructure      *structure_;
    unsigned int              n_columns_ = 0, n_rows_ = 0;
    bool                      mirrored_ = false; ///< seen from outside the toe is on the right
    std::vector<unsigned int> nodes_;            ///< of tooth 0 by index()
    std::vector<double>       face_, profile_;
  };
} // namespace vfife

#endif
