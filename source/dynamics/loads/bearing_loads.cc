// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/types.h>
#include <vfife/dynamics/loads/bearing_loads.h>
#include <vfife/model/constraints/supports.h>
#include <vfife/model/load_shares.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <set>

namespace vfife
{
  namespace
  {
    using Matrix6 = Eigen::Matrix<double, 6, 6>;

    /** The largest eigenvalue of K G, both symmetric and G positive. */
    double largest_eigenvalue(const Matrix6 &K, const Matrix6 &G)
    {
      // Of G^1/2 K G^1/2, which has the same.
      const Eigen::SelfAdjointEigenSolver<Matrix6> of_G(G);
      const Matrix6                                root = of_G.eigenvectors() *
                           of_G.eigenvalues().cwiseMax(0.).cwiseSqrt().asDiagonal() *
                           of_G.eigenvectors().transpose();
      return Eigen::SelfAdjointEigenSolver<Matrix6>(root * K * root).eigenvalues().maxCoeff();
    }
  } // namespace

  BearingLoads::BearingLoads(const Model        &model,
                             const Partition    &partition,
                             const Communicator &communicator)
    : communicator_(communicator)
    , system_(make_bearing_system(model))
  {
    for (const Bearing &bearing : model.bearings)
      {
        seats_.emplace_back(partition,
                            model.bodies[bearing.body],
                            bearing.nodes,
                            bearing.faces,
                            bearing.axes,
                            "bearing \"" + bearing.name + "\"");
        seats_.back().bearing = &bearing;
      }
    for (const Coupling &coupling : model.couplings)
      {
        const Body &body = model.bodies[coupling.body];
        seats_.emplace_back(partition,
                            body,
                            coupling.nodes,
                            coupling.faces,
                            axes_along(body.axis.direction),
                            "coupling \"" + coupling.name + "\"");
        seats_.back().coupling = &coupling;
      }
    for (Seat &seat : seats_)
      find_limits(seat);
    // Springs on different nodes do not add up; those that share nodes do at most.
    for (const Seat &seat : seats_)
      {
        const std::set<unsigned int> nodes(seat.all_nodes.begin(), seat.all_nodes.end());
        double                       frequency2 = 0, decay = 0;
        for (const Seat &other : seats_)
          if (other.body == seat.body &&
              std::any_of(other.all_nodes.begin(),
                          other.all_nodes.end(),
                          [&nodes](const unsigned int node) { return nodes.count(node) != 0; }))
            {
              frequency2 += other.frequency2;
              decay += other.decay;
            }
        frequency2_ = std::max(frequency2_, frequency2);
        decay_      = std::max(decay_, decay);
      }
  }

  BearingLoads::Seat::Seat(const Partition                 &partition,
                           const Body                      &of_body,
                           const std::vector<unsigned int> &of_nodes,
                           const SelectedFaces             &faces,
                           const Matrix3                   &axes,
                           const std::string               &owner)
    : body(&of_body)
    , seat(axes)
    , set(compute_area_shares(of_body, of_nodes, faces),
          find_undeformed_places(of_body, of_nodes),
          owner)
    , all_nodes(of_nodes)
  {
    for (std::size_t i = 0; i < of_nodes.size(); ++i)
      {
        const std::uint32_t local = partition.local_node[body->first_node + of_nodes[i]];
        if (local != Partition::absent)
          nodes.push_back({local, static_cast<std::uint32_t>(i), partition.owned[local] != 0});
      }
  }

  Eigen::Matrix<double, 6, 6> BearingLoads::Seat::stiffness_bound() const
  {
    return bearing != nullptr ? seat.in_space(bearing->law->stiffness_bound(), 0.)
                              : seat.in_space(Matrix5::Zero(), coupling->stiffness);
  }

  Eigen::Matrix<double, 6, 6> BearingLoads::Seat::damping_matrix() const
  {
    return bearing != nullptr ? seat.in_space(bearing->law->damping(), 0.)
                              : seat.in_space(Matrix5::Zero(), coupling->damping);
  }

  void BearingLoads::find_limits(Seat &seat)
  {
    // Forces -B_i^T K sum B_j u_j on the masses m_i: the squares of frequencies other than zero are
    // the eigenvalues of K G, G = sum B_i B_i^T/m_i. The ring turns, and G with it, so each spring
    // may meet each direction of it: places at rest stand for all where the ring is round.
    const MeanMotion::Motion at_rest = seat.set.at_rest();
    Matrix6                  G       = Matrix6::Zero();
    for (std::size_t i = 0; i < seat.all_nodes.size(); ++i)
      {
        const Eigen::Matrix<double, 6, 3> B = seat.set.derivative(i, at_rest);
        G += B * B.transpose() / seat.body->node_masses()[seat.all_nodes[i]];
      }
    seat.frequency2 = largest_eigenvalue(seat.stiffness_bound(), G);
    seat.decay      = largest_eigenvalue(seat.damping_matrix(), G);
  }

  double BearingLoads::vote_on_step(const double step) const
  {
    // 4/dt^2 >= 4/step^2 + k/m + 2 (c/m)/dt, the last as the damper's velocity is that of half a
    // step ago; solved for 1/dt.
    const double quarter = .25 * decay_;
    return 1. / (quarter + std::sqrt(quarter * quarter + 1. / (step * step) + .25 * frequency2_));
  }

  void BearingLoads::add_relaxation_masses(const double fraction, std::vector<double> &masses) const
  {
    // Rows of B^T K B by Gershgorin: |B_i|^T |K| sum |B_j| 1 <= m_i (2 fraction)^2.
    for (const Seat &seat : seats_)
      {
        const MeanMotion::Motion    at_rest = seat.set.at_rest();
        Eigen::Matrix<double, 6, 1> sum     = Eigen::Matrix<double, 6, 1>::Zero();
        for (std::size_t i = 0; i < seat.set.size(); ++i)
          sum += seat.set.derivative(i, at_rest).cwiseAbs().rowwise().sum();
        const Eigen::Matrix<double, 6, 1> pull = seat.stiffness_bound().cwiseAbs() * sum;
        for (const Node &node : seat.nodes)
          masses[node.local] +=
            (seat.set.derivative(node.of_set, at_rest).cwiseAbs().transpose() * pull).maxCoeff() /
            (4 * fraction * fraction);
      }
  }

  void BearingLoads::respond(const double time, const bool at_rest)
  {
    energy_ = 0;
    respond_bearings(time, at_rest);
    for (Seat &seat : seats_)
      if (seat.coupling != nullptr)
        respond_coupling(time, at_rest, seat);
  }

  void BearingLoads::respond_bearings(const double time, const bool at_rest)
  {
    if (system_.size() == 0)
      return;
    // All at once: a housing lets each feel the others.
    std::vector<Vector5> displacements;
    std::vector<double>  turns;
    for (std::size_t s = 0; s < system_.size(); ++s)
      {
        displacements.push_back(seats_[s].seat.displacement(seats_[s].motion));
        turns.push_back(at_rest ? 0. : seats_[s].body->driven_turn(time));
      }
    const BearingSystem::Response response = system_.evaluate(displacements, turns);
    energy_ += response.energy;
    for (std::size_t s = 0; s < system_.size(); ++s)
      {
        Seat         &seat = seats_[s];
        const Vector5 damper =
          at_rest ? Vector5(Vector5::Zero())
                  : Vector5(-seat.bearing->law->damping() * seat.seat.rate(seat.motion));
        seat.elastic = seat.seat.of_load(response.loads[s], seat.motion);
        seat.damping = seat.seat.of_load(damper, seat.motion);
        seat.state   = {displacements[s], response.loads[s] + damper};
        // A cage rolls as the machine turns, not as the shaft swings: what it presses elements
        // together by is work of the drive.
        seat.drive_torque = response.turn_slopes[s];
      }
  }

  void BearingLoads::respond_coupling(const double time, const bool at_rest, Seat &seat)
  {
    // The driver's end has turned as prescribed; what the shaft lags behind winds the spring. The
    // twist is known but for whole turns, of which it keeps those that it had a moment ago.
    const double rate     = seat.body->rate * seat.body->rate_history.value(time);
    const double expected = at_rest ? 0. : seat.body->driven_turn(time);
    const double twist    = seat.seat.twist(seat.motion, expected);
    const double wound    = count_turns(twist - expected, seat.winding);
    const double torque   = -seat.coupling->stiffness * wound;
    seat.winding          = wound;
    seat.damper_torque =
      at_rest ? 0. : -seat.coupling->damping * (seat.seat.twist_rate(seat.motion) - rate);
    seat.drive_torque = torque + seat.damper_torque;
    seat.elastic      = seat.seat.of_torque(torque, seat.motion);
    seat.damping      = seat.seat.of_torque(seat.damper_torque, seat.motion);
    energy_ -= .5 * torque * wound;
  }

  void BearingLoads::read_motions(const NodeField &positions, const NodeField *const velocities)
  {
    // Sums of all seats in one reduction.
    const std::size_t   n = MeanMotion::make_sums().size();
    std::vector<double> all;
    for (const Seat &seat : seats_)
      {
        std::vector<double> sums = MeanMotion::make_sums();
        for (const Node &node : seat.nodes)
          if (node.owned)
            seat.set.add(node.of_set,
                         positions.value(node.local),
                         velocities != nullptr ? velocities->value(node.local)
                                               : Vector3(Vector3::Zero()),
                         sums);
        all.insert(all.end(), sums.begin(), sums.end());
      }
    communicator_.sum(all);
    for (std::size_t s = 0; s < seats_.size(); ++s)
      seats_[s].motion =
        seats_[s].set.solve(std::vector<double>(all.begin() + n * s, all.begin() + n * (s + 1)));
  }

  void BearingLoads::add_to(NodeField &forces) const
  {
    for (const Seat &seat : seats_)
      {
        const Vector3 force  = seat.elastic.force + seat.damping.force,
                      moment = seat.elastic.moment + seat.damping.moment;
        for (const Node &node : seat.nodes)
          forces.add(node.local, seat.set.force(node.of_set, seat.motion, force, moment));
      }
  }

  void BearingLoads::add_forces(const double     time,
                                const NodeField &positions,
                                const NodeField &velocities,
                                NodeField       &forces)
  {
    if (seats_.empty())
      return;
    read_motions(positions, &velocities);
    respond(time, false);
    add_to(forces);
  }

  void BearingLoads::add_forces_at_rest(const NodeField &positions, NodeField &forces)
  {
    if (seats_.empty())
      return;
    read_motions(positions, nullptr);
    respond(0., true);
    add_to(forces);
  }

  double BearingLoads::energy() const
  {
    return energy_;
  }

  std::vector<SeatState> BearingLoads::bearing_states() const
  {
    std::vector<SeatState> states;
    for (const Seat &seat : seats_)
      if (seat.bearing != nullptr)
        states.push_back(seat.state);
    return states;
  }

  std::vector<double> BearingLoads::windings() const
  {
    std::vector<double> windings;
    for (std::size_t s = system_.size(); s < seats_.size(); ++s)
      windings.push_back(seats_[s].winding);
    return windings;
  }

  void BearingLoads::set_windings(const std::vector<double> &windings)
  {
    for (std::size_t s = system_.size(); s < seats_.size(); ++s)
      seats_[s].winding = windings.at(s - system_.size());
  }

  double BearingLoads::drive_power(const double from, const double to) const
  {
    // The ways of the drives between two instants, which a rate at one of them only comes near.
    double power = 0;
    for (const Seat &seat : seats_)
      if (seat.drive_torque != 0)
        power += seat.drive_torque * (seat.body->driven_turn(to) - seat.body->driven_turn(from)) /
                 (to - from);
    return power;
  }

  double BearingLoads::damper_drive_power(const double from, const double to) const
  {
    double power = 0;
    for (const Seat &seat : seats_)
      if (seat.damper_torque != 0)
        power += seat.damper_torque * (seat.body->driven_turn(to) - seat.body->driven_turn(from)) /
                 (to - from);
    return power;
  }

  double BearingLoads::half_damper_power(const NodeField &velocities) const
  {
    double power = 0;
    if (decay_ > 0)
      for (const Seat &seat : seats_)
        for (const Node &node : seat.nodes)
          if (node.owned)
            power += .5 * velocities.value(node.local)
                            .dot(seat.set.force(
                              node.of_set, seat.motion, seat.damping.force, seat.damping.moment));
    return power;
  }

  void BearingLoads::add_reactions(const NodeField       &positions,
                                   const std::size_t      first,
                                   std::vector<Reaction> &reactions) const
  {
    for (std::size_t s = 0; s < seats_.size(); ++s)
      {
        const Seat &seat = seats_[s];
        for (const Node &node : seat.nodes)
          if (node.owned)
            reactions[first + s].add(positions.value(node.local),
                                     seat.set.force(node.of_set,
                                                    seat.motion,
                                                    seat.elastic.force + seat.damping.force,
                                                    seat.elastic.moment + seat.damping.moment));
      }
  }
} // namespace vfife
