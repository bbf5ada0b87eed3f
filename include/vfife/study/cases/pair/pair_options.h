// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_pair_pair_options_h
#define vfife_study_cases_pair_pair_options_h

#include <vfife/contact/law/contact_options.h>
#include <vfife/element/material_sections.h>
#include <vfife/gear/gear_geometry.h>
#include <vfife/mesh/gear/gear_body_options.h>
#include <vfife/model/options/body_materials.h>
#include <vfife/study/cases/shaft_supports.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  class ParameterFile;

  /** The gears of a pair, 0 the pinion. */
  using PairTeeth = std::array<std::unique_ptr<GearGeometry>, 2>;

  /** The body of a member, its materials and what holds its shaft. */
  struct MemberOptions
  {
    std::string     pair; ///< section of the pair
    std::string     name; ///< of its section in there
    GearBodyOptions body;
    ShaftSupports   supports;
    BodyMaterials   materials;

    std::string section() const; ///< PAIR/NAME
    /** Its section PAIR/NAME/Shaft. */
    std::string               shaft_section() const;
    std::vector<ShaftSection> shaft_sections() const;
    /** The body under these teeth with all its sizes. */
    GearBodyOptions sized(const BlankOutline &blank) const;
    /** The same with levels of the mesh where seats begin and end. */
    GearBodyOptions with_levels(const BlankOutline &blank) const;
  };

  /** What a pair of gears of any kind has beside its teeth: bodies, housing, materials, contact. */
  struct PairOptions
  {
    std::string                  section; ///< of the pair
    std::array<MemberOptions, 2> members; ///< by body, 0 the pinion
    std::string                  housing; ///< file of its stiffness; empty: rigid
    MaterialSections             materials;
    ContactOptions               contact;
    unsigned int                 reference_degree = 2; ///< Contact/penalty elements

    explicit PairOptions(const std::string &section);

    /** The section of the pair, where @p declare_teeth declares those of the kind, and Material
     * .... Bound by address. */
    void declare_bodies(dealii::ParameterHandler                              &prm,
                        const ParameterFile                                   &file,
                        const std::function<void(dealii::ParameterHandler &)> &declare_teeth);
    /** The section Contact. Bound by address. */
    void declare_contact(dealii::ParameterHandler &prm);

    /** Throws InputError where bodies, shafts and materials contradict themselves or each other.
     * @p make_teeth is called where these depend on teeth. */
    void check_bodies(const std::array<BlankOutline, 2> &blanks,
                      const std::function<PairTeeth()>  &make_teeth) const;

    /** That of the teeth of a body. */
    const Material &material_of(unsigned int body) const;
    /** E* of both members [MPa]. */
    double pair_modulus() const;
    /** Whether the gear's rim is carried by an elastic web. */
    bool has_web() const
    {
      return members[1].body.web == WebKind::conical;
    }

    /** Sets the coarse mesh of PairCase::make_reference_model(). */
    void coarsen();
    /** Sets the mesh of PairCase::make_submodel_mesh(). */
    void refine_for_submodels(unsigned int cells_lengthwise, const PairTeeth &teeth);
  };
} // namespace vfife

#endif
