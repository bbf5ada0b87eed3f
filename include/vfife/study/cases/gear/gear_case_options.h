// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_gear_gear_case_options_h
#define vfife_study_cases_gear_gear_case_options_h

#include <vfife/contact/law/contact_options.h>
#include <vfife/element/material_sections.h>
#include <vfife/gear/spiral_bevel/gear_pair_options.h>
#include <vfife/mesh/gear/gear_body_options.h>
#include <vfife/model/options/body_materials.h>
#include <vfife/study/cases/shaft_supports.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  class ParameterFile;

  /** The body of a member, its materials and what holds its shaft. */
  struct GearCaseMember
  {
    std::string     name; ///< of its section
    GearBodyOptions body;
    ShaftSupports   supports;
    BodyMaterials   materials;

    std::string section() const; ///< Gear pair/NAME
    /** Its section Gear pair/NAME/Shaft. */
    std::string               shaft_section() const;
    std::vector<ShaftSection> shaft_sections() const;
    /** The body under these teeth with all its sizes. */
    GearBodyOptions sized(const BlankOutline &blank) const;
    /** The same with levels of the mesh where seats begin and end. */
    GearBodyOptions with_levels(const BlankOutline &blank) const;
  };

  /** The sections Gear pair, Material ... and Contact of a spiral bevel pair. */
  struct GearCaseOptions
  {
    GearPairOptions               pair;
    std::array<GearCaseMember, 2> members; ///< by body, 0 the pinion
    std::string                   housing; ///< file of its stiffness; empty: rigid
    MaterialSections              materials;
    ContactOptions                contact;
    unsigned int                  reference_degree = 2; ///< Contact/penalty elements

    GearCaseOptions();

    /** The sections Gear pair and Material ... Bound by address. */
    void declare_bodies(dealii::ParameterHandler &prm, const ParameterFile &file);
    /** The section Contact. Bound by address. */
    void declare_contact(dealii::ParameterHandler &prm);

    /** Throws InputError where pair, bodies, shafts and materials contradict themselves or each
     * other. */
    void check_bodies() const;

    /** That of the teeth of a body. */
    const Material &material_of(unsigned int body) const;
    /** E* of both members [MPa]. */
    double pair_modulus() const;
    /** Whether the gear's rim is carried by an elastic web. */
    bool has_web() const
    {
      return members[1].body.web == WebKind::conical;
    }

    /** The same pair on the coarse mesh of PairCase::make_reference_model(). */
    GearCaseOptions for_reference() const;
    /** The same pair on the mesh of PairCase::make_submodel_mesh(). */
    GearCaseOptions for_submodels(unsigned int cells_lengthwise) const;
  };
} // namespace vfife

#endif
