// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_gear_gear_case_h
#define vfife_study_cases_gear_gear_case_h

#include <vfife/gear/spiral_bevel/gear_pair.h>
#include <vfife/gear/spiral_bevel/gear_pair_options.h>
#include <vfife/study/cases/pair/pair_model_builder.h>
#include <vfife/study/cases/pair/pair_options.h>
#include <vfife/study/cases/torque_pressure.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  /** The sections Gear pair, Material ... and Contact of a spiral bevel pair. */
  struct GearCaseOptions : PairOptions
  {
    GearPairOptions pair;

    GearCaseOptions();

    /** The sections Gear pair and Material ... Bound by address. */
    void declare_bodies(dealii::ParameterHandler &prm, const ParameterFile &file);

    /** Throws InputError where pair, bodies, shafts and materials contradict themselves or each
     * other. */
    void check_bodies() const;

    /** The same pair on the coarse mesh of PairCase::make_reference_model(). */
    GearCaseOptions for_reference() const;
    /** The same pair on the mesh of PairCase::make_submodel_mesh(). */
    GearCaseOptions for_submodels(unsigned int cells_lengthwise) const;
  };

  /** A spiral bevel gear pair from the sections Gear pair, Material ..., Operation and Contact. */
  class GearCase : public PairCase
  {
  public:
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
      return options_.contact.penalty.is_open();
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
      return options_.reference_degree;
    }
    std::optional<Model>     make_submodel_mesh(unsigned int cells_lengthwise) const override;
    std::vector<BodyFigures> measure_bodies(const Model &model) const override;
    Table                    meridian_table() const override;
    Table
    flank_points(unsigned int member, unsigned int lengthwise, unsigned int profile) const override;

    PairFacts facts(bool with_path) const override;

    /** The pair with everything derived. */
    GearPair make_pair() const;

    /** Strain of a free ring at the pitch circles at the largest speed of a run, rho v^2 / E; the
     * larger of both members. */
    double ring_strain() const;

    /** The flanks that carry the load. */
    MeshSide working_side() const;

  private:
    /** Throws InputError for a load, speeds and contact that do not go together. */
    void         check_operation() const;
    HertzContact hertz_contact_of(const GearPair &pair) const;
    /** Hertz's contact of one tooth pair under all the torque; nothing without a torque. */
    std::optional<TorquePressure> torque_pressure(const GearPair &pair) const;
    /** Of the model; @p options must outlive it. @p pair: made of them. */
    PairModelBuilder builder(const GearCaseOptions &options, const GearPair &pair) const;
    /** A model of other options, whose log nobody reads. */
    Model make_silently(const GearCaseOptions &options) const;

    GearCaseOptions options_;
  };
} // namespace vfife

#endif
