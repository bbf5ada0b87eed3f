// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/types.h>
#include <vfife/dynamics/watch/transmission_measurement.h>
#include <vfife/model/pair_measures.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfife
{
  namespace
  {
    /** The angle of (@p cosine, @p sine), a vector of any length [rad]: std::atan2, which nodes
     * that hardly leave the turn of their body need not wait for. */
    double compute_angle(const double sine, const double cosine)
    {
      // The series of the tangent's inverse; the first term left out is at most 2e-23 of the sum.
      if (!(64 * std::abs(sine) <= cosine))
        return std::atan2(sine, cosine);
      const double t = sine / cosine, s = t * t;
      return t * (1. - s * (1. / 3 - s * (1. / 5 - s * (1. / 7 - s * (1. / 9 - s / 11)))));
    }
  } // namespace

  TransmissionMeasurement::TransmissionMeasurement(const Model &model, const Partition &partition)
    : model_(model)
  {
    if (model.transmissions.empty())
      return;
    const Transmission &t = *model.only_transmission();
    for (const auto *nodes : {&t.driven_bore, &t.driven_rim})
      add_ring(model.bodies[t.driven], *nodes, partition);
    if (!t.driver_bore.empty())
      add_ring(model.bodies[t.driver], t.driver_bore, partition);
  }

  void TransmissionMeasurement::add_ring(const Body                      &body,
                                         const std::vector<unsigned int> &nodes,
                                         const Partition                 &partition)
  {
    Ring ring{&body, {}, {}, 0.};
    ring.across.col(0) = body.axis.direction.unitOrthogonal();
    ring.across.col(1) = body.axis.direction.cross(ring.across.col(0));
    for (const unsigned int node : nodes)
      {
        const std::uint32_t local = partition.find_owned(body.first_node + node);
        if (local == Partition::absent)
          continue;
        const Vector3 r = body.placement(body.node_positions()[node]) - body.axis.point;
        ring.nodes.push_back({local, body.node_masses()[node], ring.across.transpose() * r});
      }
    // As they lie in memory.
    std::sort(ring.nodes.begin(), ring.nodes.end(), [](const Node &a, const Node &b) {
      return a.local < b.local;
    });
    rings_.push_back(std::move(ring));
  }

  /** Appends the sum of mass times rotation about the axis beyond the turn @p turned of the whole
   * body since time zero, and the sum of the masses. */
  void TransmissionMeasurement::add_rotations(const Ring          &ring,
                                              const double         turned,
                                              const State         &state,
                                              std::vector<double> &sums)
  {
    // From where the whole body's turn has the node to where it is, across the axis: the turn is
    // that of the axes in which both are written.
    const Eigen::Matrix<double, 3, 2> across =
      rotation_about(ring.body->axis.direction, turned) * ring.across;
    const Vector3 point = ring.body->axis.point;
    double        sum = 0., mass = 0.;
    for (const Node &node : ring.nodes)
      {
        const Vector3 r        = state.node_position(node.local) - point;
        const Vector2 now      = across.transpose() * r;
        const Vector2 expected = node.at_rest;
        const double  angle =
          compute_angle(expected[0] * now[1] - expected[1] * now[0], expected.dot(now));
        sum += node.mass * count_turns(angle, ring.lead);
        mass += node.mass;
      }
    sums.insert(sums.end(), {sum, mass});
  }

  void TransmissionMeasurement::serialize(ByteStream &stream)
  {
    for (Ring &ring : rings_)
      stream.pass(ring.lead);
  }

  void TransmissionMeasurement::measure(State &state, const Communicator &communicator)
  {
    if (model_.transmissions.empty())
      return;
    const Transmission &t    = *model_.only_transmission();
    const double        turn = t.driver_turn(state.time);

    // Differences from the kinematic turn are measured, so that no digits are lost in large angles.
    // Mass-weighted means over bore and rim of the driven body and the driver's bore.
    std::vector<double> sums;
    for (const std::size_t ring : {0, 1})
      add_rotations(rings_[ring], t.driven_sense * t.driven_turn(state.time), state, sums);
    const bool driver_leads = rings_.size() > 2;
    if (driver_leads)
      add_rotations(rings_[2], t.driver_sense * turn, state, sums);
    communicator.sum(sums);
    for (std::size_t ring = 0; ring < rings_.size(); ++ring)
      rings_[ring].lead = sums[2 * ring] / sums[2 * ring + 1];
    Measurements &m = state.measured;
    m.driver_angle  = driver_leads ? t.driver_sense * rings_[2].lead : 0.;
    m.driven_angle  = t.driven_sense * rings_[0].lead;
    m.rim_angle     = t.driven_sense * rings_[1].lead;
    m.rate_factor   = t.rate_history.value(state.time);
    complete_angles(t, turn, m);
  }
} // namespace vfife
