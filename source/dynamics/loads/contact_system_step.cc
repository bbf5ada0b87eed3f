// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One evaluation of ContactSystem: motion of the surfaces to all ranks, pressures, forces back.
#include <vfife/base/process/communicator.h>
#include <vfife/contact/pressure_solver.h>
#include <vfife/dynamics/loads/contact_of_pair.h>
#include <vfife/dynamics/loads/contact_system.h>
#include <vfife/model/constraints/node_constraints.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace vfife
{
  namespace
  {
    /** Adds up over the ranks what belongs to the active nodes of all surfaces, 3 numbers a node:
     * the owner of a node has it, all others zero, so that sums are exact copies. */
    void sum_over_ranks(const std::vector<std::unique_ptr<ContactOfPair>>        &pairs,
                        const std::vector<std::vector<double> ContactSurface::*> &fields,
                        std::vector<double>                                      &buffer,
                        const Communicator                                       &communicator)
    {
      if (communicator.size() == 1)
        return;
      buffer.clear();
      const auto visit = [&](const auto &at_node) {
        for (const auto &pair : pairs)
          for (ContactSurface *surface : pair->surfaces())
            for (const auto field : fields)
              for (const unsigned int i : *surface->active)
                at_node((surface->*field).data() + 3 * static_cast<std::size_t>(i));
      };
      visit([&buffer](const double *values) { buffer.insert(buffer.end(), values, values + 3); });
      communicator.sum(buffer);
      const double *record = buffer.data();
      visit([&record](double *values) {
        std::copy_n(record, 3, values);
        record += 3;
      });
    }
  } // namespace

  struct ContactSystem::SharedPoint
  {
    TouchingPoint point;
    unsigned int  pair, rank, index;

    /** The order in which pressures are solved for: the same for any number of ranks. */
    bool operator<(const SharedPoint &other) const
    {
      const auto key = [](const SharedPoint &p) {
        return std::tie(
          p.pair, p.point.pass, p.point.slave_facet, p.point.rule_point, p.point.master_nodes);
      };
      return key(*this) < key(other);
    }
  };

  void ContactSystem::number_nodes()
  {
    // A node of two surfaces has one number.
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> numbers;
    for (const auto &pair : pairs_)
      for (ContactSurface *surface : pair->surfaces())
        for (const unsigned int node : surface->facets->nodes)
          surface->numbers.push_back(
            numbers.emplace(std::make_pair(surface->body, node), numbers.size()).first->second);
    places_.assign(numbers.size(), 0);
  }

  void ContactSystem::set_masses(const std::vector<double> &masses)
  {
    if (!is_implicit_)
      return;
    std::vector<double> sums(places_.size(), 0.);
    for (const auto &pair : pairs_)
      for (const ContactSurface *surface : pair->surfaces())
        for (std::size_t i = 0; i < surface->local.size(); ++i)
          if (const std::uint32_t node = surface->local[i];
              node != Partition::absent && partition_.owned[node])
            sums[surface->numbers[i]] = masses[node];
    communicator_.sum(sums);
    inverse_masses_.assign(sums.size(), Matrix3::Zero());
    for (std::size_t i = 0; i < sums.size(); ++i)
      inverse_masses_[i] = Matrix3::Identity() / sums[i];
    // Held directions do not give way, prescribed motion not at all. A node that turns about its
    // axis with others counts as free: it is taken for lighter than it is, which is stable.
    for (const auto &pair : pairs_)
      for (const ContactSurface *surface : pair->surfaces())
        {
          const auto constraints = combine_constraints(model_, surface->body);
          for (std::size_t i = 0; i < surface->numbers.size(); ++i)
            {
              const auto found = constraints.find(surface->facets->nodes[i]);
              if (found == constraints.end() || found->second.turning() != nullptr)
                continue;
              const Matrix3      axes   = found->second.axes();
              const unsigned int n_free = 3 - found->second.n_held();
              const auto         free   = axes.rightCols(n_free);
              inverse_masses_[surface->numbers[i]] =
                free * free.transpose() / sums[surface->numbers[i]];
            }
        }
  }

  void ContactSystem::bring_motion(const NodeField &positions,
                                   const NodeField &velocities,
                                   const NodeField *forces,
                                   const double     dt)
  {
    const bool with_velocities = needs_velocities_ || forces != nullptr;
    for (const auto &pair : pairs_)
      for (ContactSurface *surface : pair->surfaces())
        {
          surface->collect_motion(partition_, positions, velocities, with_velocities);
          if (forces != nullptr)
            for (const unsigned int i : *surface->active)
              {
                const std::uint32_t node  = surface->local[i];
                const bool          owned = node != Partition::absent && partition_.owned[node];
                Eigen::Map<Vector3>(surface->free_velocities.data() + 3 * i) =
                  owned ? Vector3(velocities.value(node) +
                                  dt * inverse_masses_[surface->numbers[i]] * forces->value(node))
                        : Vector3(0., 0., 0.);
              }
        }
    std::vector<std::vector<double> ContactSurface::*> fields = {&ContactSurface::positions};
    if (with_velocities)
      fields.push_back(&ContactSurface::velocities);
    if (forces != nullptr)
      fields.push_back(&ContactSurface::free_velocities);
    sum_over_ranks(pairs_, fields, buffer_, communicator_);
  }

  void ContactSystem::add_step_forces(const std::vector<RigidMotion> &body_motion,
                                      const NodeField                &positions,
                                      const NodeField                &velocities,
                                      const double                    dt,
                                      NodeField                      &forces)
  {
    if (!is_implicit_)
      {
        add_forces(body_motion, positions, velocities, dt, forces);
        return;
      }
    // 1. The active nodes' motion, on every rank: where they are and how they would go on without
    // contact.
    bring_motion(positions, velocities, &forces, dt);
    // 2. This rank's points that touch, their pressures, and what these do.
    std::vector<std::vector<TouchingPoint>> points;
    for (const auto &pair : pairs_)
      {
        const auto motion_of = [&body_motion](const ContactSurface &surface) {
          return SurfaceMotion{surface.positions.data(),
                               surface.velocities.data(),
                               body_motion[surface.body],
                               surface.free_velocities.data()};
        };
        points.push_back(pair->contact.locate(motion_of(pair->slave),
                                              motion_of(pair->master),
                                              dt,
                                              pair->is_implicit() ? .5 * dt : 0.,
                                              communicator_.rank(),
                                              communicator_.size()));
        if (!pair->is_implicit())
          pair->contact.find_explicit_pressures(dt, points.back());
      }
    find_pressures(dt, points);
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      pairs_[i]->contact.press(points[i],
                               dt,
                               pairs_[i]->slave.forces.data(),
                               pairs_[i]->master.forces.data());
    // 3. The sums of all ranks' shares.
    add_up(forces);
  }

  void ContactSystem::find_pressures(const double                             dt,
                                     std::vector<std::vector<TouchingPoint>> &points)
  {
    // 1. The points of all ranks, in an order that does not depend on the ranks.
    std::vector<SharedPoint> shared;
    for (unsigned int p = 0; p < pairs_.size(); ++p)
      if (pairs_[p]->is_implicit())
        for (unsigned int i = 0; i < points[p].size(); ++i)
          shared.push_back({points[p][i], p, communicator_.rank(), i});
    if (communicator_.size() > 1)
      shared = communicator_.all_gather(shared);
    std::sort(shared.begin(), shared.end());

    // 2. The active nodes, numbered after each search.
    if (!is_numbered_)
      {
        active_numbers_.clear();
        for (const auto &pair : pairs_)
          for (const ContactSurface *surface : pair->surfaces())
            for (const unsigned int i : *surface->active)
              active_numbers_.push_back(surface->numbers[i]);
        std::sort(active_numbers_.begin(), active_numbers_.end());
        active_numbers_.erase(std::unique(active_numbers_.begin(), active_numbers_.end()),
                              active_numbers_.end());
        for (unsigned int i = 0; i < active_numbers_.size(); ++i)
          places_[active_numbers_[i]] = i;
        is_numbered_ = true;
      }
    std::vector<PressureSolver::Node> nodes(active_numbers_.size());
    for (const auto &pair : pairs_)
      for (const ContactSurface *surface : pair->surfaces())
        for (const unsigned int i : *surface->active)
          nodes[places_[surface->numbers[i]]] = {
            Eigen::Map<const Vector3>(surface->velocities.data() + 3 * i),
            Eigen::Map<const Vector3>(surface->free_velocities.data() + 3 * i),
            inverse_masses_[surface->numbers[i]]};

    // 3. Every rank solves for all, and takes its own.
    PressureSolver             solver(dt, std::move(nodes));
    std::vector<TouchingPoint> solved;
    for (const SharedPoint &s : shared)
      {
        const ContactOfPair  &pair   = *pairs_[s.pair];
        const ContactSurface &slave  = s.point.pass == 0 ? pair.slave : pair.master,
                             &master = s.point.pass == 0 ? pair.master : pair.slave;
        std::array<unsigned int, 4> slave_nodes, master_nodes;
        for (unsigned int k = 0; k < 4; ++k)
          {
            slave_nodes[k]  = places_[slave.numbers[s.point.slave_nodes[k]]];
            master_nodes[k] = places_[master.numbers[s.point.master_nodes[k]]];
          }
        solver.add(s.point,
                   slave_nodes,
                   master_nodes,
                   pair.contact.law(),
                   pair.contact.penalty(),
                   pair.contact.damping(dt));
        solved.push_back(s.point);
      }
    solver.solve(solved);
    for (std::size_t i = 0; i < shared.size(); ++i)
      if (shared[i].rank == communicator_.rank())
        points[shared[i].pair][shared[i].index] = solved[i];
  }

  void ContactSystem::sum_results()
  {
    // Energy, lost power, friction loss, and whether a point is too deep.
    largest_penetration_ = 0;
    sums_                = {{0., 0., 0., 0.}};
    for (const auto &pair : pairs_)
      for (const GroupPairResult &result : pair->contact.results())
        {
          sums_[0] += result.energy;
          sums_[1] += result.damping_power;
          sums_[3] += result.friction_loss;
          largest_penetration_ = std::max(largest_penetration_, result.largest_penetration);
          if (result.largest_penetration > pair->penetration_limit())
            sums_[2] = 1;
        }
    communicator_.sum(sums_.data(), sums_.size());
  }

  void ContactSystem::add_up(NodeField &forces)
  {
    sum_results();
    sum_over_ranks(pairs_, {&ContactSurface::forces}, buffer_, communicator_);
    for (const auto &pair : pairs_)
      for (const ContactSurface *surface : pair->surfaces())
        surface->distribute_forces(forces);
  }
} // namespace vfife
