// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of GearCase that puts the model together.
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_matrix.h>
#include <vfife/base/process/log.h>
#include <vfife/bearing/bearing_system.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/mesh/shaft_sections.h>
#include <vfife/study/cases/body_figures.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/cases/gear_case.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** The name of a flank among the surfaces of a gear body. */
    const char *surface_of(const FlankSide side)
    {
      return side == FlankSide::concave ? surface_name::concave : surface_name::convex;
    }

    /** First penalty times module over the contact modulus E*. At 1000 MPa the springs of the
     * reference pair give way by 1 um, some 2 arcsec of its lag (doc/theory/contact.md, Penalty).
     */
    constexpr double penalty_over_stiffness = 30.;

    /** Body frame placed in the fixed frame with its axis of rotation. */
    void place(Body                   &body,
               const RigidMotion      &placement,
               const double            rate,
               const ParameterHistory &rate_history)
    {
      body.placement      = placement;
      body.axis.point     = placement.translation;
      body.axis.direction = placement.rotation.col(2);
      body.turns_on_axis  = true;
      body.rate           = rate;
      body.rate_history   = rate_history;
    }
  } // namespace

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
    t.rate_history           = operation_.speed_history;
    t.largest_factor         = largest_speed_factor();
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
    Body               pinion = make_body(pair, 0);
    const MeshSide     side   = working_side();
    const MeanContact &mean   = pair.mean_contact(side);
    const double       sense  = operation_.direction == TurningDirection::forward ? 1. : -1.;
    place(pinion,
          pair.pinion_placement(mean.rot1 - pair.pinion().turn(pair.pinion_side(side))),
          sense * operation_.speed,
          operation_.speed_history);
    Body gear = make_body(pair, 1);
    place(gear,
          pair.gear_placement(mean.rot2),
          -sense * operation_.speed * pair.speed_ratio(),
          operation_.speed_history);

    model.add_body(std::move(pinion));
    model.add_body(std::move(gear));
    // 2. What drives and what is driven.
    Transmission t = make_transmission(pair);
    // The rim is where the parts of the transmission error are fitted.
    t.driven_rim        = model.bodies[t.driven].node_set(node_set::rim);
    model.transmissions = {t};

    // 3. Bores, load torque, flanks that may touch, places that are looked at.
    add_drive(model);
    add_load(model);
    add_housing(model);
    add_contacts(pair, log, model);
    add_probes(model);
    for (const BodyFigures &figures : measure_bodies(model))
      figures.write_to(log);
    log_parts(model, log);
    warn_of_materials(model, log);
    return model;
  }

  Body GearCase::make_body(const GearPair &pair, const unsigned int body) const
  {
    // Seats begin and end where the mesh has levels.
    const GearMember         &teeth  = body == 0 ? pair.pinion() : pair.gear();
    const Member             &member = members_[body];
    std::unique_ptr<BodyMesh> mesh   = make_gear_body(teeth, member.with_levels(teeth.blank()));
    member.materials.assign(*mesh, member.section());
    return {body == 0 ? "pinion" : "gear",
            member.materials.find(materials_, member.section()),
            std::move(mesh)};
  }

  void GearCase::add_housing(Model &model) const
  {
    if (housing_.empty())
      return;
    const char *entry = "Gear pair/Housing/stiffness";
    if (model.bearings.empty())
      throw InputError(entry, "expected bearings in the housing, got ideal bores of both members");
    // Bearings of the driver were added first; the file has those of the pinion first.
    std::stable_sort(model.bearings.begin(),
                     model.bearings.end(),
                     [](const Bearing &a, const Bearing &b) { return a.body < b.body; });
    try
      {
        model.housing = read_parameter_matrix(housing_);
        BearingSystem(std::vector<BearingSystem::Seat>(model.bearings.size()))
          .set_housing(model.housing);
      }
    catch (const InputError &error)
      {
        throw InputError(entry, std::string(error.what()));
      }
  }

  const char *GearCase::held_set(const unsigned int body) const
  {
    return members_[body].body.web == WebKind::none ? node_set::rim_underside : node_set::bore;
  }

  void GearCase::add_drive(Model &model) const
  {
    Transmission                   &t        = model.transmissions.front();
    const Body                     &driver   = model.bodies[t.driver];
    const Member                   &member   = members_[t.driver];
    const std::vector<ShaftSection> sections = member.shaft_sections();
    if (sections.empty())
      {
        model.constraints.push_back({driver.name() + " bore",
                                     ConstraintKind::prescribed_rotation,
                                     t.driver,
                                     driver.node_set(held_set(t.driver))});
        return;
      }
    t.driver_bore = driver.node_set(held_set(t.driver));
    member.supports.add_driver(model, t.driver, member.shaft_section(), sections);
  }

  void GearCase::add_load(Model &model) const
  {
    // The set that is held is the bore, or without a web the underside of the rim. What turns there
    // is the theta_g of the transmission error.
    Transmission                   &t        = model.transmissions.front();
    const Body                     &driven   = model.bodies[t.driven];
    const Member                   &member   = members_[t.driven];
    const std::vector<ShaftSection> sections = member.shaft_sections();
    const double                    torque   = -t.driven_sense * driven_torque();
    t.driven_bore                            = driven.node_set(held_set(t.driven));
    if (!sections.empty())
      {
        member.supports.add_driven(model, t.driven, member.shaft_section(), sections, torque);
        model.torques.back().history = driven_torque_history();
        return;
      }
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
    load.areas   = compute_nodal_areas(driven, t.driven_bore);
    load.value   = torque;
    load.history = driven_torque_history();
    model.torques.push_back(load);
  }

  namespace
  {
    /** Transverse [mm]. */
    double outer_module(const BlankOutline &blank)
    {
      return blank.circular_pitch(blank.outer_cone_distance) / pi;
    }
  } // namespace

  double GearCase::guess_penalty(const GearPair &pair) const
  {
    return penalty_over_stiffness * pair_modulus() / outer_module(pair.gear().blank());
  }

  std::optional<Model> GearCase::make_reference_model() const
  {
    if (reference_degree_ == 1)
      return std::nullopt;
    GearCase reference = *this;
    for (Member &member : reference.members_)
      member.body = coarse(member.body);
    return reference.make_silent_model();
  }

  Model GearCase::make_silent_model() const
  {
    std::ostringstream nothing;
    Log                quiet(nothing, false);
    return make_model(quiet);
  }

  std::optional<Model> GearCase::make_submodel_mesh(const unsigned int cells_lengthwise) const
  {
    // With 10 cells lengthwise the tooth of doc/verification/gear-pair.md, Root stress, is within 1
    // %.
    constexpr double layer   = .13; ///< over the module
    constexpr double grading = 4.;
    // 20 and 10 change the stress of the web's fillet at the hub by 0.4 %.
    constexpr unsigned int web_rows = 12, fillet_rows = 6;
    GearCase               fine = *this;
    const GearPair         pair(pair_);
    for (unsigned int b = 0; b < 2; ++b)
      {
        const GearMember &gear      = b == 0 ? pair.pinion() : pair.gear();
        GearBodyOptions  &body      = fine.members_[b].body;
        body                        = coarse(body);
        body.cells_lengthwise       = cells_lengthwise;
        body.grading_towards_fillet = grading;
        body.web_rows               = web_rows;
        body.fillet_rows            = fillet_rows;
        body.surface_layer          = std::min(layer * outer_module(gear.blank()),
                                      find_largest_surface_layer(gear, body.fillet_corner));
      }
    return fine.make_silent_model();
  }

  void GearCase::choose_points(Model &model, Log &log) const
  {
    // Both sides alike, by the facets of the side that carries.
    const double width = 2 * TorquePressure(hertz_contact(), model).semi_axes[1];
    if (!(width > 0))
      return;
    const double       facet = ContactResolution(model, model.contacts.front(), width).facet;
    const unsigned int n     = points_across(facet, width);
    for (ContactPair &contact : model.contacts)
      contact.options.points_per_facet.number = n;
    log.line("contact points: ",
             n,
             " per facet and direction, ",
             facet / n,
             " mm apart; the Hertzian contact is ",
             width,
             " mm wide");
  }

  void GearCase::add_contacts(const GearPair &pair, Log &log, Model &model) const
  {
    ContactOptions options = contact_;
    if (leaves_penalty_open())
      options.penalty.value = guess_penalty(pair);
    const Transmission &t             = *model.only_transmission();
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
    if (contact_.points_per_facet.is_word)
      choose_points(model, log);
  }

  void GearCase::add_probes(Model &model) const
  {
    const Body &gear = model.bodies[1];
    // Of all sectors that which passes the mesh at 75 % of the run: late, and still within it.
    const unsigned int tooth = gear_tooth_in_mesh(std::lround(0.75 * run_meshes()));
    for (const char *set : {node_set::node_A_front, node_set::node_A_back})
      if (gear.has_node_set(set) && tooth < gear.node_set(set).size())
        model.probes.push_back({set, 1, gear.node_set(set)[tooth]});
  }
} // namespace vfife
