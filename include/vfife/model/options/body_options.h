// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_options_body_options_h
#define vfife_model_options_body_options_h

#include <vfife/mesh/primitives/primitive_options.h>
#include <vfife/mesh/primitives/stepped_shaft.h>
#include <vfife/model/body.h>
#include <vfife/model/options/body_materials.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  /** Section Body NAME: mesh, material, place and motion at time zero. */
  struct BodyOptions
  {
    std::string                       mesh = "block";
    BodyMaterials                     materials;
    std::unique_ptr<PrimitiveOptions> primitive; ///< sizes and cells of a mesh that is no file
    SteppedShaftOptions               shaft;     ///< of `mesh = stepped shaft`
    std::string                       file;      ///< of `mesh = file`, see read_body()
    std::vector<std::string>          regions;   ///< of that file; none: all

    Vector3 position       = Vector3::Zero(); ///< of the body frame's origin [mm]
    Vector3 rotation_axis  = Vector3::UnitZ();
    double  rotation_angle = 0; ///< of the body frame about that axis [rad]

    bool    bearing        = false;           ///< rigid motion is a rotation about the axis
    Vector3 axis_point     = Vector3::Zero(); ///< fixed frame [mm]
    Vector3 axis_direction = Vector3::UnitZ();
    double  speed          = 0; ///< about the axis [rad/s]

    Vector3 velocity         = Vector3::Zero(); ///< without a bearing [mm/s]
    Vector3 angular_velocity = Vector3::Zero(); ///< about the centre of mass [rad/s]
    /** Formulas of x, y, z [mm] of the undeformed body frame, added to that [mm/s]. */
    std::array<std::string, 3> initial_velocity = {{"0", "0", "0"}};

    /** Declares the entries that decide about others: mesh and materials. */
    void declare_kind(dealii::ParameterHandler &prm);

    /** Declares all entries; mesh must be known. Bound by address. */
    void declare(dealii::ParameterHandler &prm, const std::string &section);

    void check(const std::string &section) const;

    Body make(const std::string      &name,
              const MaterialSections &sections,
              const std::string      &section) const;

  private:
    void declare_shape(dealii::ParameterHandler &prm, const std::string &section);
    std::unique_ptr<BodyMesh> make_mesh(const std::string &section) const;
    std::unique_ptr<BodyMesh> read_file(const std::string &section) const;
  };
} // namespace vfife

#endif
