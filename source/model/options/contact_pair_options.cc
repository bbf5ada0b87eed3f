// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/contact/surface/smooth_patch.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/options/contact_pair_options.h>

namespace vfife
{
  namespace
  {
    using Kind = ContactPairOptions::Kind;

    const Choices<Kind> contact_kinds = {{"bodies", Kind::bodies}, {"wall", Kind::wall}};

    /** As the body spells it; a name without a surface is refused where the pair is made. */
    std::string
    find_surface_name(const Body &body, const std::string &surface, const std::string &entry)
    {
      const std::string name     = body.mesh().find_spelling(surface);
      const auto        unusable = body.mesh().unusable_surfaces.find(name);
      if (unusable != body.mesh().unusable_surfaces.end())
        throw InputError(entry, unusable->second);
      return name;
    }
  } // namespace

  ContactPairOptions::ContactPairOptions()
  {
    contact.surface = ContactSurfaceKind::automatic;
    // Friction excites the vibrations of bodies that nothing else damps.
    contact.friction.damping_ratio = wall.friction.damping_ratio = 0.2;
  }

  void ContactPairOptions::declare_kind(dealii::ParameterHandler &prm)
  {
    declare_choice(
      prm, "kind", kind, contact_kinds, "Contact of two bodies, or of a body and a rigid wall");
  }

  void ContactPairOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_kind(prm);
    if (kind == Kind::bodies)
      {
        declare_text(prm, "slave body", slave_body, "Name of a body");
        declare_text(prm, "slave surface", slave_surface, "Surface of the slave body");
        declare_text(prm, "master body", master_body, "Name of a body");
        declare_text(prm, "master surface", master_surface, "Surface of the master body");
        contact.declare(prm);
        return;
      }
    // A wall has a place and a penalty; sampling, edges and friction are for two surfaces.
    selection.declare(prm);
    declare_vector(prm, "wall point", wall.point, "mm", "Point on the wall");
    declare_vector(prm, "wall normal", wall.normal, "-", "Normal of the wall, out of it");
    wall.penalty.declare(prm);
    wall.friction.declare(prm);
  }

  void ContactPairOptions::check(const std::string &section) const
  {
    if (kind == Kind::bodies)
      {
        contact.check(section);
        return;
      }
    wall.penalty.check(section);
    wall.friction.check(section);
    if (wall.normal.norm() == 0)
      throw InputError(section + "/wall normal", "must not have length zero");
  }

  void ContactPairOptions::add_to(Model             &model,
                                  const std::string &name,
                                  const std::string &section) const
  {
    if (kind == Kind::wall)
      {
        // Depths are measured along the normal: it has to have the length one.
        RigidWall added = wall;
        added.name      = name;
        added.normal.normalize();
        added.body  = selection.find_body(model.bodies, section);
        added.nodes = selection.find_nodes(model.bodies[added.body], section);
        added.faces = selection.find_faces(model.bodies[added.body], added.nodes, section);
        model.walls.push_back(added);
        return;
      }
    // Only for its finding of a body by name, with the message for a wrong one.
    NodeSelection slave, master;
    slave.body  = slave_body;
    master.body = master_body;
    ContactPair pair;
    pair.side       = name;
    pair.slave_body = slave.find_body(model.bodies, section, "slave body");
    pair.slave_surface =
      find_surface_name(model.bodies[pair.slave_body], slave_surface, section + "/slave surface");
    pair.master_body    = master.find_body(model.bodies, section, "master body");
    pair.master_surface = find_surface_name(model.bodies[pair.master_body],
                                            master_surface,
                                            section + "/master surface");
    pair.options        = contact;
    if (contact.surface == ContactSurfaceKind::automatic)
      {
        const auto has_edges = [&model](const unsigned int body, const std::string &surface) {
          const auto &surfaces = model.bodies[body].mesh().surfaces;
          const auto  found    = surfaces.find(surface);
          return found != surfaces.end() && has_sharp_edges(found->second);
        };
        pair.options.surface = has_edges(pair.slave_body, pair.slave_surface) ||
                                   has_edges(pair.master_body, pair.master_surface)
                                 ? ContactSurfaceKind::flat_facets
                                 : ContactSurfaceKind::smooth_patches;
      }
    model.contacts.push_back(pair);
  }
} // namespace vfife
