// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One evaluation of ContactSystem: motion of the surfaces to all ranks, pressures, forces back.
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/contact/pressure_solver.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>
#include <vfife/dynamics/loads/contact/contact_system.h>
#include <vfife/model/constraints/node_constraints.h>
#include <vfife/model/tooth_contact.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace vfife
{
  namespace
  {
    constexpr unsigned int no_place = static_cast<unsigned int>(-1);
  } // namespace

  struct ContactSystem::SharedPoint
  {
    TouchingPoint point;
    unsigned int  pair, cluster; ///< of contacts; of what has nodes in common
    unsigned int  place, index;  ///< place: of its rank among those that share points

    /** The order in which pressures are solved for: the same for any number of ranks. */
    bool operator<(const SharedPoint &other) const
    {
      const auto key = [](const SharedPoint &p) {
        return std::tie(
          p.cluster, p.pair, p.point.pass, p.point.slave_facet, p.point.rule_point, p.point.pair);
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
    places_.assign(numbers.size(), no_place);
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
    inverse_masses_.resize(sums.size());
    std::transform(sums.begin(), sums.end(), inverse_masses_.begin(), [](const double mass) {
      return 1. / mass;
    });
    // Held directions do not give way, prescribed motion not at all. A node that turns about its
    // axis with others counts as free: it is taken for lighter than it is, which is stable.
    for (const auto &pair : pairs_)
      for (const ContactSurface *surface : pair->surfaces())
        {
          const auto constraints = combine_constraints(model_, surface->body);
          for (std::size_t i = 0; i < surface->numbers.size(); ++i)
            {
              const unsigned int node = surface->facets->nodes[i], number = surface->numbers[i];
              if (constraints.count(node) != 0)
                held_[number] = inverse_masses_[number] * free_directions(constraints, node);
            }
        }
  }

  Matrix3 ContactSystem::inverse_mass(const unsigned int number) const
  {
    const auto held = held_.find(number);
    return held != held_.end() ? held->second
                               : Matrix3(inverse_masses_[number] * Matrix3::Identity());
  }

  void ContactSystem::bring_motion(const NodeField &positions,
                                   const NodeField &velocities,
                                   const NodeField *forces,
                                   const double     dt)
  {
    // The owners' nodes; what others own comes from them.
    const bool with_velocities = needs_velocities_ || forces != nullptr;
    for (const auto &[surface, i] : ranks_.own_nodes())
      {
        const std::uint32_t node = surface->local[i];
        const auto          at   = [i = i](std::vector<double> &array) {
          return Eigen::Map<Vector3>(array.data() + 3 * static_cast<std::size_t>(i));
        };
        at(surface->positions) = positions.value(node);
        if (with_velocities)
          at(surface->velocities) = velocities.value(node);
        if (forces == nullptr)
          continue;
        const unsigned int number = surface->numbers[i];
        if (held_.empty())
          at(surface->free_velocities) =
            velocities.value(node) + dt * inverse_masses_[number] * forces->value(node);
        else
          at(surface->free_velocities) =
            velocities.value(node) + dt * inverse_mass(number) * forces->value(node);
      }
    std::vector<std::vector<double> ContactSurface::*> arrays = {&ContactSurface::positions};
    if (with_velocities)
      arrays.push_back(&ContactSurface::velocities);
    if (forces != nullptr)
      arrays.push_back(&ContactSurface::free_velocities);
    ranks_.bring(arrays);
  }

  void ContactSystem::evaluate(const std::function<void()> &work)
  {
    // Those that share points fail alike. Others wait for this rank's forces, which it sends though
    // there be none, and hear of it with the next sums of all.
    failure_.clear();
    touched_.clear();
    try
      {
        work();
      }
    catch (const NumericalError &error)
      {
        if (communicator_.size() == 1)
          throw;
        failure_ = error.what();
      }
    for (const ContactRanks::Node &node : touched_)
      node.surface->touched[node.number] = 0;
  }

  void ContactSystem::rethrow_failure() const
  {
    if (!(sums_[5] > 0.))
      return;
    for (const std::string &text : communicator_.all_gather(failure_))
      if (!text.empty())
        throw NumericalError(text);
  }

  void ContactSystem::add_step_forces(const std::vector<RigidMotion> &body_motion,
                                      const NodeField                &positions,
                                      const NodeField                &velocities,
                                      const double                    dt,
                                      NodeField                      &forces)
  {
    if (pairs_.empty())
      return;
    if (is_implicit_)
      press_implicitly(body_motion, positions, velocities, dt, forces);
    else
      press_explicitly(body_motion, positions, velocities, dt, forces);
    sum_results();
    sum_teeth();
  }

  void ContactSystem::press_implicitly(const std::vector<RigidMotion> &body_motion,
                                       const NodeField                &positions,
                                       const NodeField                &velocities,
                                       const double                    dt,
                                       NodeField                      &forces)
  {
    // 1. The active nodes' motion: where they are and how they would go on without contact.
    bring_motion(positions, velocities, &forces, dt);
    evaluate([&] {
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
                                                pair->is_implicit() ? .5 * dt : 0.));
          if (!pair->is_implicit())
            pair->contact.find_explicit_pressures(dt, points.back());
        }
      find_pressures(dt, points);
      for (std::size_t i = 0; i < pairs_.size(); ++i)
        press(*pairs_[i], points[i], dt);
    });
    // 3. To all that hold the nodes.
    hand_over_forces(forces);
  }

  void ContactSystem::press(ContactOfPair                    &pair,
                            const std::vector<TouchingPoint> &points,
                            const double                      dt)
  {
    pair.contact.press(points, dt, pair.slave.forces.data(), pair.master.forces.data());
    for (const TouchingPoint &point : points)
      for (unsigned int k = 0; k < 8; ++k)
        {
          // The slave of the second of two passes is the contact's master.
          const unsigned int i       = k < 4 ? point.slave_nodes[k] : point.master_nodes[k - 4];
          ContactSurface    &surface = (k < 4) == (point.pass == 0) ? pair.slave : pair.master;
          if (surface.touched[i] != 0)
            continue;
          surface.touched[i] = 1;
          touched_.push_back({&surface, i});
        }
  }

  void ContactSystem::find_pressures(const double                             dt,
                                     std::vector<std::vector<TouchingPoint>> &points)
  {
    // 1. The points of all ranks that share them, in an order that does not depend on the ranks.
    std::vector<SharedPoint> shared;
    for (unsigned int p = 0; p < pairs_.size(); ++p)
      if (pairs_[p]->is_implicit())
        for (unsigned int i = 0; i < points[p].size(); ++i)
          shared.push_back(
            {points[p][i], p, ranks_.cluster(p, points[p][i].pair), ranks_.place(), i});
    if (ranks_.shares_points())
      shared = ranks_.exchange(shared);
    std::vector<const SharedPoint *> order;
    for (const SharedPoint &point : shared)
      order.push_back(&point);
    std::sort(order.begin(), order.end(), [](const SharedPoint *a, const SharedPoint *b) {
      return *a < *b;
    });

    // 2. Cluster by cluster: their pressures do not depend on each other.
    for (auto first = order.cbegin(); first != order.cend();)
      {
        const auto last = std::find_if(first, order.cend(), [first](const SharedPoint *point) {
          return point->cluster != (*first)->cluster;
        });
        const std::vector<TouchingPoint> solved = solve_cluster(dt, {first, last});
        for (std::size_t i = 0; first != last; ++first, ++i)
          if ((*first)->place == ranks_.place())
            points[(*first)->pair][(*first)->index] = solved[i];
      }
  }

  std::vector<TouchingPoint>
  ContactSystem::solve_cluster(const double dt, const std::vector<const SharedPoint *> &shared)
  {
    // Few nodes are touched: they get their places as they come.
    std::vector<PressureSolver::Node> nodes;
    std::vector<unsigned int>         used;
    const auto place_of = [&](const ContactSurface &surface, const unsigned int i) {
      const unsigned int number = surface.numbers[i];
      if (places_[number] == no_place)
        {
          places_[number] = nodes.size();
          used.push_back(number);
          nodes.push_back({Eigen::Map<const Vector3>(surface.velocities.data() + 3 * i),
                           Eigen::Map<const Vector3>(surface.free_velocities.data() + 3 * i),
                           inverse_mass(number)});
        }
      return places_[number];
    };
    std::vector<std::array<unsigned int, 4>> slave_places(shared.size()),
      master_places(shared.size());
    for (std::size_t p = 0; p < shared.size(); ++p)
      {
        const TouchingPoint  &point  = shared[p]->point;
        const ContactOfPair  &pair   = *pairs_[shared[p]->pair];
        const ContactSurface &slave  = point.pass == 0 ? pair.slave : pair.master,
                             &master = point.pass == 0 ? pair.master : pair.slave;
        for (unsigned int k = 0; k < 4; ++k)
          {
            slave_places[p][k]  = place_of(slave, point.slave_nodes[k]);
            master_places[p][k] = place_of(master, point.master_nodes[k]);
          }
      }
    for (const unsigned int number : used)
      places_[number] = no_place;

    PressureSolver             solver(dt, std::move(nodes));
    std::vector<TouchingPoint> solved;
    for (std::size_t p = 0; p < shared.size(); ++p)
      {
        const Contact &contact = pairs_[shared[p]->pair]->contact;
        solver.add(shared[p]->point, slave_places[p], master_places[p], contact.interaction(dt));
        solved.push_back(shared[p]->point);
      }
    solver.solve(solved);
    return solved;
  }

  void ContactSystem::sum_results()
  {
    // Energy, lost power, whether a point is too deep, friction loss, pressure, failure.
    sums_ = {};
    for (const auto &pair : pairs_)
      for (const GroupPairResult &result : pair->contact.results())
        {
          sums_[0] += result.energy;
          sums_[1] += result.damping_power;
          sums_[3] += result.friction_loss;
          sums_[4] += result.normal_force;
          if (result.largest_penetration > pair->penetration_limit())
            sums_[2] = 1;
        }
    sums_[5] = failure_.empty() ? 0. : 1.;
  }

  void ContactSystem::sum_teeth()
  {
    if (model_.transmissions.empty())
      return;
    // As many numbers on all ranks, whether this one has failed or not: candidates are the same.
    tooth_sums_.assign(1, 0.);
    for (unsigned int p = 0; p < pairs_.size(); ++p)
      {
        const Contact &contact = pairs_[p]->contact;
        const auto    &results = contact.results();
        for (std::size_t i = 0; i < contact.candidate_pairs().size(); ++i)
          {
            const GroupPairResult result = i < results.size() ? results[i] : GroupPairResult();
            tooth_sums_.front() += make_tooth_contact(model_, p, result).torque;
            tooth_sums_.insert(tooth_sums_.end(), result.force.begin(), result.force.end());
          }
      }
  }

  void ContactSystem::hand_over_forces(NodeField &forces)
  {
    // To all copies of the nodes. The arrays of the surfaces are zero again for the next time.
    for (const auto &[surface, i] : ranks_.add_up_forces(touched_))
      {
        Eigen::Map<Vector3> f(surface->forces.data() + 3 * static_cast<std::size_t>(i));
        if (surface->local[i] != Partition::absent && !(f[0] == 0. && f[1] == 0. && f[2] == 0.))
          forces.add(surface->local[i], f);
        f.setZero();
      }
  }
} // namespace vfife
