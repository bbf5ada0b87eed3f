// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_contact_pattern_h
#define vfife_output_measures_contact_pattern_h

#include <vfife/base/text/table.h>
#include <vfife/base/types.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  struct Model;

  /**
   * The contact pattern of a gear pair: the largest pressure (contact force of a node over its
   * area) that every place of a flank has carried on whichever tooth. Over one mesh cycle the teeth
   * in contact pass through all mesh positions.
   */
  class ContactPattern
  {
  public:
    /** Flank of one side on one body; its places are nodes of a single tooth. */
    struct Flank
    {
      unsigned int              body = 0;
      std::string               side;
      std::vector<unsigned int> nodes;            ///< of the body, of all teeth
      std::vector<double>       areas;            ///< of the nodes [mm^2]
      std::vector<unsigned int> places;           ///< of the nodes
      std::vector<Vector2>      r_z;              ///< of the places, in the axial section [mm]
      std::vector<double>       place_areas;      ///< on one tooth [mm^2]
      std::vector<double>       largest_pressure; ///< of the places [MPa]

      /** Mean of the places' (r, z), weighted with largest pressure times area [mm]; NaN where
       * nothing is carried. */
      Vector2 centre() const;
    };

    /** The flanks of the model's contacts, slave and master of each. */
    explicit ContactPattern(const Model &model);

    /** Contact force [N] of a node, by the body and its node. */
    using NodalForce = std::function<double(unsigned int body, unsigned int node)>;

    /** Takes the forces of an instant or position. */
    void add(const NodalForce &force);

    std::vector<Flank> &flanks()
    {
      return flanks_;
    }
    const std::vector<Flank> &flanks() const
    {
      return flanks_;
    }

    /** Rows of pattern.csv. */
    Table table(const Model &model) const;

  private:
    std::vector<Flank> flanks_;
  };
} // namespace vfife

#endif
