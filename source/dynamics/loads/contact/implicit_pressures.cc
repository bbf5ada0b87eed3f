// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/contact/pressure_solver.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>
#include <vfife/dynamics/loads/contact/contact_ranks.h>
#include <vfife/dynamics/loads/contact/implicit_pressures.h>
#include <vfife/model/constraints/node_constraints.h>

#include <algorithm>
#include <tuple>

namespace vfife
{
  namespace
  {
    constexpr unsigned int no_place = static_cast<unsigned int>(-1);
  } // namespace

  struct ImplicitPressures::SharedPoint
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

  ImplicitPressures::ImplicitPressures(const Model        &model,
                                       const ContactPairs &pairs,
                                       const ContactRanks &ranks)
    : model_(model)
    , pairs_(pairs)
    , ranks_(ranks)
    , places_(ranks.nodes().n_numbers, no_place)
  {
  }

  void ImplicitPressures::set_masses(const std::vector<double> &masses,
                                     const Partition           &partition,
                                     const Communicator        &communicator)
  {
    std::vector<double> sums(places_.size(), 0.);
    for (const auto &pair : pairs_)
      for (const ContactSurface *surface : pair->surfaces())
        for (std::size_t i = 0; i < surface->local.size(); ++i)
          if (const std::uint32_t node = surface->local[i];
              node != Partition::absent && partition.owned[node])
            sums[surface->numbers[i]] = masses[node];
    communicator.sum(sums);
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

  Matrix3 ImplicitPressures::inverse_mass(const unsigned int number) const
  {
    const auto held = held_.find(number);
    return held != held_.end() ? held->second
                               : Matrix3(inverse_masses_[number] * Matrix3::Identity());
  }

  void ImplicitPressures::find_free_velocities(const std::vector<ContactNode> &nodes,
                                               const NodeField                &velocities,
                                               const NodeField                &forces,
                                               const double                    dt) const
  {
    for (const auto &[surface, i] : nodes)
      {
        const std::uint32_t node   = surface->local[i];
        const unsigned int  number = surface->numbers[i];
        Eigen::Map<Vector3> free(surface->free_velocities.data() + 3 * static_cast<std::size_t>(i));
        if (held_.empty())
          free = velocities.value(node) + dt * inverse_masses_[number] * forces.value(node);
        else
          free = velocities.value(node) + dt * inverse_mass(number) * forces.value(node);
      }
  }

  void ImplicitPressures::solve(const double dt, std::vector<std::vector<TouchingPoint>> &points)
  {
    // 1. The points of all ranks that share them, in an order that does not depend on the ranks.
    std::vector<SharedPoint> shared;
    for (unsigned int p = 0; p < pairs_.size(); ++p)
      if (pairs_[p]->is_implicit())
        for (unsigned int i = 0; i < points[p].size(); ++i)
          shared.push_back(
            {points[p][i], p, ranks_.cluster(p, points[p][i].pair), ranks_.messages().place(), i});
    if (ranks_.messages().shares_points())
      shared = ranks_.messages().exchange(shared);
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
          if ((*first)->place == ranks_.messages().place())
            points[(*first)->pair][(*first)->index] = solved[i];
      }
  }

  std::vector<TouchingPoint>
  ImplicitPressures::solve_cluster(const double dt, const std::vector<const SharedPoint *> &shared)
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
} // namespace vfife
