// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_gear_case_h
#define vfife_study_cases_gear_case_h

#include <vfife/base/text/table.h>
#include <vfife/contact/law/contact_options.h>
#include <vfife/contact/law/hertz.h>
#include <vfife/element/material.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/model/model.h>

#include <string>
#include <vector>

namespace vfife
{
  struct BodyFigures;
  class Log;
  class ParameterFile;

  /** How the hub of the driven member turns. */
  enum class HubKind
  {
    free_rotation,
    rigid_hub
  };

  /** Section Operation: what the pair is run at. */
  struct OperationOptions
  {
    double       speed  = 0;  ///< of the pinion [rad/s]
    double       torque = 0;  ///< on the driven member [N mm]
    unsigned int meshes = 40; ///< tooth meshes to run
    double       ramp   = 12; ///< of the torque, with Dynamics/start = ramp [tooth meshes]
    HubKind      hub    = HubKind::free_rotation;

    DrivingMember    driving   = DrivingMember::pinion;
    TurningDirection direction = TurningDirection::forward;

    void declare(dealii::ParameterHandler &prm);
    void check(const std::string &section) const;

    /** Throws InputError where the gear drives, which @p study (a noun) does not take. */
    void require_driving_pinion(const std::string &section, const std::string &study) const;

    /** Tooth meshes per second [Hz]. */
    double mesh_frequency(unsigned int pinion_teeth) const
    {
      return speed * pinion_teeth / (2 * pi);
    }
  };

  /** A spiral bevel gear pair from the sections Gear pair, Material ..., Operation and Contact. */
  class GearCase
  {
  public:
    GearCase();

    /** Declares all entries; the names of the materials are read from @p file first. */
    void declare(dealii::ParameterHandler &prm, const ParameterFile &file);
    void check() const;
    /** The part of check() that concerns pair, bodies and materials: enough for make_model(). */
    void check_bodies() const;

    /** The pair with everything derived. */
    GearPair make_pair() const;

    /** Derives the flanks, meshes both bodies and puts them together; logs what a user wants to
     * know about them. */
    Model make_model(bool torque_is_ramped, Log &log) const;

    /** Quality, mass and inertias of the bodies of make_model(), pinion first. */
    std::vector<BodyFigures> measure_bodies(const Model &model) const;

    /** Outlines of the bodies in the meridian plane: meridian.csv. */
    Table meridian_table() const;

    /** Step of central differences that divides a tooth mesh into a multiple of @p samples steps,
     * at most @p stable_step [s]. */
    double choose_step(double stable_step, unsigned int samples) const;

    const OperationOptions &operation() const;
    double                  mesh_frequency() const;

    /** Whether the gear's rim is carried by an elastic web. */
    bool has_web() const;

    /** Of one tooth pair at the mean contact of the unloaded flanks. */
    HertzContact hertz_contact() const;

    /** The flanks that carry the load. */
    MeshSide working_side() const;

    /** Gear tooth (sector) at the pitch point after @p meshes tooth meshes. */
    unsigned int gear_tooth_in_mesh(unsigned int meshes) const;

  private:
    const Material &material(const std::string &name) const;
    Transmission    make_transmission(const GearPair &pair) const;
    /** Node set by which a body (0 pinion, 1 gear) is driven or held. */
    const char *held_set(unsigned int body) const;
    void        add_contacts(const GearPair &pair, Model &model) const;
    void        add_hub(Model &model, bool torque_is_ramped) const;
    void        add_probes(Model &model) const;

    GearPairOptions       pair_;
    GearBodyOptions       pinion_body_, gear_body_;
    std::string           pinion_material_ = "steel", gear_material_ = "steel";
    std::vector<Material> materials_;
    OperationOptions      operation_;
    ContactOptions        contact_;
  };
} // namespace vfife

#endif
