// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_options_constraint_options_h
#define vfife_model_options_constraint_options_h

#include <vfife/model/model.h>
#include <vfife/model/node_selection.h>
#include <vfife/model/options/bearing_options.h>

namespace vfife
{
  /** What a user may ask a constraint to do. */
  enum class SupportKind
  {
    fixed,
    displacement,  ///< prescribed in some directions
    turning,       ///< turns with the body's speed about its axis
    angle,         ///< turns by a prescribed angle about the body's axis
    free_rotation, ///< radius and axial position held, nodes free to turn
    rigid_hub,     ///< the same, turning as one
    spring,        ///< springs to the ground
    bearing,       ///< holds the mean motion of a ring elastically
    rolling_bearing,
    coupling ///< drives the mean turn of a ring at the body's speed
  };

  /** Section Constraint NAME. */
  struct ConstraintOptions
  {
    SupportKind              kind = SupportKind::fixed;
    NodeSelection            selection;
    std::vector<std::string> directions;                     ///< of x, y, z or of r, theta, z
    Vector3                  displacement = Vector3::Zero(); ///< along them [mm]
    double                   angle        = 0;               ///< about the axis [rad]
    Vector3                  stiffness    = Vector3::Zero(); ///< of springs [N/mm]
    ParameterHistory         history;
    AnyBearingOptions        bearing;
    CouplingOptions          coupling;

    void declare_kind(dealii::ParameterHandler &prm);
    /** Declares the entries of the kind. Bound by address. */
    void declare(dealii::ParameterHandler &prm);
    void check(const std::string &section) const;
    /** Adds the constraint (or spring, bearing, coupling) to the model. */
    void add_to(Model &model, const std::string &name, const std::string &section) const;

  private:
    bool is_bearing() const;
    void add_seat(Model                    &model,
                  const std::string        &name,
                  unsigned int              body,
                  std::vector<unsigned int> nodes,
                  const std::string        &section) const;
  };
} // namespace vfife

#endif
