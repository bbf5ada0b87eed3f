// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/system/point_constraints.h>

namespace vfife
{
  std::map<unsigned int, NodeConstraints> find_point_constraints(const FemSpace &space)
  {
    std::map<unsigned int, NodeConstraints> points;
    const Model                            &model = space.model();
    for (const Constraint &constraint : model.constraints)
      if (const FemSpace::Part *part = space.find_part(constraint.body))
        for (const unsigned int p : space.points_of(*part, constraint.nodes))
          points.try_emplace(p, model.bodies[constraint.body], space.points()[p])
            .first->second.add(constraint);
    for (const auto &[p, constraints] : points)
      constraints.check();
    return points;
  }
} // namespace vfife
