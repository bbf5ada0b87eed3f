// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/model/model.h>
#include <vfife/study/conventional/loaded_pattern.h>
#include <vfife/study/pressure/pressure_tables.h>

#include <algorithm>

namespace vfife
{
  LoadedPattern::LoadedPattern(const Model &model)
    : model_(model)
    , pattern_(model)
    , forces_(model.n_nodes(), 0.)
  {
  }

  void LoadedPattern::add_position(const PairEquilibriumResult &result)
  {
    std::fill(forces_.begin(), forces_.end(), 0.);
    for (const NodalForce &nodal : result.contact_forces)
      forces_[model_.bodies[nodal.body].first_node + nodal.node] = nodal.force.norm();
    pattern_.add([this](const unsigned int body, const unsigned int node) {
      return forces_[model_.bodies[body].first_node + node];
    });
  }

  Table LoadedPattern::table() const
  {
    return pattern_.table(model_);
  }

  NamedFigures LoadedPattern::figures(const std::array<BlankOutline, 2> &outlines,
                                      const std::string                 &side) const
  {
    NamedFigures figures;
    for (const ContactPattern::Flank &flank : pattern_.flanks())
      if (flank.side == side)
        {
          // Body 0 of a gear pair is the pinion.
          const Vector2      centre = place_on_flank(outlines[flank.body], flank.centre());
          const std::string &of     = model_.bodies[flank.body].name();
          figures.push_back({"pattern along the face, " + of, {centre[0], "mm"}});
          figures.push_back({"pattern along the profile, " + of, {centre[1], "mm"}});
        }
    return figures;
  }
} // namespace vfife
