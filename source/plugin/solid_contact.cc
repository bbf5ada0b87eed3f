// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/surface/smooth_patch.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/dynamics/operator/whole_partition.h>
#include <vfife/dynamics/update_sums.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/plugin/solid_contact.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <memory>

namespace vfife
{
  namespace
  {
    constexpr const char *contact_side = "contact";
  } // namespace

  SolidContact::SolidContact(ExplicitSolid                   &slave,
                             const dealii::types::boundary_id slave_boundary,
                             ExplicitSolid                   &master,
                             const dealii::types::boundary_id master_boundary,
                             const ContactOptions            &options)
    : solids_{{&slave, &master}}
    , model_(make_model({{slave_boundary, master_boundary}}, options))
    , partition_(*make_whole_partition(model_))
    , contact_(model_,
               partition_,
               slave.communicator_,
               std::min(slave.options_.safety, master.options_.safety))
    , positions_(model_.n_nodes())
    , velocities_(model_.n_nodes())
    , forces_(model_.n_nodes())
    , added_(model_.n_nodes())
  {
    std::vector<double> masses;
    for (const Body &body : model_.bodies)
      masses.insert(masses.end(), body.node_masses().begin(), body.node_masses().end());
    contact_.set_masses(masses);
  }

  Model SolidContact::make_model(const std::array<dealii::types::boundary_id, 2> &boundaries,
                                 const ContactOptions                            &options)
  {
    Model model;
    for (unsigned int b = 0; b < 2; ++b)
      {
        add_body(b, boundaries[b], model);
        add_held_nodes(b, model);
      }
    ContactPair pair;
    pair.side          = contact_side;
    pair.slave_surface = pair.master_surface = contact_side;
    pair.master_body                         = 1;
    pair.options                             = options;
    // Plain facets have no true flank.
    if (options.surface == ContactSurfaceKind::automatic ||
        options.surface == ContactSurfaceKind::true_flank)
      {
        const bool edges =
          std::any_of(model.bodies.begin(), model.bodies.end(), [](const Body &body) {
            return has_sharp_edges(body.mesh().surfaces.at(contact_side));
          });
        pair.options.surface =
          edges ? ContactSurfaceKind::flat_facets : ContactSurfaceKind::smooth_patches;
      }
    model.contacts.push_back(pair);
    return model;
  }

  void SolidContact::add_body(const unsigned int               b,
                              const dealii::types::boundary_id boundary,
                              Model                           &model)
  {
    // 1. Facets between nodes of the solid that move by themselves or are prescribed.
    const ExplicitSolid &solid = *solids_[b];
    FacetSurface         facets;
    try
      {
        facets =
          surface_of_boundary(solid.dof_handler_.get_triangulation(), contact_side, boundary);
      }
    catch (const InputError &)
      {
        AssertThrow(false, ExplicitSolid::ExcSurface(boundary, "faces of active cells", "none"));
      }
    for (unsigned int &node : facets.nodes)
      {
        node = solid.node_of_vertex_[node];
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto *entries =
              solid.constraints_.get_constraint_entries(solid.dofs_[3 * node + c]);
            AssertThrow(entries == nullptr || entries->empty(),
                        ExplicitSolid::ExcSurface(boundary,
                                                  "DoFs without masters",
                                                  "a hanging node or another line with masters"));
          }
      }

    // 2. The body of the solid with that surface, and the condensed masses: of a node the least.
    const Body &whole             = solid.model_.bodies[0];
    auto        parts             = std::make_unique<BodyMesh>();
    parts->structure              = whole.structure();
    parts->surfaces[contact_side] = std::move(facets);
    Body body(b == 0 ? "slave" : "master",
              whole.materials(),
              whole.node_positions(),
              whole.elements(),
              std::move(parts));
    std::vector<double> condensed = body.node_masses();
    for (std::size_t i = 0; i < condensed.size(); ++i)
      {
        const auto *dof = solid.dofs_.data() + 3 * i;
        condensed[i] =
          std::min({solid.masses_[dof[0]], solid.masses_[dof[1]], solid.masses_[dof[2]]}) -
          condensed[i];
      }
    body.add_masses(condensed);
    model.add_body(std::move(body));
  }

  const std::vector<unsigned int> &SolidContact::surface_nodes(const Body &body)
  {
    return body.mesh().surfaces.at(contact_side).nodes;
  }

  void SolidContact::add_held_nodes(const unsigned int b, Model &model) const
  {
    // Prescribed components do not give way to the pressure: a constraint for each set of them.
    const ExplicitSolid &solid = *solids_[b];
    for (unsigned int set = 1; set < 8; ++set)
      {
        Constraint constraint;
        constraint.name = contact_side;
        constraint.kind = ConstraintKind::directions;
        constraint.body = b;
        for (unsigned int c = 0; c < 3; ++c)
          constraint.prescribed[c] = (set >> c & 1u) != 0;
        for (const unsigned int node : surface_nodes(model.bodies[b]))
          {
            unsigned int of_node = 0;
            for (unsigned int c = 0; c < 3; ++c)
              if (solid.constraints_.is_constrained(solid.dofs_[3 * node + c]))
                of_node |= 1u << c;
            if (of_node == set)
              constraint.nodes.push_back(node);
          }
        if (!constraint.nodes.empty())
          model.constraints.push_back(constraint);
      }
  }

  double SolidContact::stable_step(const double step) const
  {
    return contact_.vote_on_step(step);
  }

  double SolidContact::energy() const
  {
    return contact_.sums().energy();
  }

  RigidMotion SolidContact::bring(const unsigned int b, RigidVelocity &rate)
  {
    // Forces and motion of the surface; the contact looks at no other node. Its mean rigid motion
    // saves searches, no more: any would do.
    const ExplicitSolid             &solid = *solids_[b];
    const Body                      &body  = model_.bodies[b];
    const std::vector<unsigned int> &nodes = surface_nodes(body);
    Eigen::Matrix3Xd                 old(3, nodes.size()), now(3, nodes.size());
    UpdateSums                       sums;
    double                           mass = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const std::uint32_t local = solid.operator_.partition().local_node[nodes[i]];
        const std::size_t   node  = body.first_node + nodes[i];
        const double        m     = body.node_masses()[nodes[i]];
        positions_.set(node, solid.position_.value(local));
        velocities_.set(node, solid.velocity_field_.value(local));
        forces_.set(node, solid.force_.value(local));
        old.col(i) = body.node_positions()[nodes[i]];
        now.col(i) = positions_.value(node);
        add_node_moments(UpdateAxis(), m, now.col(i), velocities_.value(node), sums);
        mass += m;
      }
    rate                         = compute_momentum_rate(UpdateAxis(), mass, sums);
    const Eigen::Matrix4d motion = Eigen::umeyama(old, now, false);
    return {motion.topLeftCorner<3, 3>(), motion.topRightCorner<3, 1>()};
  }

  void SolidContact::add_forces(Vector &slave_forces, Vector &master_forces)
  {
    const std::array<Vector *, 2> vectors = {{&slave_forces, &master_forces}};
    std::vector<RigidMotion>      motions;
    std::vector<RigidVelocity>    rates(2);
    const double                  dt = solids_[0]->dt_;
    AssertThrow(solids_[1]->dt_ == dt, ExcSteps(dt, solids_[1]->dt_));
    for (unsigned int b = 0; b < 2; ++b)
      {
        solids_[b]->find_forces(*vectors[b]);
        motions.push_back(bring(b, rates[b]));
      }
    if (dt != dt_)
      contact_.set_step(dt);
    if (dt != dt_ || n_calls_ % ExplicitSolver::search_interval == 0)
      contact_.search(motions, rates, positions_, ExplicitSolver::search_interval * dt);
    dt_ = dt;
    ++n_calls_;

    contact_.save_forces(forces_);
    contact_.add_step_forces(motions, positions_, velocities_, dt, forces_);
    contact_.find_added(forces_, added_);
    AssertThrow(!contact_.sums().is_too_deep(),
                ExcPenetration(solids_[0]->time(), contact_.describe_deepest_point()));
    for (unsigned int b = 0; b < 2; ++b)
      {
        Vector3 sum = Vector3::Zero();
        for (const unsigned int node : surface_nodes(model_.bodies[b]))
          {
            const Vector3 added = added_.value(model_.bodies[b].first_node + node);
            sum += added;
            for (unsigned int c = 0; c < 3; ++c)
              (*vectors[b])[solids_[b]->dofs_[3 * node + c]] += added[c];
          }
        if (b == 0)
          force_ = sum;
      }
  }
} // namespace vfife
