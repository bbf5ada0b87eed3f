// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/study/reduced/flank_places.h>

#include <algorithm>
#include <set>

namespace vfife
{
  FlankReader read_flanks(const Model &model, const ReducedPair &pair)
  {
    return [&model, &pair](const State &state) {
      const ContactPair                &contact = model.contacts.front();
      const std::array<unsigned int, 2> bodies  = {{contact.slave_body, contact.master_body}};
      const std::array<std::string, 2> surfaces = {{contact.slave_surface, contact.master_surface}};
      FlankState                       flanks;
      for (unsigned int side = 0; side < 2; ++side)
        {
          const Body         &body   = model.bodies[bodies[side]];
          const FacetSurface &facets = body.mesh().surfaces.at(surfaces[side]);
          // Of teeth in contact alone: modes are many, and teeth too.
          std::set<unsigned int> teeth;
          for (const ToothContact &tooth : state.measured.teeth)
            teeth.insert(side == 0 ? tooth.slave_group : tooth.master_group);
          std::set<unsigned int> of_teeth;
          for (std::size_t f = 0; f < facets.facets.size(); ++f)
            if (teeth.count(facets.group[f]) > 0)
              of_teeth.insert(facets.facets[f].begin(), facets.facets[f].end());
          std::vector<unsigned int> nodes;
          for (const unsigned int node : of_teeth)
            nodes.push_back(facets.nodes[node]);
          const std::vector<double> places = pair.reader().read_places(bodies[side], nodes);
          flanks.positions[side].assign(3 * facets.nodes.size(), 0.);
          flanks.forces[side] = flanks.positions[side];
          std::size_t i       = 0;
          for (const unsigned int node : of_teeth)
            {
              std::copy_n(places.begin() + 3 * i++,
                          3,
                          flanks.positions[side].begin() + 3 * std::size_t(node));
              Eigen::Map<Vector3>(flanks.forces[side].data() + 3 * std::size_t(node)) =
                state.contact_force.value(body.first_node + facets.nodes[node]);
            }
          flanks.motions[side] = pair.body_motion(bodies[side]);
        }
      return flanks;
    };
  }
} // namespace vfife
