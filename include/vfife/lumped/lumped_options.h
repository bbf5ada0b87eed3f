// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_lumped_lumped_options_h
#define vfife_lumped_lumped_options_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/types.h>
#include <vfife/lumped/lumped_model.h>

#include <string>
#include <vector>

namespace vfife
{
  class ParameterFile;

  enum class SupportMember
  {
    pinion,
    gear
  };

  /** Section Support NAME: a translation or a tilt of a member on a spring. */
  struct SupportOptions
  {
    std::string   name;
    SupportMember member         = SupportMember::gear;
    bool          tilts          = false;
    Vector3       direction      = Vector3::Zero(); ///< of the motion, or axis of the tilt
    Vector3       centre         = Vector3::Zero(); ///< a point on the axis of the tilt [mm]
    double        mass           = 0;               ///< [t]
    double        inertia        = 0;               ///< about the axis of the tilt [t mm^2]
    double        stiffness      = 0;               ///< [N/mm]
    double        tilt_stiffness = 0;               ///< [N mm/rad]
    double        damping_ratio  = 0.02;

    void declare(dealii::ParameterHandler &prm);
    void check(const std::string &section) const;
  };

  /** Where stiffness and transmission error over the mesh cycle come from. */
  enum class MeshSource
  {
    series,
    loaded_contact
  };

  /** Section Lumped. Zeros are taken from the gear pair, where the file has one. */
  struct LumpedOptions
  {
    MeshSource               source = MeshSource::series;
    std::string              table;
    LoadLaw                  load_law  = LoadLaw::power;
    double                   stiffness = 0;                      ///< mean [N mm/rad]
    std::vector<std::string> stiffness_cosines, stiffness_sines; ///< over the mean
    std::vector<std::string> error_cosines, error_sines;         ///< with units
    double                   backlash = -1; ///< normal to the flanks [mm]; negative: from the pair

    bool   driver_is_free          = false;
    double damping_ratio           = 0.03;
    bool   damping_without_contact = false;
    double speed_damping           = 0; ///< [1/s]

    unsigned int             driver_teeth = 0, driven_teeth = 0;
    double                   driver_inertia = 0, driven_inertia = 0; ///< [t mm^2]
    double                   arm            = 0;                     ///< [mm]
    Vector3                  contact_normal = Vector3::Zero(); ///< out of the gear, into the pinion
    Vector3                  contact_point  = Vector3::Zero(); ///< [mm]
    std::vector<std::string> support_names;
    std::vector<SupportOptions> supports;
    bool in_bearings = false; ///< members on shafts move on their bearings, beside the supports

    /** Declares section Lumped; the names of supports are read from @p file. */
    void declare(dealii::ParameterHandler &prm, const ParameterFile &file);
    /** What does not depend on where the pair comes from. */
    void check() const;
    /** With everything known; throws InputError where something is missing. */
    LumpedPair make_pair(double torque) const;

  private:
    void declare_mesh(dealii::ParameterHandler &prm);
    void declare_pair(dealii::ParameterHandler &prm);
  };
} // namespace vfife

#endif
