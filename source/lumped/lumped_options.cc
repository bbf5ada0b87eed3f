// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/number_list.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameter_table.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/quantity.h>
#include <vfife/lumped/lumped_options.h>

#include <deal.II/base/parameter_handler.h>

namespace vfife
{
  namespace
  {
    const Choices<SupportMember> members = {{"pinion", SupportMember::pinion},
                                            {"gear", SupportMember::gear}};
    const Choices<bool>          motions = {{"translation", false}, {"tilt", true}};
    const Choices<MeshSource>    sources = {{"series", MeshSource::series},
                                            {"loaded contact", MeshSource::loaded_contact}};
    const Choices<LoadLaw>       laws    = {{"power", LoadLaw::power},
                                            {"tangent", LoadLaw::tangent},
                                            {"secant", LoadLaw::secant}};
    const Choices<bool>          drives  = {{"prescribed rotation", false}, {"free", true}};

    /**
     * Numbers of a list in internal units; bare ones are in @p unit. Throws
     * InputError for the entry.
     */
    std::vector<double> parse_list(const std::string              &entry,
                                   const std::vector<std::string> &texts,
                                   const std::string              &unit)
    {
      return for_entry("Lumped/" + entry, [&] { return read_number_list(texts, unit); });
    }

    /** Throws where an entry is neither given nor taken from a gear pair. */
    void need(const bool given, const std::string &entry)
    {
      if (!given)
        throw InputError("Lumped/" + entry,
                         entry + " is missing. Set it, or add a section Gear pair that defines it");
    }
  } // namespace

  void SupportOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(prm, "member", member, members, "Member on this support");
    declare_choice(prm,
                   "motion",
                   tilts,
                   motions,
                   "Motion of the support: a displacement, or a tilt (small rotation)");
    declare_vector(prm,
                   "direction",
                   direction,
                   "-",
                   "Direction of the displacement, or axis of the tilt, in the fixed frame; any "
                   "length");
    declare_vector(
      prm, "centre", centre, "mm", "Point on the axis of the tilt, in the fixed frame");
    declare_quantity(
      prm, "mass", mass, "kg", "Mass that moves with the displacement", Range::not_negative());
    declare_quantity(prm,
                     "inertia",
                     inertia,
                     "kg mm^2",
                     "Moment of inertia about the axis of the tilt",
                     Range::not_negative());
    declare_quantity(prm,
                     "stiffness",
                     stiffness,
                     "N/mm",
                     "Stiffness against the displacement",
                     Range::not_negative());
    declare_quantity(prm,
                     "tilt stiffness",
                     tilt_stiffness,
                     "N m/rad",
                     "Stiffness against the tilt",
                     Range::not_negative());
    declare_number(prm,
                   "damping ratio",
                   damping_ratio,
                   "Damping ratio of this support's mass on its own spring",
                   Range::not_negative());
  }

  void SupportOptions::check(const std::string &section) const
  {
    if (!(direction.norm() > 0))
      throw InputError(section + "/direction",
                       "expected a direction of the support, got the zero vector");
    if (!((tilts ? inertia : mass) > 0))
      throw InputError(section + (tilts ? "/inertia" : "/mass"),
                       tilts ? "must be positive for a tilt"
                             : "must be positive for a translation");
    if (!((tilts ? tilt_stiffness : stiffness) > 0))
      throw InputError(section + (tilts ? "/tilt stiffness" : "/stiffness"),
                       tilts ? "must be positive for a tilt"
                             : "must be positive for a translation");
  }

  void LumpedOptions::declare_mesh(dealii::ParameterHandler &prm)
  {
    declare_choice(prm,
                   "mesh stiffness source",
                   source,
                   sources,
                   "Source of mesh stiffness and unloaded transmission error over a mesh cycle: "
                   "the Fourier series below, or a loaded tooth contact analysis");
    declare_file_name(prm, "table", table, "File loaded_contact.csv of that analysis");
    declare_choice(prm,
                   "load law",
                   load_law,
                   laws,
                   "Torque as a function of compression from the table: a power law with "
                   "the given secant and tangent stiffness, or two straight lines");
    declare_quantity(
      prm, "stiffness", stiffness, "N m/rad", "Mean mesh stiffness", Range::not_negative());
    declare_number_list(
      prm,
      "stiffness cosines",
      stiffness_cosines,
      "Cosine coefficients of the mesh stiffness, mesh orders 1, 2, ..., divided by "
      "the mean stiffness [-]");
    declare_number_list(prm,
                        "stiffness sines",
                        stiffness_sines,
                        "Sine coefficients of the mesh stiffness, likewise [-]");
    declare_number_list(prm,
                        "error cosines",
                        error_cosines,
                        "Cosine coefficients of the unloaded transmission error, mesh orders 1, 2, "
                        "... [arcsec]");
    declare_number_list(prm,
                        "error sines",
                        error_sines,
                        "Sine coefficients of the unloaded transmission error [arcsec]");
    declare_quantity(prm,
                     "backlash",
                     backlash,
                     "mm",
                     "Normal backlash at the mean point; negative: that of the gear pair");
    declare_number(prm,
                   "damping ratio",
                   damping_ratio,
                   "Damping ratio of the mesh: damper divided by the critical damping of the "
                   "torsional vibration of both members",
                   Range::not_negative());
    declare_switch(prm,
                   "damping without contact",
                   damping_without_contact,
                   "Whether the damper also acts while the flanks are apart");
    declare_quantity(prm,
                     "driven speed damping",
                     speed_damping,
                     "1/s",
                     "Torque on the gear per moment of inertia and per deviation from its "
                     "kinematic speed, as Dynamics/driven speed damping",
                     Range::not_negative());
  }

  void LumpedOptions::declare_pair(dealii::ParameterHandler &prm)
  {
    const std::string from = "; auto: of the gear pair";
    declare_choice(prm,
                   "pinion",
                   driver_is_free,
                   drives,
                   "Motion of the pinion: constant speed, or free under its part of the torque");
    declare_integer(prm, "pinion teeth", driver_teeth, "Number; 0: of the gear pair");
    declare_integer(prm, "gear teeth", driven_teeth, "Number; 0: of the gear pair");
    declare_quantity(prm,
                     "pinion inertia",
                     driver_inertia,
                     "kg mm^2",
                     "Moment of inertia about the own axis" + from,
                     Range::positive().or_word("auto"));
    declare_quantity(prm,
                     "gear inertia",
                     driven_inertia,
                     "kg mm^2",
                     "Moment of inertia about the own axis" + from,
                     Range::positive().or_word("auto"));
    declare_quantity(prm,
                     "lever arm",
                     arm,
                     "mm",
                     "Lever arm of the contact normal about the gear's axis" + from,
                     Range::positive().or_word("auto"));
    declare_vector(prm,
                   "contact normal",
                   contact_normal,
                   "-",
                   "Contact normal out of the gear into the pinion, in the fixed frame; needed "
                   "with supports; 0, 0, 0: of the gear pair");
    declare_vector(prm,
                   "contact point",
                   contact_point,
                   "mm",
                   "Contact point in the fixed frame; needed with a contact normal");
    declare_names(prm,
                  "supports",
                  support_names,
                  "Names of supports; each has a subsection \"Support NAME\"");
    declare_switch(prm,
                   "bearings",
                   in_bearings,
                   "Members move as rigid bodies in their shafts' bearings; for a mesh stiffness "
                   "that was computed with ideal bores");
  }

  void LumpedOptions::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    // The names of the supports decide which subsections there are: they are read first,
    // everything else ignored.
    file.read_known([this](dealii::ParameterHandler &first) {
      Subsection section(first, "Lumped");
      declare_pair(first);
    });
    supports.assign(support_names.size(), SupportOptions());
    Subsection section(prm, "Lumped");
    declare_mesh(prm);
    declare_pair(prm);
    for (std::size_t i = 0; i < supports.size(); ++i)
      {
        supports[i].name = support_names[i];
        declare_section(prm, "Support " + support_names[i], supports[i]);
      }
  }

  void LumpedOptions::check() const
  {
    if (source == MeshSource::loaded_contact && table.empty())
      throw InputError(
        "Lumped/table",
        "mesh stiffness source = loaded contact needs the loaded_contact.csv of a loaded tooth "
        "contact analysis");
    if (source == MeshSource::series && !(stiffness > 0))
      throw InputError("Lumped/stiffness",
                       "Lumped/mesh stiffness source = series needs the mean mesh stiffness; a "
                       "loaded tooth contact "
                       "analysis finds it");
    for (const SupportOptions &support : supports)
      support.check("Lumped/Support " + support.name);
  }

  LumpedPair LumpedOptions::make_pair(const double torque) const
  {
    // Zeros stand for what a gear pair would have given.
    need(driver_teeth > 0, "pinion teeth");
    need(driven_teeth > 0, "gear teeth");
    need(driven_inertia > 0, "gear inertia");
    need(!driver_is_free || driver_inertia > 0, "pinion inertia");
    need(arm > 0, "lever arm");
    need(backlash >= 0, "backlash");
    need(supports.empty() || contact_normal.norm() > 0, "contact normal");
    LumpedPair pair;
    pair.driver_teeth            = driver_teeth;
    pair.driven_teeth            = driven_teeth;
    pair.driver_is_free          = driver_is_free;
    pair.driver_inertia          = driver_inertia;
    pair.driven_inertia          = driven_inertia;
    pair.arm                     = arm;
    pair.torque                  = torque;
    pair.damping_ratio           = damping_ratio;
    pair.damping_without_contact = damping_without_contact;
    pair.speed_damping           = speed_damping;
    if (source == MeshSource::loaded_contact)
      pair.law = for_entry("Lumped/table", [this] {
        return MeshLaw::from_table(read_parameter_table(table), table, load_law);
      });
    else
      {
        // Given over the mean stiffness; their sum below one keeps k(x) positive.
        std::vector<double> cosines = parse_list("stiffness cosines", stiffness_cosines, "-");
        std::vector<double> sines   = parse_list("stiffness sines", stiffness_sines, "-");
        double              sum     = 0;
        for (std::vector<double> *list : {&cosines, &sines})
          for (double &value : *list)
            {
              sum += std::abs(value);
              value *= stiffness;
            }
        if (!(sum < 1))
          throw InputError(
            "Lumped/stiffness cosines",
            "the sum of all amplitudes must be below 1; otherwise the stiffness becomes negative");
        pair.law.stiffness = FourierSeries(stiffness, cosines, sines);
        pair.law.unloaded_error =
          FourierSeries(0.,
                        parse_list("error cosines", error_cosines, "arcsec"),
                        parse_list("error sines", error_sines, "arcsec"));
        // p = 1: any torque serves as T0.
        pair.law.reference_torque = torque;
      }
    // [mm] along the normal to [rad] of the gear.
    pair.law.backlash = backlash / arm;
    for (const SupportOptions &support : supports)
      {
        // The motion of the contact point P by a unit of the support: d, or d x (P - c). The gap
        // closes by n . u of the gear, opens by that of the pinion; over the arm it is compression
        // in rad of the gear.
        const Vector3 d      = support.direction.normalized();
        const Vector3 motion = support.tilts ? d.cross(contact_point - support.centre) : d;
        const double  sign   = support.member == SupportMember::gear ? 1. : -1.;
        LumpedSupport s;
        s.name          = support.name;
        s.tilts         = support.tilts;
        s.lever         = sign * contact_normal.normalized().dot(motion) / arm;
        s.inertia       = support.tilts ? support.inertia : support.mass;
        s.stiffness     = support.tilts ? support.tilt_stiffness : support.stiffness;
        s.damping_ratio = support.damping_ratio;
        pair.supports.push_back(s);
      }
    return pair;
  }
} // namespace vfife
