// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_gear_gear_model_builder_h
#define vfife_study_cases_gear_gear_model_builder_h

#include <vfife/gear/spiral_bevel/gear_pair.h>
#include <vfife/model/model.h>
#include <vfife/study/cases/body_figures.h>
#include <vfife/study/cases/gear/gear_case_options.h>
#include <vfife/study/cases/pair_case.h>

#include <vector>

namespace vfife
{
  /** Puts the model of a spiral bevel pair together. Options and case must outlive it. */
  class GearModelBuilder
  {
  public:
    /** @p pair_case: the operation of the pair and its contact; bodies and meshes are those of @p
     * options. @p pair: made of them. */
    GearModelBuilder(const GearCaseOptions &options, const PairCase &pair_case, GearPair pair);
    GearModelBuilder(const GearCaseOptions &options, const PairCase &pair_case)
      : GearModelBuilder(options, pair_case, GearPair(options.pair))
    {
    }

    /** Meshes the bodies; logs what a user wants to know about them. */
    Model make(Log &log) const;

    Transmission             make_transmission() const;
    std::vector<BodyFigures> measure_bodies(const Model &model) const;

  private:
    /** Node set by which a body (0 pinion, 1 gear) is driven or held, or sits on its shaft. */
    const char *held_set(unsigned int body) const;
    Body        make_body(unsigned int body) const;
    /** The penalty with which the contact's own grid is found where the section Contact gives none
     * [N/mm^3]. */
    double guess_penalty() const;
    void   choose_points(Model &model, Log &log) const;
    void   add_contacts(Model &model, Log &log) const;
    void   add_housing(Model &model) const;
    void   add_drive(Model &model) const;
    void   add_load(Model &model) const;
    void   add_probes(Model &model) const;
    /** Gear tooth (sector) at the pitch point after @p meshes mesh cycles. */
    unsigned int gear_tooth_in_mesh(unsigned int meshes) const;

    const GearCaseOptions  &options_;
    const PairCase         &case_;
    const OperationOptions &operation_;
    GearPair                pair_;
    MeshSide                side_; ///< whose flanks carry the load
  };
} // namespace vfife

#endif
