// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_stress_fillet_h
#define vfife_stress_fillet_h

#include <vfife/base/types.h>
#include <vfife/stress/surface_stress.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  class Body;
  class BodyStructure;

  /**
   * The free surface of one fillet of all sectors of a gear body as a grid of facets. Fillet of a
   * tooth: columns from toe to heel, rows up the profile from the root land to the start of the
   * flank. Fillet of the web at the hub: columns round the axis, rows from the hub to the web.
   * Beside the fillet's own rows the grid knows one row of the surface below and one of that above,
   * onto which gauges may reach.
   */
  class Fillet
  {
  public:
    /** Sides with fillets at the hub: of the web's faces towards the apex and the back. */
    static constexpr char hub_front[] = "hub front";
    static constexpr char hub_back[]  = "hub back";

    /** Sides of a gear body that have a fillet. */
    static std::vector<std::string> list_sides(const Body &body);

    /**
     * @p side: "concave" or "convex", as the surfaces of its flanks, "hub front" or "hub back".
     * Throws InputError where the body has no such fillet.
     */
    Fillet(const Body &body, const std::string &side);

    const std::string &side() const
    {
      return side_;
    }
    /** Whether it is of the web, not of teeth. */
    bool is_at_hub() const
    {
      return is_at_hub(side_);
    }
    static bool is_at_hub(const std::string &side)
    {
      return side == hub_front || side == hub_back;
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

    /** Those of all teeth. */
    std::vector<unsigned int> list_nodes() const;

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

    /** Body::initial_strain() of the element under a facet, which causes no stress [-]. */
    double initial_strain(unsigned int column, unsigned int row, unsigned int tooth) const;
    /** The part of a facet's @p strain that causes stress. */
    SurfaceTensor without_initial_strain(const SurfaceTensor &strain,
                                         unsigned int         column,
                                         unsigned int         row,
                                         unsigned int         tooth) const;

  private:
    std::size_t index(const unsigned int column, const unsigned int row) const
    {
      return std::size_t(column) * (n_rows_ + 1) + row;
    }
    void find_nodes_of_tooth(const Body &body);
    void find_nodes_at_hub(const Body &body);
    void measure(const Body &body);
    void find_initial_strains(const Body &body);

    std::string               side_;
    Material                  material_;
    const BodyStructure      *structure_;
    unsigned int              n_columns_ = 0, n_rows_ = 0;
    bool                      mirrored_ = false; ///< seen from outside column 0 is on the right
    std::vector<unsigned int> nodes_;            ///< of tooth 0 by index()
    std::vector<double>       face_, profile_;
    std::vector<double>       initial_strains_; ///< by tooth, column and row; empty: none
  };
} // namespace vfife

#endif
