// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/contact/law/hertz.h>
#include <vfife/mesh/gear/gear_body_check.h>
#include <vfife/mesh/gear/gear_body_sizes.h>
#include <vfife/mesh/gear/gear_shaft_check.h>
#include <vfife/mesh/shaft_sections.h>
#include <vfife/study/cases/pair/pair_options.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <optional>

namespace vfife
{
  std::string MemberOptions::section() const
  {
    return pair + "/" + name;
  }

  std::string MemberOptions::shaft_section() const
  {
    return section() + "/Shaft";
  }

  std::vector<ShaftSection> MemberOptions::shaft_sections() const
  {
    return body.shaft.present() ? body.shaft.sections(shaft_section())
                                : std::vector<ShaftSection>();
  }

  GearBodyOptions MemberOptions::sized(const BlankOutline &blank) const
  {
    return with_open_sizes(body, blank);
  }

  GearBodyOptions MemberOptions::with_levels(const BlankOutline &blank) const
  {
    GearBodyOptions options = sized(blank);
    options.shaft.levels    = supports.levels();
    return options;
  }

  PairOptions::PairOptions(const std::string &section_)
    : section(section_)
  {
    members[0].name = "Pinion";
    members[0].body = pinion_body_defaults();
    members[1].name = "Gear";
    for (MemberOptions &member : members)
      {
        member.pair = section;
        member.body.leave_sizes_open();
      }
    contact.penalty.derivation = "teeth approach each other as on the contact's own grid, each "
                                 "contact point has its value";
  }

  void
  PairOptions::declare_bodies(dealii::ParameterHandler                              &prm,
                              const ParameterFile                                   &file,
                              const std::function<void(dealii::ParameterHandler &)> &declare_teeth)
  {
    const auto inside = [this](dealii::ParameterHandler &handler, const auto &function) {
      const Subsection of_pair(handler, section);
      for (MemberOptions &member : members)
        {
          Subsection subsection(handler, member.name);
          function(member);
        }
    };
    // Passes for the names of materials and bearings, then for the bearings' kinds.
    file.read_known([&](dealii::ParameterHandler &first) {
      inside(first, [&first](MemberOptions &member) {
        member.materials.declare(first, "");
        Subsection shaft(first, "Shaft");
        member.supports.declare_bearing_names(first);
      });
    });
    file.read_known([&](dealii::ParameterHandler &second) {
      inside(second, [&second](MemberOptions &member) {
        Subsection shaft(second, "Shaft");
        member.supports.declare_kinds(second);
      });
    });
    {
      const Subsection of_pair(prm, section);
      declare_teeth(prm);
      GearBodyOptions::declare_fineness(prm,
                                        members[0].body,
                                        members[1].body,
                                        file.contains(section + "/Pinion/Mesh") ||
                                          file.contains(section + "/Gear/Mesh"));
      const Subsection subsection(prm, "Housing");
      declare_file_name(
        prm,
        "stiffness",
        housing,
        "File of the housing's stiffness (Matrix Market): symmetric, six rows per bearing, first "
        "the pinion's, then the gear's: displacements [mm] and rotations [rad] along x, y, z of "
        "the fixed frame; forces in N, moments in N mm; empty: rigid housing");
    }
    inside(prm, [&prm](MemberOptions &member) {
      member.materials.declare(prm, "rim, web, hub, shaft");
      member.body.declare(prm);
      Subsection shaft(prm, "Shaft");
      member.supports.declare(prm);
    });

    std::vector<std::string> names = members[0].materials.names();
    for (const std::string &name : members[1].materials.names())
      names.push_back(name);
    materials.declare(prm, file, names);
  }

  void PairOptions::declare_contact(dealii::ParameterHandler &prm)
  {
    declare_section(prm, "Contact", contact);
    const Subsection of_contact(prm, "Contact");
    declare_choice(
      prm,
      "penalty elements",
      reference_degree,
      {{"quadratic", 2u}, {"cubic", 3u}, {"as the run", 1u}},
      "Elements whose mean transmission error at rest calibrates the penalty auto "
      "in runs, reduced pairs and waves. quadratic, cubic: these elements on a mesh "
      "of 2 x 3 elements in the section of a tooth (cubic: 40 s longer, mean of the "
      "reference pair at speed 0.2 % instead of 1.4 % too small); as the run: the elements of the "
      "run, which are up to 5 % too stiff");
  }

  namespace
  {
    void check_shafts(const PairOptions &options, const std::function<PairTeeth()> &make_teeth)
    {
      std::optional<PairTeeth> teeth;
      if (options.members[0].body.shaft.present() || options.members[1].body.shaft.present())
        teeth = make_teeth();
      for (unsigned int b = 0; b < 2; ++b)
        {
          // The shaft by itself, then what sits on it, then the cells that end there.
          const MemberOptions &member  = options.members[b];
          const std::string    section = member.shaft_section();
          const auto           check   = [&](const auto &body_of) {
            if (teeth)
              check_gear_shaft(section, *(*teeth)[b], body_of((*teeth)[b]->blank()));
          };
          check([&](const BlankOutline &blank) { return member.sized(blank); });
          member.supports.check(section, member.shaft_sections());
          check([&](const BlankOutline &blank) { return member.with_levels(blank); });
        }
    }

    void check_surface_layers(const PairOptions                &options,
                              const std::function<PairTeeth()> &make_teeth)
    {
      if (!(options.members[0].body.surface_layer > 0.) &&
          !(options.members[1].body.surface_layer > 0.))
        return;
      const PairTeeth teeth = make_teeth();
      for (unsigned int b = 0; b < 2; ++b)
        check_surface_layer(options.members[b].section() + "/Mesh",
                            *teeth[b],
                            options.members[b].body.fillet_corner,
                            options.members[b].body.surface_layer);
    }
  } // namespace

  void PairOptions::check_bodies(const std::array<BlankOutline, 2> &blanks,
                                 const std::function<PairTeeth()>  &make_teeth) const
  {
    for (unsigned int b = 0; b < 2; ++b)
      check_gear_body(members[b].section(), members[b].sized(blanks[b]), blanks[b]);
    check_shafts(*this, make_teeth);
    check_surface_layers(*this, make_teeth);
    for (const MemberOptions &member : members)
      member.materials.check(member.section(), "teeth"); // their contact has one modulus
    for (const unsigned int body : {0u, 1u})
      material_of(body);
    materials.check();
  }

  const Material &PairOptions::material_of(const unsigned int body) const
  {
    const MemberOptions &member = members[body];
    return materials.find(member.materials.material, member.section() + "/material");
  }

  double PairOptions::pair_modulus() const
  {
    const Material &pinion = material_of(0), &gear = material_of(1);
    return contact_modulus(pinion.youngs_modulus,
                           pinion.poissons_ratio,
                           gear.youngs_modulus,
                           gear.poissons_ratio);
  }

  void PairOptions::coarsen()
  {
    for (MemberOptions &member : members)
      member.body = coarse(member.body);
  }

  void PairOptions::refine_for_submodels(const unsigned int cells_lengthwise,
                                         const PairTeeth   &teeth)
  {
    // With 10 cells lengthwise the tooth of doc/verification/gear-pair.md, Root stress, is within 1
    // %.
    constexpr double layer   = .13; ///< over the module
    constexpr double grading = 4.;
    // 20 and 10 change the stress of the web's fillet at the hub by 0.4 %.
    constexpr unsigned int web_rows = 12, fillet_rows = 6;
    coarsen();
    for (unsigned int b = 0; b < 2; ++b)
      {
        GearBodyOptions &body       = members[b].body;
        body.cells_lengthwise       = cells_lengthwise;
        body.grading_towards_fillet = grading;
        body.web_rows               = web_rows;
        body.fillet_rows            = fillet_rows;
        body.surface_layer          = std::min(layer * teeth[b]->blank().outer_module(),
                                      find_largest_surface_layer(*teeth[b], body.fillet_corner));
      }
  }
} // namespace vfife
