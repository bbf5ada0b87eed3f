// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_watch_transmission_measurement_h
#define vfife_dynamics_watch_transmission_measurement_h

#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  class ByteStream;
  class Communicator;

  /**
   * Angles and transmission errors of a gear pair, from the positions of the nodes of bores and
   * rim. Where these nodes lie undeformed is looked up once: a sample is one pass over them.
   */
  class TransmissionMeasurement
  {
  public:
    /** Of the nodes that this rank owns in @p partition; a model without transmission is nothing
     * to measure. The model must outlive the object. */
    TransmissionMeasurement(const Model &model, const Partition &partition);

    /** Sets angles and errors of the state's measurements; its nodes are those of the partition.
     * Turns are counted from one measurement to the next. Collective. */
    void measure(State &state, const Communicator &communicator);

    /** For checkpoints: the turns so far. */
    void serialize(ByteStream &stream);

  private:
    /** A node about its body's axis. */
    struct Node
    {
      std::uint32_t local;
      double        mass;    ///< [t]
      Vector2       at_rest; ///< undeformed, from the axis, along Ring::across [mm]
    };

    /** Nodes whose mean rotation is looked at. */
    struct Ring
    {
      const Body                 *body;
      Eigen::Matrix<double, 3, 2> across; ///< axes at right angles to that of the body, columns
      std::vector<Node>           nodes;
      double lead = 0; ///< mean rotation beyond the kinematic one, measured last [rad]
    };

    void
    add_ring(const Body &body, const std::vector<unsigned int> &nodes, const Partition &partition);

    static void
    add_rotations(const Ring &ring, double turned, const State &state, std::vector<double> &sums);

    const Model &model_;
    std::vector<Ring>
      rings_; ///< bore and rim of the driven body, the driver's bore where it has one
  };
} // namespace vfife

#endif
