// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_body_ring_h
#define vfife_output_measures_body_ring_h

#include <vfife/bearing/mean_motion.h>
#include <vfife/model/body.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  class Communicator;
  struct State;

  /** Nodes of a body whose mean motion counts: its bore on the shaft, or the seat of a bearing. */
  class BodyRing
  {
  public:
    /** Mean with @p shares (of any sum); @p owner in words for messages, as in MeanMotion. */
    BodyRing(const Body                &body,
             std::vector<unsigned int>  nodes,
             const std::vector<double> &shares,
             const std::string         &owner);

    /** The mean weighted with the nodes' masses. */
    BodyRing(const Body &body, std::vector<unsigned int> nodes, const std::string &owner);

    /** Of the body. */
    const std::vector<unsigned int> &nodes() const
    {
      return nodes_;
    }
    /** Undeformed, fixed frame [mm]. */
    const std::vector<Vector3> &places() const
    {
      return places_;
    }
    /** Mean of the places. */
    const Vector3 &centre() const
    {
      return set_.centre();
    }

    /** Collective. */
    MeanMotion::Motion measure(const State &state, const Communicator &communicator) const;

    /** Where node i of the list is at place_of(i) [mm]. */
    MeanMotion::Motion measure(const std::function<Vector3(std::size_t)> &place_of) const;

  private:
    unsigned int              first_node_;
    std::vector<unsigned int> nodes_;
    std::vector<Vector3>      places_;
    MeanMotion                set_;
  };

  /** The mean motion that a ring of a body of the model has. */
  using RingMotions = std::function<MeanMotion::Motion(unsigned int body, const BodyRing &ring)>;
} // namespace vfife

#endif
