// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/model/constraints/supports.h>

namespace vfife
{
  std::vector<Support> list_supports(const Model &model)
  {
    std::vector<Support> supports;
    for (const Constraint &constraint : model.constraints)
      supports.push_back({constraint.name, constraint.body});
    for (const Load &load : model.loads)
      if (load.kind == LoadKind::spring)
        supports.push_back({load.name, load.body});
    for (const Bearing &bearing : model.bearings)
      supports.push_back({bearing.name, bearing.body});
    for (const Coupling &coupling : model.couplings)
      supports.push_back({coupling.name, coupling.body});
    return supports;
  }

  BearingSystem make_bearing_system(const Model &model)
  {
    std::vector<BearingSystem::Seat> seats;
    for (const Bearing &bearing : model.bearings)
      seats.push_back({bearing.axes, bearing.law});
    BearingSystem system(std::move(seats));
    if (model.housing.size() > 0)
      system.set_housing(model.housing);
    return system;
  }

  std::size_t first_bearing(const Model &model)
  {
    return list_supports(model).size() - model.bearings.size() - model.couplings.size();
  }

  void sum_over_ranks(std::vector<Reaction> &reactions, const Communicator &communicator)
  {
    // Six numbers each, in one reduction.
    std::vector<double> sums;
    for (const Reaction &reaction : reactions)
      for (const Vector3 &vector : {reaction.force, reaction.moment})
        sums.insert(sums.end(), vector.data(), vector.data() + 3);
    communicator.sum(sums);
    for (std::size_t i = 0; i < reactions.size(); ++i)
      {
        reactions[i].force  = Eigen::Map<const Vector3>(sums.data() + 6 * i);
        reactions[i].moment = Eigen::Map<const Vector3>(sums.data() + 6 * i + 3);
      }
  }
} // namespace vfife
