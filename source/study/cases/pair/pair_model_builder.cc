// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_matrix.h>
#include <vfife/base/process/log.h>
#include <vfife/bearing/bearing_system.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/mesh/shaft_sections.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/cases/pair/pair_model_builder.h>
#include <vfife/study/cases/torque_pressure.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfife
{
  namespace
  {
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

  PairModelBuilder::PairModelBuilder(const PairOptions &options,
                                     MountedGears       gears,
                                     const PairCase    &pair_case)
    : options_(options)
    , gears_(std::move(gears))
    , case_(pair_case)
    , operation_(pair_case.operation())
    , side_(working_side(operation_.driving, operation_.direction))
  {
  }

  double PairModelBuilder::speed_ratio() const
  {
    return static_cast<double>(gears_.teeth[0]->blank().teeth) / gears_.teeth[1]->blank().teeth;
  }

  double PairModelBuilder::pinion_sense() const
  {
    return operation_.direction == TurningDirection::forward ? 1. : -1.;
  }

  Transmission PairModelBuilder::make_transmission() const
  {
    // The mean contact's normal comes out of the gear: with the gear driving it is turned round,
    // for the model's comes out of the driven member.
    const bool   pinion_drives = operation_.driving == DrivingMember::pinion;
    Transmission t;
    t.driver         = pinion_drives ? 0 : 1;
    t.driven         = 1 - t.driver;
    t.driver_teeth   = gears_.teeth[t.driver]->blank().teeth;
    t.driven_teeth   = gears_.teeth[t.driven]->blank().teeth;
    t.driver_sense   = pinion_drives ? pinion_sense() : -pinion_sense();
    t.driven_sense   = -t.driver_sense;
    t.driver_rate    = operation_.speed * (pinion_drives ? 1. : speed_ratio());
    t.rate_history   = operation_.speed_history;
    t.largest_factor = case_.largest_speed_factor();
    t.contact_point  = gears_.contact_point;
    t.contact_normal = pinion_drives ? gears_.contact_normal : Vector3(-gears_.contact_normal);
    t.arm            = gears_.arms[t.driven];
    return t;
  }

  Model PairModelBuilder::make(Log &log) const
  {
    Model model;

    // 1. Bodies, meshed and mounted. They turn about their axes in opposite senses.
    Body pinion = make_body(0);
    place(pinion,
          gears_.placements[0],
          pinion_sense() * operation_.speed,
          operation_.speed_history);
    Body gear = make_body(1);
    place(gear,
          gears_.placements[1],
          -pinion_sense() * operation_.speed * speed_ratio(),
          operation_.speed_history);

    model.add_body(std::move(pinion));
    model.add_body(std::move(gear));
    // 2. What drives and what is driven.
    Transmission t = make_transmission();
    // The rim is where the parts of the transmission error are fitted.
    t.driven_rim        = model.bodies[t.driven].node_set(node_set::rim);
    model.transmissions = {t};

    // 3. Bores, load torque, flanks that may touch, places that are looked at.
    add_drive(model);
    add_load(model);
    add_housing(model);
    add_contacts(model, log);
    add_probes(model);
    for (const BodyFigures &figures : measure_bodies(model))
      figures.write_to(log);
    log_parts(model, log);
    warn_of_materials(model, log);
    return model;
  }

  Body PairModelBuilder::make_body(const unsigned int body) const
  {
    // Seats begin and end where the mesh has levels.
    const GearGeometry       &teeth  = *gears_.teeth[body];
    const MemberOptions      &member = options_.members[body];
    std::unique_ptr<BodyMesh> mesh   = make_gear_body(teeth, member.with_levels(teeth.blank()));
    member.materials.assign(*mesh, member.section());
    Body made(body == 0 ? "pinion" : "gear",
              member.materials.find(options_.materials, member.section()),
              std::move(mesh));
    member.materials.give_temperature(made, member.section());
    return made;
  }

  void PairModelBuilder::add_housing(Model &model) const
  {
    if (options_.housing.empty())
      return;
    const std::string entry = options_.section + "/Housing/stiffness";
    if (model.bearings.empty())
      throw InputError(entry, "expected bearings in the housing, got ideal bores of both members");
    // Bearings of the driver were added first; the file has those of the pinion first.
    std::stable_sort(model.bearings.begin(),
                     model.bearings.end(),
                     [](const Bearing &a, const Bearing &b) { return a.body < b.body; });
    for_entry(entry, [&] {
      model.housing = read_parameter_matrix(options_.housing);
      BearingSystem(std::vector<BearingSystem::Seat>(model.bearings.size()))
        .set_housing(model.housing);
    });
  }

  const char *PairModelBuilder::held_set(const unsigned int body) const
  {
    return options_.members[body].body.web == WebKind::none ? node_set::rim_underside
                                                            : node_set::bore;
  }

  void PairModelBuilder::add_drive(Model &model) const
  {
    Transmission                   &t        = model.transmissions.front();
    const Body                     &driver   = model.bodies[t.driver];
    const MemberOptions            &member   = options_.members[t.driver];
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

  void PairModelBuilder::add_load(Model &model) const
  {
    // The set that is held is the bore, or without a web the underside of the rim. What turns there
    // is the theta_g of the transmission error.
    Transmission                   &t        = model.transmissions.front();
    const Body                     &driven   = model.bodies[t.driven];
    const MemberOptions            &member   = options_.members[t.driven];
    const std::vector<ShaftSection> sections = member.shaft_sections();
    const double                    torque   = -t.driven_sense * case_.driven_torque();
    t.driven_bore                            = driven.node_set(held_set(t.driven));
    if (!sections.empty())
      {
        member.supports.add_driven(model, t.driven, member.shaft_section(), sections, torque);
        model.torques.back().history = case_.driven_torque_history();
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
    load.history = case_.driven_torque_history();
    model.torques.push_back(load);
  }

  const char *PairModelBuilder::surface_of(const unsigned int body, const MeshSide side) const
  {
    const FlankSide drive = gears_.drive_flanks[body];
    return (side == MeshSide::drive ? drive : opposite(drive)) == FlankSide::concave
             ? surface_name::concave
             : surface_name::convex;
  }

  double PairModelBuilder::guess_penalty() const
  {
    return penalty_over_stiffness * options_.pair_modulus() /
           gears_.teeth[1]->blank().outer_module();
  }

  void PairModelBuilder::choose_points(Model &model, Log &log) const
  {
    // Both sides alike, by the facets of the side that carries.
    const double width = 2 * TorquePressure(case_.hertz_contact(), model).semi_axes[1];
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

  void PairModelBuilder::add_contacts(Model &model, Log &log) const
  {
    ContactOptions options = options_.contact;
    if (options_.contact.penalty.is_open())
      options.penalty.value = guess_penalty();
    const Transmission &t = *model.only_transmission();
    // the side that carries comes first, the driver is the slave
    for (const MeshSide side :
         {side_, side_ == MeshSide::drive ? MeshSide::coast : MeshSide::drive})
      {
        ContactPair contact;
        contact.side           = side_name(side);
        contact.slave_body     = t.driver;
        contact.slave_surface  = surface_of(t.driver, side);
        contact.master_body    = t.driven;
        contact.master_surface = surface_of(t.driven, side);
        contact.options        = options;
        model.contacts.push_back(contact);
      }
    if (options_.contact.points_per_facet.is_word)
      choose_points(model, log);
  }

  void PairModelBuilder::add_probes(Model &model) const
  {
    const Body &gear = model.bodies[1];
    // Of all sectors that which passes the mesh at 75 % of the run: late, and still within it.
    const unsigned int tooth = gear_tooth_in_mesh(std::lround(0.75 * case_.run_meshes()));
    for (const char *set : {node_set::node_A_front, node_set::node_A_back})
      if (gear.has_node_set(set) && tooth < gear.node_set(set).size())
        model.probes.push_back({set, 1, gear.node_set(set)[tooth]});
  }

  unsigned int PairModelBuilder::gear_tooth_in_mesh(const unsigned int meshes) const
  {
    // Forward the gear turns about -: the next tooth in the + sense comes.
    const unsigned int teeth = gears_.teeth[1]->blank().teeth, passed = meshes % teeth;
    const bool         forward = operation_.direction == TurningDirection::forward;
    return (gears_.gear_tooth + (forward ? passed : teeth - passed)) % teeth;
  }

  std::vector<BodyFigures> PairModelBuilder::measure_bodies(const Model &model) const
  {
    std::vector<BodyFigures> figures;
    for (unsigned int b = 0; b < 2; ++b)
      figures.emplace_back(model.bodies[b],
                           *gears_.teeth[b],
                           options_.members[b].sized(gears_.teeth[b]->blank()));
    return figures;
  }
} // namespace vfife
