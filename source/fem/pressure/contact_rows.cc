// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_rows.h"

namespace vfife
{
  ContactRows::ContactRows(const ContactLoad &load)
  {
    for (Eigen::Index k = 0; k < load.forces.size(); ++k)
      if (load.forces[k] != 0.)
        first_.emplace(k / 3, 0);
  }

  void ContactRows::add(const ElasticContact &contact, const ContactCell &cell)
  {
    for (unsigned int side = 0; side < 2; ++side)
      for (const unsigned int node : cell.feet[side].nodes)
        first_.emplace(contact.flanks[side].places[node], 0);
  }

  std::vector<unsigned int> ContactRows::number()
  {
    std::vector<unsigned int> rows;
    for (auto &place : first_)
      {
        place.second = rows.size();
        for (unsigned int c = 0; c < 3; ++c)
          rows.push_back(3 * place.first + c);
      }
    return rows;
  }

  void ContactRows::append_gap(const ElasticContact &contact,
                               const ContactCell    &cell,
                               const Eigen::Index    row,
                               Entries              &entries) const
  {
    for (unsigned int side = 0; side < 2; ++side)
      {
        const ElasticFlank &flank = contact.flanks[side];
        const CellFoot     &foot  = cell.feet[side];
        const Vector3 along = (side == 0 ? 1. : -1.) * (flank.rotation.transpose() * cell.normal);
        for (unsigned int k = 0; k < 4; ++k)
          for (unsigned int c = 0; c < 3; ++c)
            entries.emplace_back(row,
                                 first_.at(flank.places[foot.nodes[k]]) + c,
                                 foot.weights[k] * along[c]);
      }
  }
} // namespace vfife
