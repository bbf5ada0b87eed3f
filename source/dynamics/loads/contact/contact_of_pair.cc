// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/law/hertz.h>
#include <vfife/contact/law/penalty_options.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>
#include <vfife/mesh/body_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfife
{
  namespace
  {
    const FacetSurface &find_surface(const Body &body, const std::string &name)
    {
      const auto found = body.mesh().surfaces.find(name);
      if (found == body.mesh().surfaces.end())
        {
          std::string list;
          for (const auto &s : body.mesh().surfaces)
            list += (list.empty() ? "" : ", ") + s.first;
          throw InputError("body \"" + body.name() + "\" has no surface \"" + name +
                           "\" (surfaces: " + list + ")");
        }
      return found->second;
    }
  } // namespace

  ContactSurface::ContactSurface(const unsigned int body_index,
                                 const Body        &b,
                                 const std::string &surface_name,
                                 const Partition   &partition)
    : body(body_index)
    , facets(&find_surface(b, surface_name))
    , positions(3 * facets->nodes.size())
    , velocities(3 * facets->nodes.size())
    , forces(3 * facets->nodes.size())
    , free_velocities(3 * facets->nodes.size())
    , touched(facets->nodes.size(), 0)
  {
    for (const unsigned int node : facets->nodes)
      {
        // Masses are the whole nodes', also of nodes that this rank does not hold: all ranks vote
        // alike on the step and have the same penalty.
        if (partition.find_owned(b.first_node + node) != Partition::absent)
          owned.push_back(local.size());
        local.push_back(partition.local_node[b.first_node + node]);
        mass.push_back(b.node_masses()[node]);
      }
  }

  double ContactSurface::largest_deformation(const RigidMotion &motion,
                                             const NodeField   &all_positions) const
  {
    double largest = 0.;
    for (const unsigned int i : owned)
      largest =
        std::max(largest,
                 (all_positions.value(local[i]) - motion(facets->positions[i])).squaredNorm());
    return std::sqrt(largest);
  }

  ContactOfPair::ContactOfPair(const ContactPair &pair,
                               const Model       &model,
                               const Partition   &partition,
                               const double       safety)
    : definition(pair)
    , slave(pair.slave_body, model.bodies[pair.slave_body], pair.slave_surface, partition)
    , master(pair.master_body, model.bodies[pair.master_body], pair.master_surface, partition)
    , contact(*slave.facets, *master.facets, pair.options)
    , mass_per_area(contact.node_springs().mass_per_area(slave.mass, master.mass))
    , safety_(safety)
    , penalty_(pair.options.penalty)
  {
    if (penalty_.is_open())
      {
        const Material &s = model.bodies[pair.slave_body].material_under(
                         slave.facets->nodes, "surface \"" + pair.slave_surface + "\""),
                       &m = model.bodies[pair.master_body].material_under(
                         master.facets->nodes, "surface \"" + pair.master_surface + "\"");
        penalty_.value = compute_facet_penalty(
          contact_modulus(s.youngs_modulus, s.poissons_ratio, m.youngs_modulus, m.poissons_ratio),
          contact.vary_penalty());
      }
    contact.set_penalty(penalty_.value, mass_per_area);
    if (!pair.stiffness.empty())
      contact.set_stiffness(pair.stiffness);
    contact.place(model.bodies[pair.slave_body].placement,
                  model.bodies[pair.master_body].placement);
    carried_mass_per_area = contact.node_springs().carried_mass_per_area(slave.mass, master.mass);
    // Which nodes are active changes with each search of the contact.
    slave.active  = &contact.active_slave_nodes();
    master.active = &contact.active_master_nodes();
  }

  double ContactOfPair::vote_on_step(const double step) const
  {
    // Integrated implicitly the pressure bears any step; the springs of points that stick do not.
    if (is_implicit())
      return definition.options.friction.acts() ? penalty().vote_of_stick(step) : step;
    // The nodes' own areas as everywhere; of what is carried beyond them the safety of the step
    // bears a part: 4/dt^2 >= 4 safety^2/step^2 + n eps A/m with the carried A.
    return std::min(penalty().vote_on_step(step, mass_per_area),
                    penalty().vote_on_step(step / safety_, carried_mass_per_area));
  }

  double ContactOfPair::rattling(const double dt) const
  {
    const NodeSprings springs   = contact.node_springs();
    const auto        stiffness = springs.stiffness();
    double            most      = 0;
    for (const ContactSurface *surface : {&slave, &master})
      {
        const auto &areas = surface == &slave ? springs.slave_areas() : springs.master_areas();
        const std::vector<double> &of_nodes = stiffness[surface == &slave ? 0 : 1];
        for (std::size_t i = 0; i < areas.size(); ++i)
          if (areas[i] > 0)
            most = std::max(most,
                            of_nodes[i] * contact.penalty() /
                              PenaltyOptions::rattling_value(surface->mass[i] / areas[i], dt));
      }
    return most;
  }

  double ContactOfPair::tangential_limit(const double dt) const
  {
    if (!is_implicit())
      return std::numeric_limits<double>::infinity();
    // With the springs' share x = n f/4 of 4/dt^2 by their own areas, everything else has
    // (1 - x) safety^2: carried areas may take what is left, so that the limit never falls by a
    // jump where a slave gets coarser.
    const double x    = 0.25 * penalty().n_moving * PenaltyOptions::stick_fraction;
    const double left = (1. - (1. - x) * safety_ * safety_) / x;
    return PenaltyOptions::stick_value(std::min(mass_per_area, left * carried_mass_per_area), dt);
  }
} // namespace vfife
