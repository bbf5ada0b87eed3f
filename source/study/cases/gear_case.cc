// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/parameters/section_of_options.h>
#include <vfife/base/process/log.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/gear/unloaded_contact/unloaded_contact.h>
#include <vfife/mesh/gear/gear_meridian.h>
#include <vfife/mesh/gear/gear_shaft_builder.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/study/cases/body_figures.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/cases/gear_case.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** The name of a flank among the surfaces of a gear body. */
    const char *surface_of(const FlankSide side)
    {
      return side == FlankSide::concave ? surface_name::concave : surface_name::convex;
    }

    /** Penalty times module over the contact modulus E*. At 1000 MPa the springs of the reference
     * pair give way by 1 um, some 2 arcsec of its lag; stiffer ones ripple more on coarse flanks
     * (doc/contact.md, In time). */
    constexpr double penalty_over_stiffness = 30.;

    /** Body frame placed in the fixed frame with its axis of rotation. */
    void place(Body &body, const RigidMotion &placement, const double rate)
    {
      body.placement      = placement;
      body.axis.point     = placement.translation;
      body.axis.direction = placement.rotation.col(2);
      body.turns_on_axis  = true;
      body.rate           = rate;
    }
  } // namespace

  GearCase::GearCase()
    : pinion_body_(pinion_body_defaults())
  {
    // Teeth have a length and a material from which the springs follow, the same for any mesh.
    contact_.penalty.from_step  = false;
    contact_.penalty.value      = 0.;
    contact_.penalty.derivation = "30 E*/m of the pair, 1/E* the sum of (1 - nu^2)/E of both "
                                  "members, m the outer transverse module of the gear";
  }

  void GearCase::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    // Done twice: with a case of which only the names of materials are wanted, then with this one.
    const auto declare_pair = [](dealii::ParameterHandler &handler, GearCase &gear_case) {
      Subsection section(handler, "Gear pair");
      gear_case.pair_.declare(handler);
      const auto declare_body =
        [&](const char *member, std::string &material, GearBodyOptions &body) {
          Subsection subsection(handler, member);
          declare_text(handler, "material", material, "Name of a section \"Material NAME\"");
          body.declare(handler);
        };
      declare_body("Pinion", gear_case.pinion_material_, gear_case.pinion_body_);
      declare_body("Gear", gear_case.gear_material_, gear_case.gear_body_);
    };

    // First pass: the names of the materials.
    GearCase names;
    file.read_known([&](dealii::ParameterHandler &first) { declare_pair(first, names); });

    declare_pair(prm, *this);
    materials_.clear();
    materials_.reserve(2); // entries are bound by address
    for (const std::string &name : {names.pinion_material_, names.gear_material_})
      if (materials_.empty() || materials_.front().name != name)
        {
          materials_.emplace_back();
          materials_.back().name = name;
          declare_section(prm, "Material " + name, materials_.back());
        }
    operation_.declare(prm);
    declare_section(prm, "Contact", contact_);
  }

  void GearCase::check() const
  {
    check_bodies();
    operation_.check("Operation");
    contact_.check("Contact");
    if (contact_.surface == ContactSurfaceKind::true_flank)
      return;
    // Errors are part of the offsets to the true flank: facets and patches know nothing of them.
    const GearPair pair(pair_);
    if (pair.pinion().has_deviations() || pair.gear().has_deviations())
      throw InputError("Contact/surface",
                       "errors of the flanks (Gear pair/Errors) act on surface = true flank only");
  }

  GearPair GearCase::make_pair() const
  {
    return GearPair(pair_);
  }

  void GearCase::check_bodies() const
  {
    pair_.check("Gear pair");
    // Bodies are checked against blanks with everything that is derived from other entries.
    const GearPairOptions completed = pair_.completed();
    pinion_body_.check("Gear pair/Pinion", completed.pinion.blank);
    gear_body_.check("Gear pair/Gear", completed.gear.blank);
    if (pinion_body_.shaft.present() || gear_body_.shaft.present())
      {
        const GearPair pair(pair_);
        check_gear_shaft("Gear pair/Pinion/Shaft", pair.pinion(), pinion_body_);
        check_gear_shaft("Gear pair/Gear/Shaft", pair.gear(), gear_body_);
      }
    for (const Material &m : materials_)
      m.check("Material " + m.name);
  }

  const Material &GearCase::material(const std::string &name) const
  {
    // There are one or two: a material that both members name is declared once.
    return materials_.front().name == name ? materials_.front() : materials_.back();
  }

  const OperationOptions &GearCase::operation() const
  {
    return operation_;
  }

  double GearCase::mesh_frequency() const
  {
    return operation_.mesh_frequency(pair_.completed().pinion.blank.teeth);
  }

  double GearCase::end_time() const
  {
    return operation_.meshes / mesh_frequency();
  }

  double GearCase::ramp_time() const
  {
    return operation_.ramp / mesh_frequency();
  }

  void GearCase::check_run(const DynamicsOptions &dynamics) const
  {
    if (dynamics.start == Start::undeformed)
      throw InputError("Dynamics/start",
                       "a gear pair starts by \"static preload\" or \"ramp\"; \"undeformed\" is "
                       "for models of the section Model");
  }

  // dt = 1/(f s n), n = ceil(1/(f s dt_s)): whole steps from sample to sample, so that samples lie
  // at the same positions of every tooth mesh.
  double GearCase::choose_step(const double stable_step, const unsigned int samples) const
  {
    const double steps_per_sample = std::ceil(1. / (mesh_frequency() * stable_step * samples));
    return 1. / (mesh_frequency() * samples * steps_per_sample);
  }

  bool GearCase::has_web() const
  {
    return gear_body_.web == WebKind::conical;
  }

  HertzContact GearCase::hertz_contact() const
  {
    const UnloadedContact contact(GearPair(pair_), working_side());
    // Curvatures do not depend on the separation of the ellipse that is asked for.
    const Vector2 curvatures =
      contact.ellipse(contact.contact(contact.reference(), 0), 1e-3).relative_curvatures;
    return HertzContact(curvatures, pair_modulus());
  }

  double GearCase::pair_modulus() const
  {
    const Material &pinion = material(pinion_material_), &gear = material(gear_material_);
    return contact_modulus(pinion.youngs_modulus,
                           pinion.poissons_ratio,
                           gear.youngs_modulus,
                           gear.poissons_ratio);
  }

  unsigned int GearCase::gear_tooth_in_mesh(const unsigned int meshes) const
  {
    // Forward the gear turns about -: the next tooth in the + sense comes. The coast side's mean
    // contact is that of tooth 1.
    const unsigned int teeth = pair_.completed().gear.blank.teeth, passed = meshes % teeth;
    const unsigned int first   = working_side() == MeshSide::drive ? 0 : 1;
    const bool         forward = operation_.direction == TurningDirection::forward;
    return (first + (forward ? passed : teeth - passed)) % teeth;
  }

  MeshSide GearCase::working_side() const
  {
    return vfife::working_side(operation_.driving, operation_.direction);
  }

  Transmission GearCase::make_transmission(const GearPair &pair) const
  {
    // The mean contact's normal comes out of the gear: with the gear driving it is turned round,
    // for the model's comes out of the driven member. The pair knows the arm p = |(P x n) . a|
    // about the gear axis only; the driven pinion's is found here.
    const MeanContact &mean          = pair.mean_contact(working_side());
    const bool         pinion_drives = operation_.driving == DrivingMember::pinion;
    const double       sense         = operation_.direction == TurningDirection::forward ? 1. : -1.;
    const unsigned int teeth[]       = {pair.pinion().blank().teeth, pair.gear().blank().teeth};
    Transmission       t;
    t.driver                 = pinion_drives ? 0 : 1;
    t.driven                 = 1 - t.driver;
    t.driver_teeth           = teeth[t.driver];
    t.driven_teeth           = teeth[t.driven];
    t.driver_sense           = pinion_drives ? sense : -sense;
    t.driven_sense           = -t.driver_sense;
    t.driver_rate            = operation_.speed * (pinion_drives ? 1. : pair.speed_ratio());
    t.contact_point          = mean.position;
    t.contact_normal         = pinion_drives ? mean.normal : Vector3(-mean.normal);
    const RigidMotion pinion = pair.pinion_placement(0.);
    t.arm =
      pinion_drives
        ? mean.arm
        : std::abs(
            (mean.position - pinion.translation).cross(mean.normal).dot(pinion.rotation.col(2)));
    return t;
  }

  Model GearCase::make_model(Log &log) const
  {
    for (const std::string &message : pair_.examine().warnings())
      log.warning(message);
    const GearPair pair(pair_);
    Model          model;

    // 1. Bodies, meshed and mounted so that the generated flanks of the working side touch in the
    // mean contact at time zero, the pinion's turned onto its tooth 0. They turn about their axes
    // in opposite senses, the pinion about + when it goes forward.
    Body pinion("pinion", make_gear_body(pair.pinion(), pinion_body_), material(pinion_material_));
    const MeshSide     side  = working_side();
    const MeanContact &mean  = pair.mean_contact(side);
    const double       sense = operation_.direction == TurningDirection::forward ? 1. : -1.;
    place(pinion,
          pair.pinion_placement(mean.rot1 - pair.pinion().turn(pair.pinion_side(side))),
          sense * operation_.speed);
    Body gear("gear", make_gear_body(pair.gear(), gear_body_), material(gear_material_));
    place(gear, pair.gear_placement(mean.rot2), -sense * operation_.speed * pair.speed_ratio());

    model.add_body(std::move(pinion));
    model.add_body(std::move(gear));
    // 2. What drives and what is driven.
    Transmission t      = make_transmission(pair);
    const Body  &driver = model.bodies[t.driver];
    // The rim is where the parts of the transmission error are fitted.
    t.driven_rim       = model.bodies[t.driven].node_set(node_set::rim);
    model.transmission = t;

    // 3. Bores, load torque, flanks that may touch, places that are looked at.
    model.constraints.push_back({driver.name() + " bore",
                                 ConstraintKind::prescribed_rotation,
                                 t.driver,
                                 driver.node_set(held_set(t.driver))});
    add_hub(model);
    add_contacts(pair, log, model);
    add_probes(model);
    for (const BodyFigures &figures : measure_bodies(model))
      figures.write_to(log);
    warn_of_unused_entries(model, log);
    return model;
  }

  const char *GearCase::held_set(const unsigned int body) const
  {
    const GearBodyOptions &options = body == 0 ? pinion_body_ : gear_body_;
    return options.web == WebKind::none ? node_set::rim_underside : node_set::bore;
  }

  void GearCase::add_hub(Model &model) const
  {
    // The set that is held is the bore, or without a web the underside of the rim. What turns there
    // is the theta_g of the transmission error.
    Transmission &t      = *model.transmission;
    const Body   &driven = model.bodies[t.driven];
    t.driven_bore        = driven.node_set(held_set(t.driven));

    Constraint hub;
    hub.name  = driven.name() + " hub";
    hub.kind  = operation_.hub == HubKind::rigid_hub ? ConstraintKind::rigid_hub
                                                     : ConstraintKind::free_rotation;
    hub.body  = t.driven;
    hub.nodes = t.driven_bore;
    model.constraints.push_back(hub);

    Torque load;
    load.name  = "load torque";
    load.body  = t.driven;
    load.nodes = t.driven_bore;
    // A constant traction on the bore, against the sense in which the driven member turns.
    load.areas = compute_nodal_areas(driven, t.driven_bore);
    load.value = -t.driven_sense * operation_.torque;
    model.torques.push_back(load);
  }

  double GearCase::derive_penalty(const GearPair &pair, Log &log) const
  {
    const BlankOutline &gear    = pair.gear().blank();
    const double        modulus = pair_modulus(),
                 module         = gear.circular_pitch(gear.outer_cone_distance) / pi,
                 penalty        = penalty_over_stiffness * modulus / module;
    log.line("contact penalty of the pair ",
             penalty,
             " N/mm^3: ",
             penalty_over_stiffness,
             " E*/m with E* = ",
             modulus,
             " MPa, m = ",
             module,
             " mm");
    return penalty;
  }

  void GearCase::add_contacts(const GearPair &pair, Log &log, Model &model) const
  {
    ContactOptions options = contact_;
    if (!options.penalty.from_step && options.penalty.value == 0.)
      options.penalty.value = derive_penalty(pair, log);
    const Transmission &t             = *model.transmission;
    const bool          pinion_drives = operation_.driving == DrivingMember::pinion;
    const MeshSide      working       = working_side();
    // the side that carries comes first, the driver is the slave
    for (const MeshSide side :
         {working, working == MeshSide::drive ? MeshSide::coast : MeshSide::drive})
      {
        ContactPair contact;
        const char *surfaces[] = {surface_of(pair.pinion_side(side)),
                                  surface_of(pair.gear_side(side))};
        contact.side           = side_name(side);
        contact.slave_body     = t.driver;
        contact.slave_surface  = surfaces[pinion_drives ? 0 : 1];
        contact.master_body    = t.driven;
        contact.master_surface = surfaces[pinion_drives ? 1 : 0];
        contact.options        = options;
        model.contacts.push_back(contact);
      }
  }

  void GearCase::add_probes(Model &model) const
  {
    const Body &gear = model.bodies[1];
    // Of all sectors that which passes the mesh at 75 % of the run: late, and still within it.
    const unsigned int tooth = gear_tooth_in_mesh(std::lround(0.75 * operation_.meshes));
    for (const char *set : {node_set::node_A_front, node_set::node_A_back})
      if (gear.has_node_set(set) && tooth < gear.node_set(set).size())
        model.probes.push_back({set, 1, gear.node_set(set)[tooth]});
  }

  std::vector<BodyFigures> GearCase::measure_bodies(const Model &model) const
  {
    const GearPair pair(pair_);
    return {BodyFigures(model.bodies[0], pair.pinion(), pinion_body_),
            BodyFigures(model.bodies[1], pair.gear(), gear_body_)};
  }

  Table GearCase::meridian_table() const
  {
    const GearPair pair(pair_);
    Table          table = make_meridian_table();
    add_meridian_rows(pair.pinion(), pinion_body_, table);
    add_meridian_rows(pair.gear(), gear_body_, table);
    return table;
  }
} // namespace vfife
