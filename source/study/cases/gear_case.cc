// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/parameters/section_of_options.h>
#include <vfife/base/process/log.h>
#include <vfife/gear/flank_points.h>
#include <vfife/gear/rating/iso10300_b1.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/gear/unloaded_contact/unloaded_contact.h>
#include <vfife/mesh/gear/gear_body_check.h>
#include <vfife/mesh/gear/gear_body_sizes.h>
#include <vfife/mesh/gear/gear_meridian.h>
#include <vfife/mesh/gear/gear_shaft_check.h>
#include <vfife/mesh/shaft_sections.h>
#include <vfife/study/cases/body_figures.h>
#include <vfife/study/cases/contact_resolution.h>
#include <vfife/study/cases/gear_case.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vfife
{
  std::string GearCase::Member::section() const
  {
    return "Gear pair/" + name;
  }

  std::string GearCase::Member::shaft_section() const
  {
    return section() + "/Shaft";
  }

  std::vector<ShaftSection> GearCase::Member::shaft_sections() const
  {
    return body.shaft.present() ? body.shaft.sections(shaft_section())
                                : std::vector<ShaftSection>();
  }

  GearBodyOptions GearCase::Member::with_levels(const BlankOutline &blank) const
  {
    GearBodyOptions options = with_open_sizes(body, blank);
    options.shaft.levels    = supports.levels();
    return options;
  }

  GearCase::GearCase()
  {
    members_[0].name = "Pinion";
    members_[0].body = pinion_body_defaults();
    members_[1].name = "Gear";
    for (Member &member : members_)
      member.body.leave_sizes_open();
    contact_.penalty.derivation = "teeth approach each other as on the contact's own grid, each "
                                  "contact point has its value";
  }

  void GearCase::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    const auto inside = [this](dealii::ParameterHandler &handler, const auto &function) {
      Subsection section(handler, "Gear pair");
      for (Member &member : members_)
        {
          Subsection subsection(handler, member.name);
          function(member);
        }
    };
    // Passes for the names of materials and bearings, then for the bearings' kinds.
    file.read_known([&](dealii::ParameterHandler &first) {
      inside(first, [&first](Member &member) {
        member.materials.declare(first, "");
        Subsection shaft(first, "Shaft");
        member.supports.declare_bearing_names(first);
      });
    });
    file.read_known([&](dealii::ParameterHandler &second) {
      inside(second, [&second](Member &member) {
        Subsection shaft(second, "Shaft");
        member.supports.declare_kinds(second);
      });
    });
    {
      Subsection section(prm, "Gear pair");
      pair_.declare(prm);
      GearBodyOptions::declare_fineness(prm,
                                        members_[0].body,
                                        members_[1].body,
                                        file.contains("Gear pair/Pinion/Mesh") ||
                                          file.contains("Gear pair/Gear/Mesh"));
      Subsection housing(prm, "Housing");
      declare_file_name(
        prm,
        "stiffness",
        housing_,
        "File of the housing's stiffness (Matrix Market): symmetric, six rows per bearing, first "
        "the pinion's, then the gear's: displacements [mm] and rotations [rad] along x, y, z of "
        "the fixed frame; forces in N, moments in N mm; empty: rigid housing");
    }
    inside(prm, [&prm](Member &member) {
      member.materials.declare(prm, "rim, web, hub, shaft");
      member.body.declare(prm);
      Subsection shaft(prm, "Shaft");
      member.supports.declare(prm);
    });

    std::vector<std::string> names = members_[0].materials.names();
    for (const std::string &name : members_[1].materials.names())
      names.push_back(name);
    materials_.declare(prm, file, names);
    operation_.declare(prm);
    declare_section(prm, "Contact", contact_);
    Subsection contact(prm, "Contact");
    declare_choice(
      prm,
      "penalty elements",
      reference_degree_,
      {{"quadratic", 2u}, {"cubic", 3u}, {"as the run", 1u}},
      "Elements whose mean transmission error at rest calibrates the penalty auto "
      "in runs, reduced pairs and waves. quadratic, cubic: these elements on a mesh "
      "of 2 x 3 elements in the section of a tooth (cubic: 40 s longer, mean of the "
      "reference pair at speed 0.2 % instead of 1.4 % too small); as the run: the elements of the "
      "run, which are up to 5 % too stiff");
  }

  void GearCase::check() const
  {
    check_bodies();
    operation_.require_speed("Operation");
    check_operation();
  }

  void GearCase::check_at_rest() const
  {
    check_bodies();
    check_operation();
  }

  void GearCase::check_operation() const
  {
    operation_.check("Operation");
    // There waves along a bar would be slower than the pitch circle.
    if (!(ring_strain() < 1))
      throw InputError("Operation/speed",
                       "a free ring at the pitch circle would be stretched by " +
                         std::to_string(std::lround(std::min(1e9, 1e2 * ring_strain()))) +
                         " %. Reduce the speed");
    contact_.check("Contact");
    if (contact_.surface == ContactSurfaceKind::true_flank ||
        contact_.surface == ContactSurfaceKind::automatic)
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

  void GearCase::check_shafts() const
  {
    std::optional<GearPair> pair;
    if (members_[0].body.shaft.present() || members_[1].body.shaft.present())
      pair.emplace(pair_);
    for (unsigned int b = 0; b < 2; ++b)
      {
        // The shaft by itself, then what sits on it, then the cells that end there.
        const Member     &member  = members_[b];
        const std::string section = member.shaft_section();
        const auto        check   = [&](const auto &body_of) {
          if (!pair)
            return;
          const GearMember &gear = b == 0 ? pair->pinion() : pair->gear();
          check_gear_shaft(section, gear, body_of(gear.blank()));
        };
        check([&](const Blank &blank) { return with_open_sizes(member.body, blank); });
        member.supports.check(section, member.shaft_sections());
        check([&](const Blank &blank) { return member.with_levels(blank); });
      }
  }

  void GearCase::check_surface_layers() const
  {
    if (!(members_[0].body.surface_layer > 0.) && !(members_[1].body.surface_layer > 0.))
      return;
    const GearPair pair(pair_);
    for (unsigned int b = 0; b < 2; ++b)
      check_surface_layer("Gear pair/" + members_[b].name + "/Mesh",
                          b == 0 ? pair.pinion() : pair.gear(),
                          members_[b].body.fillet_corner,
                          members_[b].body.surface_layer);
  }

  void GearCase::check_bodies() const
  {
    pair_.check("Gear pair");
    // Bodies are checked against blanks with everything that is derived from other entries.
    const GearPairOptions completed  = pair_.completed();
    const auto            check_body = [](const Member &member, const Blank &blank) {
      check_gear_body("Gear pair/" + member.name, with_open_sizes(member.body, blank), blank);
    };
    check_body(members_[0], completed.pinion.blank);
    check_body(members_[1], completed.gear.blank);
    check_shafts();
    check_surface_layers();
    for (const Member &member : members_)
      member.materials.check(member.section(), "teeth"); // their contact has one modulus
    for (const unsigned int body : {0u, 1u})
      material_of(body);
    materials_.check();
  }

  const Material &GearCase::material_of(const unsigned int body) const
  {
    const Member &member = members_[body];
    return materials_.find(member.materials.material, member.section() + "/material");
  }

  bool GearCase::has_web() const
  {
    return members_[1].body.web == WebKind::conical;
  }

  HertzContact GearCase::hertz_contact() const
  {
    const UnloadedContact contact(GearPair(pair_), working_side());
    // Curvatures do not depend on the separation of the ellipse that is asked for.
    const Vector2 curvatures =
      contact.ellipse(contact.contact(contact.reference(), 0), 1e-3).relative_curvatures;
    return HertzContact(curvatures, pair_modulus());
  }

  NamedFigures GearCase::rate(Log &log) const
  {
    try
      {
        const BevelRating rating =
          iso10300_b1(rated_pair(make_pair(), working_side(), pair_modulus()), torque_on(0));
        const double pinion = rating.teeth[0].root_stress, gear = rating.teeth[1].root_stress;
        log.line("ISO 10300 method B1, without factors K: contact stress ",
                 rating.contact_stress,
                 " MPa, root stress ",
                 pinion,
                 " MPa (pinion), ",
                 gear,
                 " MPa (gear)");
        return {{"nominal contact stress of iso 10300 b1", {rating.contact_stress, "MPa"}},
                {"pinion nominal root stress of iso 10300 b1", {pinion, "MPa"}},
                {"gear nominal root stress of iso 10300 b1", {gear, "MPa"}}};
      }
    catch (const InputError &error)
      {
        log.line("no nominal stresses. ", error.what());
        return {};
      }
  }

  std::array<BlankOutline, 2> GearCase::outlines() const
  {
    const GearPair pair = make_pair();
    return {{pair.pinion().blank(), pair.gear().blank()}};
  }

  double GearCase::backlash_angle() const
  {
    return make_pair().backlash_angle();
  }

  Table GearCase::flank_points(const unsigned int member,
                               const unsigned int lengthwise,
                               const unsigned int profile) const
  {
    const GearPair pair = make_pair();
    return compute_flank_points(member == 0 ? pair.pinion() : pair.gear(), lengthwise, profile);
  }

  Vector2 GearCase::arm_range() const
  {
    const ContactAnalysis analysis =
      analyse_contact(GearPair(pair_), working_side(), ContactAnalysisOptions());
    // (P x n) . a about the gear's axis, in its own frame; that of the pinion is in proportion.
    const auto arm = [](const PathPoint &point) {
      const GeneratedPoint &gear = point.contact.gear;
      return std::abs(gear.position.cross(gear.normal)[2]);
    };
    double least = arm(analysis.mean), largest = least;
    for (const PathPoint &point : analysis.path)
      {
        least   = std::min(least, arm(point));
        largest = std::max(largest, arm(point));
      }
    return Vector2(least, largest) / arm(analysis.mean);
  }

  std::optional<EdgesUnderLoad> GearCase::edges_under_load() const
  {
    if (operation_.driving != DrivingMember::pinion || working_side() != MeshSide::drive)
      return {};
    const GearPair pair(pair_);
    return EdgesUnderLoad(analyse_contact(pair, MeshSide::drive, ContactAnalysisOptions()),
                          pair.pinion().blank().teeth);
  }

  double GearCase::pair_modulus() const
  {
    const Material &pinion = material_of(0), &gear = material_of(1);
    return contact_modulus(pinion.youngs_modulus,
                           pinion.poissons_ratio,
                           gear.youngs_modulus,
                           gear.poissons_ratio);
  }

  std::array<unsigned int, 2> GearCase::teeth() const
  {
    const GearPairOptions completed = pair_.completed();
    return {{completed.pinion.blank.teeth, completed.gear.blank.teeth}};
  }

  double GearCase::ring_strain() const
  {
    const Blank  blank = pair_.completed().pinion.blank;
    const double speed = operation_.speed * largest_speed_factor() * blank.outer_cone_distance *
                         std::sin(blank.pitch_angle);
    double strain = 0;
    for (const unsigned int body : {0u, 1u})
      strain =
        std::max(strain,
                 material_of(body).density * speed * speed / material_of(body).youngs_modulus);
    return strain;
  }

  double GearCase::ring_rate() const
  {
    const Blank     gear     = pair_.completed().gear.blank;
    const Material &material = material_of(1);
    return std::sqrt(material.youngs_modulus / material.density) /
           (gear.outer_cone_distance * std::sin(gear.pitch_angle));
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

  std::vector<BodyFigures> GearCase::measure_bodies(const Model &model) const
  {
    const GearPair pair(pair_);
    return {BodyFigures(model.bodies[0], pair.pinion(), body_of(pair.pinion(), 0)),
            BodyFigures(model.bodies[1], pair.gear(), body_of(pair.gear(), 1))};
  }

  GearBodyOptions GearCase::body_of(const GearMember &gear, const unsigned int b) const
  {
    return with_open_sizes(members_[b].body, gear.blank());
  }

  Table GearCase::meridian_table() const
  {
    const GearPair pair(pair_);
    Table          table = make_meridian_table();
    add_meridian_rows(pair.pinion(), body_of(pair.pinion(), 0), table);
    add_meridian_rows(pair.gear(), body_of(pair.gear(), 1), table);
    return table;
  }
} // namespace vfife
