// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_options_bearing_options_h
#define vfife_model_options_bearing_options_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/bearing/rolling_bearing.h>
#include <vfife/model/load.h>

#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  struct Axis;
  struct Model;

  /** Damping and axes of any bearing. */
  struct SeatOptions
  {
    double  radial_damping  = 0;               ///< [N s/mm]
    double  axial_damping   = 0;               ///< [N s/mm]
    double  tilting_damping = 0;               ///< [N mm s/rad]
    Vector3 x_direction     = Vector3::Zero(); ///< fixed frame; zero: any across the axis

    void    declare(dealii::ParameterHandler &prm);
    Matrix5 damping() const;
    /** x, y and z of a bearing on @p axis. Throws InputError for an x direction along it. */
    Matrix3 make_axes(const Axis &axis, const std::string &section) const;
  };

  /** Entries of a bearing with a linear law: three numbers of each kind, or a matrix. */
  struct BearingOptions
  {
    SeatOptions seat;
    double      radial_stiffness  = 0; ///< [N/mm]
    double      axial_stiffness   = 0; ///< [N/mm]
    double      tilting_stiffness = 0; ///< [N mm/rad]
    /** 5 x 5 numbers over x, y, z [mm] and tilts about x, y [rad], in the place of the above. */
    std::string stiffness_matrix, damping_matrix;
    Vector3     preload = Vector3::Zero(); ///< on the shaft along x, y, z of the bearing [N]

    /** Declares the entries in the section entered. Bound by address. */
    void declare(dealii::ParameterHandler &prm);
    /** Throws InputError (entries under @p section). */
    void check(const std::string &section) const;

    std::shared_ptr<const BearingLaw> make_law(const std::string &section) const;
  };

  /** Entries of a bearing with rolling elements. */
  struct RollingBearingOptions
  {
    SeatOptions        seat;
    RollingBearingData data;

    void                              declare(dealii::ParameterHandler &prm);
    std::shared_ptr<const BearingLaw> make_law(const std::string &section) const;
  };

  /** Entries of a bearing of either kind. */
  struct AnyBearingOptions
  {
    BearingOptions        linear;
    RollingBearingOptions rolling;

    /** Those of the kind that it is. */
    void declare(bool rolls, dealii::ParameterHandler &prm);
    /** Throws InputError (entries under @p section). */
    void check(bool rolls, const std::string &section) const;

    /** Adds the bearing to a model, its body floating from then on; throws InputError as check(),
     * and for axes that are none. */
    void add_to(Model                    &model,
                bool                      rolls,
                const std::string        &name,
                unsigned int              body,
                std::vector<unsigned int> nodes,
                const std::string        &section) const;
  };

  /** Entries of a coupling that drives a shaft. */
  struct CouplingOptions
  {
    double stiffness = 1e9; ///< [N mm/rad]
    double damping   = 0;   ///< [N mm s/rad]

    void declare(dealii::ParameterHandler &prm);
  };
} // namespace vfife

#endif
