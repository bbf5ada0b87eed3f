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

  namespace
  {
    /** Places of the flexibility and their weights. */
    std::array<std::pair<unsigned int, double>, 4>
    find_places(const ElasticFlank &flank, const CellFoot &foot, const ContactRows::At at)
    {
      std::array<std::pair<unsigned int, double>, 4> places;
      if (at == ContactRows::At::nodes)
        for (unsigned int k = 0; k < 4; ++k)
          places[k] = {flank.places[foot.nodes[k]], foot.weights[k]};
      else
        {
          const FlankFoot on_part = flank.find(foot);
          for (unsigned int k = 0; k < 4; ++k)
            places[k] = {on_part.part->places[k], on_part.weights[k]};
        }
      return places;
    }
  } // namespace

  void ContactRows::add(const ElasticContact &contact, const ContactCell &cell, const At at)
  {
    for (unsigned int side = 0; side < 2; ++side)
      for (const auto &place : find_places(contact.flanks[side], cell.feet[side], at))
        first_.emplace(place.first, 0);
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
                               const At              at,
                               const Eigen::Index    row,
                               Entries              &entries) const
  {
    for (unsigned int side = 0; side < 2; ++side)
      {
        const ElasticFlank &flank = contact.flanks[side];
        const Vector3 along = (side == 0 ? 1. : -1.) * (flank.rotation.transpose() * cell.normal);
        for (const auto &[place, weight] : find_places(flank, cell.feet[side], at))
          for (unsigned int c = 0; c < 3; ++c)
            entries.emplace_back(row, first_.at(place) + c, weight * along[c]);
      }
  }
} // namespace vfife
