// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_pair_pair_model_builder_h
#define vfife_study_cases_pair_pair_model_builder_h

#include <vfife/model/model.h>
#include <vfife/study/cases/body_figures.h>
#include <vfife/study/cases/pair/pair_options.h>
#include <vfife/study/cases/pair_case.h>

#include <array>
#include <vector>

namespace vfife
{
  /** The gears of a pair of any kind, mounted so that the flanks that carry the load touch in the
   * mean contact at time zero. Forward the pinion turns about + its axis, the gear about -. */
  struct MountedGears
  {
    PairTeeth                  teeth;
    std::array<RigidMotion, 2> placements; ///< body frame to fixed frame

    // The mean contact of the unloaded flanks, in the fixed frame.
    Vector3               contact_point  = Vector3::Zero(); ///< [mm]
    Vector3               contact_normal = Vector3::Zero(); ///< out of the gear, into the pinion
    std::array<double, 2> arms           = {{0, 0}}; ///< |(P x n) . axis| of each member [mm]
    unsigned int          gear_tooth     = 0;        ///< that touches there

    /** Which flanks of pinion and gear touch on the drive side; on the coast side the others do. */
    std::array<FlankSide, 2> drive_flanks = {{FlankSide::concave, FlankSide::concave}};
  };

  /** Puts the model of a pair of gears of any kind together. Options and case must outlive it. */
  class PairModelBuilder
  {
  public:
    /** @p pair_case: the operation of the pair and its contact; bodies and meshes are those of @p
     * options. */
    PairModelBuilder(const PairOptions &options, MountedGears gears, const PairCase &pair_case);

    /** Meshes the bodies; logs what a user wants to know about them. */
    Model make(Log &log) const;

    Transmission             make_transmission() const;
    std::vector<BodyFigures> measure_bodies(const Model &model) const;

  private:
    /** Node set by which a body (0 pinion, 1 gear) is driven or held, or sits on its shaft. */
    const char *held_set(unsigned int body) const;
    Body        make_body(unsigned int body) const;
    /** The name among the surfaces of a body of the flank that touches on this side. */
    const char *surface_of(unsigned int body, MeshSide side) const;
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
    /** Gear speed over pinion speed, z1/z2. */
    double speed_ratio() const;
    /** Sense of the pinion's rotation about its axis. */
    double pinion_sense() const;

    const PairOptions      &options_;
    const MountedGears      gears_;
    const PairCase         &case_;
    const OperationOptions &operation_;
    MeshSide                side_; ///< whose flanks carry the load
  };
} // namespace vfife

#endif
