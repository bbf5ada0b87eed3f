// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/bearing/mean_motion.h>
#include <vfife/fem/system/fem_space.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/load_shares.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/reduced/body_rings.h>

#include <numeric>

namespace vfife
{
  namespace ring
  {
    std::string of_bearing(const std::string &bearing)
    {
      return "bearing " + bearing;
    }
    std::string of_coupling(const std::string &coupling)
    {
      return "coupling " + coupling;
    }
    const char *const bore  = "bore";
    const char *const whole = "whole body";
  } // namespace ring

  namespace
  {
    std::vector<Vector3> places_of(const Body &body, const std::vector<unsigned int> &nodes)
    {
      std::vector<Vector3> places;
      for (const unsigned int node : nodes)
        places.push_back(body.node_positions()[node]);
      return places;
    }

    MotionOfRing make_ring(const Body                      &body,
                           const std::string               &name,
                           const std::vector<unsigned int> &nodes,
                           std::vector<double>              shares)
    {
      const std::string owner = "body \"" + body.name() + "\", " + name;
      require_all_copies(body, nodes, owner);
      const MeanMotion         set(std::move(shares), places_of(body, nodes), owner);
      const MeanMotion::Motion at_rest = set.at_rest();
      MotionOfRing             ring{name, set.centre(), {}};
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (body.structure().sector_of(nodes[i]) == 0)
          ring.motion.emplace_back(nodes[i], set.derivative(i, at_rest));
      return ring;
    }

    std::vector<unsigned int> all_nodes(const Body &body)
    {
      std::vector<unsigned int> nodes(body.n_nodes());
      std::iota(nodes.begin(), nodes.end(), 0u);
      return nodes;
    }
  } // namespace

  std::vector<MotionOfRing> list_rings(const Model &model, const unsigned int b)
  {
    const Body               &body = model.bodies[b];
    std::vector<MotionOfRing> rings;
    if (!body.floats)
      return rings;
    for (const Bearing &bearing : model.bearings)
      if (bearing.body == b)
        rings.push_back(make_ring(body,
                                  ring::of_bearing(bearing.name),
                                  bearing.nodes,
                                  compute_area_shares(body, bearing.nodes, bearing.faces)));
    for (const Coupling &coupling : model.couplings)
      if (coupling.body == b)
        rings.push_back(make_ring(body,
                                  ring::of_coupling(coupling.name),
                                  coupling.nodes,
                                  compute_area_shares(body, coupling.nodes, coupling.faces)));
    if (const Transmission *const t = model.only_transmission())
      if (const auto &bore = find_member(*t, b).bore; !bore.empty())
        rings.push_back(make_ring(body, ring::bore, bore, masses_of(body, bore)));
    const std::vector<unsigned int> nodes = all_nodes(body);
    rings.push_back(make_ring(body, ring::whole, nodes, masses_of(body, nodes)));
    return rings;
  }

  Eigen::Matrix<double, 6, 6> find_rigid_inertia(const Model &model, const unsigned int b)
  {
    const Body                     &body   = model.bodies[b];
    const std::vector<unsigned int> nodes  = all_nodes(body);
    const std::vector<double>       masses = masses_of(body, nodes);
    const double                    mass   = std::accumulate(masses.begin(), masses.end(), 0.);
    const MeanMotion            set(masses, places_of(body, nodes), "body \"" + body.name() + "\"");
    Eigen::Matrix<double, 6, 6> inertia = Eigen::Matrix<double, 6, 6>::Zero();
    inertia.topLeftCorner<3, 3>()       = mass * Matrix3::Identity();
    inertia.bottomRightCorner<3, 3>()   = mass * set.at_rest().inverse_inertia.inverse();
    return inertia;
  }
} // namespace vfife
