// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_contact_rows_h
#define vfife_fem_pressure_contact_rows_h

#include <vfife/fem/pressure/elastic_contact.h>

#include <Eigen/SparseCore>

#include <map>
#include <vector>

namespace vfife
{
  /** The rows of a ContactLoad's flexibility at which its forces and the forces of cells act. */
  class ContactRows
  {
  public:
    using Entries = std::vector<Eigen::Triplet<double>>;

    /** Those of @p load that are not zero. */
    explicit ContactRows(const ContactLoad &load);

    /** Where the forces of cells act: at the points of the elements on the facets, or at the nodes
     * as those of springs between the surfaces. */
    enum class At
    {
      points,
      nodes
    };

    void add(const ElasticContact &contact, const ContactCell &cell, At at);

    /** Numbers what has been added; three rows per place, ascending. */
    std::vector<unsigned int> number();

    /** Appends the changes of the gap at a @p cell by displacements at the rows, as the @p row of a
     * matrix. */
    void append_gap(const ElasticContact &contact,
                    const ContactCell    &cell,
                    At                    at,
                    Eigen::Index          row,
                    Entries              &entries) const;

  private:
    std::map<unsigned int, unsigned int> first_; ///< row by place
  };
} // namespace vfife

#endif
