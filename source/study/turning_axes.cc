// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/fem/system/bearing_rings.h>
#include <vfife/model/model.h>
#include <vfife/study/turning_axes.h>

#include <Eigen/Eigenvalues>

namespace vfife
{
  namespace
  {
    /** Whether a load on a body with this axis is the same at all its turns. */
    bool stands_along_axis(const Load &load, const Vector3 &axis)
    {
      return load.kind == LoadKind::pressure ||
             load.vector.cross(axis).norm() <= 1e-9 * load.vector.norm();
    }

    /** Of one seat: stiffness against shifts or against tilts across the axis. */
    struct Across
    {
      Eigen::Vector2d principal; ///< ascending
      double          mean;
    };

    Across compare_across(const Matrix3 &stiffness, const Matrix3 &axes)
    {
      const Eigen::Matrix2d plane = (axes.transpose() * stiffness * axes).topLeftCorner<2, 2>();
      const Eigen::Vector2d principal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(plane).eigenvalues();
      return {principal, principal.mean()};
    }

    bool differs(const Eigen::MatrixXd &K, const Eigen::MatrixXd &mean)
    {
      return (K - mean).norm() > 1e-6 * K.norm();
    }
  } // namespace

  void refuse_standing_springs(const Model &model, const unsigned int body)
  {
    for (const Load &load : model.loads)
      if (load.kind == LoadKind::spring && load.body == body)
        throw InputError("Model/constraints",
                         "the spring \"" + load.name + "\" is stationary, but its body \"" +
                           model.bodies[body].name() +
                           "\" rotates, so that the rotating frame has no state of rest. Use a "
                           "bearing, or kind = run");
  }

  void refuse_standing_loads(const Model                     &model,
                             const std::vector<unsigned int> &bodies,
                             const std::string               &remedy)
  {
    for (const unsigned int b : bodies)
      {
        const Body &body = model.bodies[b];
        if (body.rate == 0)
          continue;
        refuse_standing_springs(model, b);
        for (const Load &load : model.loads)
          if (load.body == b && !stands_along_axis(load, body.axis.direction))
            throw InputError("Model/loads",
                             "expected loads along the axis of the rotating body \"" + body.name() +
                               "\", got \"" + load.name +
                               "\" across the axis, which is stationary in the fixed frame. " +
                               remedy);
      }
  }

  void warn_of_averaged_bearings(const Model &model, const unsigned int body, Log &log)
  {
    const FemSpace        d(model, {body}, FemElement::incompatible_modes);
    const BearingRings    rings(d);
    const Eigen::MatrixXd K       = rings.stiffness([](unsigned int) { return 0.; }),
                          mean    = rings.mean_over_turns(K, [](unsigned int) { return 1.; });
    const std::string consequence = "; in the rotating frame of the body \"" +
                                    model.bodies[body].name() +
                                    "\" the program uses the mean over its rotation, that is, "
                                    "isotropic bearings. A run uses the given bearings";
    bool         is_told = false;
    unsigned int ring    = 0;
    for (const Bearing &bearing : model.bearings)
      {
        if (bearing.body != body)
          continue;
        for (const unsigned int block : {0u, 3u})
          {
            const unsigned int at = 6 * ring + block;
            if (!differs(K.block<3, 3>(at, at), mean.block<3, 3>(at, at)))
              continue;
            const Across across = compare_across(K.block<3, 3>(at, at), bearing.axes);
            const char  *unit   = block == 0 ? " N/mm" : " N mm/rad";
            log.warning("bearing \"",
                        bearing.name,
                        "\" has the stiffnesses ",
                        across.principal[0],
                        " and ",
                        across.principal[1],
                        unit,
                        block == 0 ? " across its axis" : " against tilts",
                        consequence,
                        " (mean ",
                        across.mean,
                        unit,
                        ")");
            is_told = true;
          }
        ++ring;
      }
    if (!is_told && K.size() > 0 && differs(K, mean))
      log.warning(
        "the stiffness that couples displacements, tilts and seats of its bearings differs along "
        "x and y",
        consequence);
  }

  bool warn_of_dampers(const Model &model, const unsigned int body, Log &log)
  {
    std::vector<std::string> names;
    for (const Bearing &bearing : model.bearings)
      if (bearing.body == body && !bearing.law->damping().isZero(0.))
        names.push_back(bearing.name);
    for (const Coupling &coupling : model.couplings)
      if (coupling.body == body && coupling.damping != 0)
        names.push_back(coupling.name);
    if (names.empty())
      return false;
    log.warning("dampers of ",
                list_of(names),
                " are left out: natural vibrations of the body \"",
                model.bodies[body].name(),
                "\" are undamped, and modes.csv has no damping ratios. A run has the dampers");
    return true;
  }
} // namespace vfife
