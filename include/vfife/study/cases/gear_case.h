// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_gear_case_h
#define vfife_study_cases_gear_case_h

#include <vfife/base/text/table.h>
#include <vfife/element/material_sections.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/model/options/body_materials.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/cases/shaft_supports.h>
#include <vfife/study/cases/torque_pressure.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  /** A spiral bevel gear pair from the sections Gear pair, Material ..., Operation and Contact. */
  class GearCase : public PairCase
  {
  public:
    GearCase();

    void  declare(dealii::ParameterHandler &prm, const ParameterFile &file) override;
    void  check() const override;
    void  check_bodies() const override;
    Model make_model(Log &log) const override;
    void  check_at_rest() const override;
    std::array<unsigned int, 2> teeth() const override;
    double                      ring_rate() const override;
    HertzContact                hertz_contact() const override;
    bool                        leaves_penalty_open() const override
    {
      return contact_.penalty.is_open();
    }
    Vector2                       arm_range() const override;
    double                        backlash_angle() const override;
    std::optional<EdgesUnderLoad> edges_under_load() const override;
    /** By ISO 10300 method B1. */
    NamedFigures                rate(Log &log) const override;
    std::array<BlankOutline, 2> outlines() const override;
    std::optional<Model>        make_reference_model() const override;
    unsigned int                reference_degree() const override
    {
      return reference_degree_;
    }
    std::optional<Model>     make_submodel_mesh(unsigned int cells_lengthwise) const override;
    std::vector<BodyFigures> measure_bodies(const Model &model) const override;
    Table                    meridian_table() const override;
    Table
    flank_points(unsigned int member, unsigned int lengthwise, unsigned int profile) const override;

    /** Logs both torques and Hertz's contact besides, where there is a torque. */
    std::vector<std::string> report_checks(const RunPlan &plan, Log &log) const override;
    std::string              find_cause() const override;

    /** The pair with everything derived. */
    GearPair make_pair() const;

    /** Strain of a free ring at the pitch circles at the largest speed of a run, rho v^2 / E; the
     * larger of both members. */
    double ring_strain() const;

    /** What is wrong with Hertz's pressure under the torque; empty where it is allowed. */
    std::string find_excess_of_pressure() const;

    /** Whether the gear's rim is carried by an elastic web. */
    bool has_web() const;

    /** The flanks that carry the load. */
    MeshSide working_side() const;

    /** Gear tooth (sector) at the pitch point after @p meshes mesh cycles. */
    unsigned int gear_tooth_in_mesh(unsigned int meshes) const;

  private:
    /** One of both members, body 0 the pinion. */
    struct Member
    {
      std::string     name; ///< of its section
      GearBodyOptions body;
      ShaftSupports   supports;
      BodyMaterials   materials;

      std::string section() const; ///< Gear pair/NAME
      /** Its section Gear pair/NAME/Shaft. */
      std::string               shaft_section() const;
      std::vector<ShaftSection> shaft_sections() const;
      /** The body under these teeth with all its sizes, and levels of the mesh where seats begin
       * and end. */
      GearBodyOptions with_levels(const BlankOutline &blank) const;
    };
    /** Throws InputError for a load, speeds and contact that do not go together. */
    void check_operation() const;
    /** Hertz's contact of one tooth pair under all the torque. */
    TorquePressure torque_pressure() const;
    /** Throws InputError for shafts that do not go with their bodies or with what holds them. */
    void check_shafts() const;
    void check_surface_layers() const;
    /** That of the teeth. */
    const Material &material_of(unsigned int body) const;
    /** E* of both members [MPa]. */
    double       pair_modulus() const;
    Transmission make_transmission(const GearPair &pair) const;
    /** Of a body (0 pinion, 1 gear) with all its sizes. */
    GearBodyOptions body_of(const GearMember &gear, unsigned int body) const;
    /** Node set by which a body (0 pinion, 1 gear) is driven or held, or sits on its shaft. */
    const char *held_set(unsigned int body) const;
    Body        make_body(const GearPair &pair, unsigned int body) const;
    /** The penalty with which the contact's own grid is found where the section Contact gives none
     * [N/mm^3]. */
    double guess_penalty(const GearPair &pair) const;
    /** A model with another mesh, whose log nobody reads. */
    Model make_silent_model() const;
    void  choose_points(Model &model, Log &log) const;
    void  add_contacts(const GearPair &pair, Log &log, Model &model) const;
    void  add_housing(Model &model) const;
    void  add_drive(Model &model) const;
    void  add_load(Model &model) const;
    void  add_probes(Model &model) const;

    GearPairOptions       pair_;
    std::array<Member, 2> members_; ///< by body
    std::string           housing_; ///< file of its stiffness; empty: rigid
    MaterialSections      materials_;
    ContactOptions        contact_;
    unsigned int          reference_degree_ = 2; ///< Contact/penalty elements
  };
} // namespace vfife

#endif
