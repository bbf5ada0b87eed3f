// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/watch/approach_energy.h>
#include <vfife/model/model.h>

#include <algorithm>

namespace vfife
{
  ApproachEnergy::ApproachEnergy(const Model &model)
  {
    // A body flies that neither bearings nor constraints hold; displacements prescribed in some
    // directions only do not.
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const bool prescribed = std::any_of(model.constraints.begin(),
                                            model.constraints.end(),
                                            [b](const Constraint &constraint) {
                                              return constraint.body == b &&
                                                     constraint.kind != ConstraintKind::directions;
                                            });
        bodies_.push_back({!model.bodies[b].turns_on_axis && !prescribed, model.bodies[b].mass()});
      }
    for (const ContactPair &pair : model.contacts)
      if (bodies_[pair.slave_body].flies || bodies_[pair.master_body].flies)
        pairs_.insert(std::minmax(pair.slave_body, pair.master_body));
    for (const RigidWall &wall : model.walls)
      if (bodies_[wall.body].flies)
        at_walls_.insert(wall.body);
  }

  double ApproachEnergy::compute(const std::vector<BodySums> &sums) const
  {
    const auto velocity = [&](const unsigned int b) {
      return bodies_[b].flies ? Vector3(sums[b].update.momentum / bodies_[b].mass)
                              : Vector3(Vector3::Zero());
    };
    const auto inverse_mass = [&](const unsigned int b) {
      return bodies_[b].flies ? 1. / bodies_[b].mass : 0.;
    };
    // Pairs: mu |v_a - v_b|^2/2, 1/mu = 1/m_a + 1/m_b; what does not fly has 1/m = 0 and v = 0.
    double                 energy = 0;
    std::set<unsigned int> flying;
    for (const auto &[a, b] : pairs_)
      {
        // One body of a pair at least flies: the sum of the inverse masses is not zero.
        energy +=
          0.5 * (velocity(a) - velocity(b)).squaredNorm() / (inverse_mass(a) + inverse_mass(b));
        flying.insert({a, b});
      }
    // Walls: m v^2/2.
    for (const unsigned int b : at_walls_)
      {
        energy += 0.5 * bodies_[b].mass * velocity(b).squaredNorm();
        flying.insert(b);
      }
    // The spin of each body once: its rigid kinetic energy less that of its centre.
    for (const unsigned int b : flying)
      if (bodies_[b].flies)
        energy += compute_rigid_kinetic_energy({}, bodies_[b].mass, sums[b].update) -
                  0.5 * bodies_[b].mass * velocity(b).squaredNorm();
    return energy;
  }
} // namespace vfife
