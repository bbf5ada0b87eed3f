// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_grid_contact_parts_h
#define vfife_fem_pressure_grid_contact_parts_h

#include <vfife/fem/pressure/grid_contact.h>

#include <map>

namespace vfife
{
  /** The grid of one contact. */
  struct GridOfContact
  {
    const ElasticContact                     *contact;
    ContactPlane                              plane;
    std::vector<ContactCell>                  cells;   ///< all there are, those taken first
    std::map<std::array<int, 2>, std::size_t> numbers; ///< of the cells by their places
    std::size_t     n_taken = 0; ///< of the cells that may carry, the first ones
    Eigen::MatrixXd flexibility; ///< of the layers near the surfaces, in these [mm/N]

    /** Takes @p n of the cells. */
    GridOfContact(const ElasticContact &contact, const ContactPlane &plane, std::size_t n);

    /** Takes cells that lie beside one that carries, too; returns whether there were such. */
    bool extend(const Eigen::VectorXd &forces);

    GridPressure evaluate(const Eigen::VectorXd &forces, const ContactLoad &load) const;

    /** The plane along what carries, with @p n cells over its width. */
    ContactPlane refine(const GridPressure &found, unsigned int n) const;

  private:
    /** Takes the first @p n cells. Throws NumericalError where there are too many. */
    void take(std::size_t n);
  };
} // namespace vfife

#endif
