// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/gear/flank_points.h>
#include <vfife/gear/rating/iso10300_b1.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/gear/unloaded_contact/unloaded_contact.h>
#include <vfife/mesh/gear/gear_meridian.h>
#include <vfife/study/cases/gear/gear_case.h>
#include <vfife/study/cases/pair/pair_conflicts.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Both members of a pair. */
    PairTeeth copy_teeth(const GearPair &pair)
    {
      return {{pair.pinion().clone(), pair.gear().clone()}};
    }

    MountedGears mount(const GearPair &pair, const MeshSide side)
    {
      const MeanContact &mean   = pair.mean_contact(side);
      const RigidMotion  pinion = pair.pinion_placement(0.);
      MountedGears       gears;
      gears.teeth = copy_teeth(pair);
      // The generated flanks touch; the pinion's is turned onto its tooth 0.
      gears.placements = {
        {pair.pinion_placement(mean.rot1 - pair.pinion().turn(pair.pinion_side(side))),
         pair.gear_placement(mean.rot2)}};
      gears.contact_point  = mean.position;
      gears.contact_normal = mean.normal;
      // The pair knows the arm about the gear's axis only.
      gears.arms = {
        {std::abs(
           (mean.position - pinion.translation).cross(mean.normal).dot(pinion.rotation.col(2))),
         mean.arm}};
      gears.gear_tooth   = side == MeshSide::drive ? 0 : 1;
      gears.drive_flanks = {{pair.pinion_side(MeshSide::drive), pair.gear_side(MeshSide::drive)}};
      return gears;
    }
  } // namespace

  GearCaseOptions::GearCaseOptions()
    : PairOptions(spiral_bevel_section)
  {
  }

  void GearCaseOptions::declare_bodies(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    PairOptions::declare_bodies(prm, file, [this](dealii::ParameterHandler &inside) {
      pair.declare(inside);
    });
  }

  void GearCaseOptions::check_bodies() const
  {
    pair.check(section);
    // Bodies are checked against blanks with everything that is derived from other entries.
    const GearPairOptions completed = pair.completed();
    PairOptions::check_bodies({{completed.pinion.blank, completed.gear.blank}},
                              [this] { return copy_teeth(GearPair(pair)); });
  }

  GearCaseOptions GearCaseOptions::for_reference() const
  {
    GearCaseOptions reference = *this;
    reference.coarsen();
    return reference;
  }

  GearCaseOptions GearCaseOptions::for_submodels(const unsigned int cells_lengthwise) const
  {
    GearCaseOptions fine = *this;
    fine.refine_for_submodels(cells_lengthwise, copy_teeth(GearPair(pair)));
    return fine;
  }

  void GearCase::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    options_.declare_bodies(prm, file);
    operation_.declare(prm);
    options_.declare_contact(prm);
  }

  void GearCase::check_bodies() const
  {
    options_.check_bodies();
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
    options_.contact.check("Contact");
    if (options_.contact.surface == ContactSurfaceKind::true_flank ||
        options_.contact.surface == ContactSurfaceKind::automatic)
      return;
    // Errors are part of the offsets to the true flank: facets and patches know nothing of them.
    const GearPair pair(options_.pair);
    if (pair.pinion().has_deviations() || pair.gear().has_deviations())
      throw InputError("Contact/surface",
                       "errors of the flanks (Gear pair/Errors) act on surface = true flank only");
  }

  GearPair GearCase::make_pair() const
  {
    return GearPair(options_.pair);
  }

  HertzContact GearCase::hertz_contact() const
  {
    return hertz_contact_of(make_pair());
  }

  HertzContact GearCase::hertz_contact_of(const GearPair &pair) const
  {
    const UnloadedContact contact(pair, working_side());
    // Curvatures do not depend on the separation of the ellipse that is asked for.
    const Vector2 curvatures =
      contact.ellipse(contact.contact(contact.reference(), 0), 1e-3).relative_curvatures;
    return HertzContact(curvatures, options_.pair_modulus());
  }

  NamedFigures GearCase::rate(Log &log) const
  {
    try
      {
        const BevelRating rating =
          iso10300_b1(rated_pair(make_pair(), working_side(), options_.pair_modulus()),
                      torque_on(0));
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
      analyse_contact(GearPair(options_.pair), working_side(), ContactAnalysisOptions());
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
    const GearPair pair(options_.pair);
    return EdgesUnderLoad(analyse_contact(pair, MeshSide::drive, ContactAnalysisOptions()),
                          pair.pinion().blank().teeth);
  }

  std::array<unsigned int, 2> GearCase::teeth() const
  {
    const GearPairOptions completed = options_.pair.completed();
    return {{completed.pinion.blank.teeth, completed.gear.blank.teeth}};
  }

  double GearCase::ring_strain() const
  {
    const Blank  blank = options_.pair.completed().pinion.blank;
    const double speed = operation_.speed * largest_speed_factor() * blank.outer_cone_distance *
                         std::sin(blank.pitch_angle);
    double strain = 0;
    for (const unsigned int body : {0u, 1u})
      strain = std::max(strain,
                        options_.material_of(body).density * speed * speed /
                          options_.material_of(body).youngs_modulus);
    return strain;
  }

  double GearCase::ring_rate() const
  {
    const Blank     gear     = options_.pair.completed().gear.blank;
    const Material &material = options_.material_of(1);
    return std::sqrt(material.youngs_modulus / material.density) /
           (gear.outer_cone_distance * std::sin(gear.pitch_angle));
  }

  MeshSide GearCase::working_side() const
  {
    return vfife::working_side(operation_.driving, operation_.direction);
  }

  std::vector<BodyFigures> GearCase::measure_bodies(const Model &model) const
  {
    return builder(options_, make_pair()).measure_bodies(model);
  }

  Table GearCase::meridian_table() const
  {
    const GearPair pair(options_.pair);
    Table          table = make_meridian_table();
    add_meridian_rows(pair.pinion(), options_.members[0].sized(pair.pinion().blank()), table);
    add_meridian_rows(pair.gear(), options_.members[1].sized(pair.gear().blank()), table);
    return table;
  }

  PairModelBuilder GearCase::builder(const GearCaseOptions &options, const GearPair &pair) const
  {
    return PairModelBuilder(options, mount(pair, working_side()), *this);
  }

  Model GearCase::make_model(Log &log) const
  {
    for (const std::string &message : options_.pair.examine().warnings())
      log.warning(message);
    return builder(options_, make_pair()).make(log);
  }

  Model GearCase::make_silently(const GearCaseOptions &options) const
  {
    std::ostringstream nothing;
    Log                quiet(nothing, false);
    return builder(options, GearPair(options.pair)).make(quiet);
  }

  std::optional<Model> GearCase::make_reference_model() const
  {
    if (reference_degree() == 1)
      return std::nullopt;
    return make_silently(options_.for_reference());
  }

  std::optional<Model> GearCase::make_submodel_mesh(const unsigned int cells_lengthwise) const
  {
    return make_silently(options_.for_submodels(cells_lengthwise));
  }

  std::optional<TorquePressure> GearCase::torque_pressure(const GearPair &pair) const
  {
    if (!(driven_torque() > 0))
      return {};
    const double arm = builder(options_, pair).make_transmission().arm;
    return TorquePressure(hertz_contact_of(pair), driven_torque() / arm);
  }

  PairFacts GearCase::facts(const bool with_path) const
  {
    const GearPair pair = make_pair();
    PairFacts      facts{ring_strain(), options_.has_web(), torque_pressure(pair), ""};
    if (with_path)
      try
        {
          UnloadedContact(pair, working_side()).path_range();
        }
      catch (const NumericalError &error)
        {
          facts.fault_of_path = error.what();
        }
    return facts;
  }
} // namespace vfife
