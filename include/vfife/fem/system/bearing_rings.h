// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_bearing_rings_h
#define vfife_fem_system_bearing_rings_h

#include <vfife/bearing/shaft_seat.h>
#include <vfife/fem/system/discretization.h>

#include <vector>

namespace vfife
{
  /** Motions B u of some points of a discretization, and forces B^T f on them. */
  struct PointMotion
  {
    std::vector<unsigned int> points;
    Eigen::MatrixXd           motion; ///< B, 3 columns a point

    /** B u of a field of all points. */
    Eigen::VectorXd displacement(const std::vector<double> &u) const;
    /** Adds B^T @p load to forces at all points. */
    void add_forces(const Eigen::VectorXd &load, std::vector<double> &forces) const;
  };

  /**
   * The seat of a bearing or coupling for small displacements: B u are the displacement and the
   * turn of the ring's centre along the fixed frame's axes (6 rows), B^T K B is its stiffness,
   * -B^T f what it exerts on the points of an undisplaced ring.
   */
  struct BearingRing : public PointMotion
  {
    std::size_t  support = 0;               ///< place in list_supports()
    unsigned int body    = 0;               ///< of the model
    Vector3      centre  = Vector3::Zero(); ///< undeformed, fixed frame [mm]
    /** In axes that stand still, and its mean over all turns [N/mm, N, N mm]. */
    Eigen::Matrix<double, 6, 6> stiffness, mean_stiffness;
    Eigen::Matrix<double, 6, 1> preload = Eigen::Matrix<double, 6, 1>::Zero(); ///< on the shaft

    /** In axes that turn at @p rate [rad/s]. */
    const Eigen::Matrix<double, 6, 6> &stiffness_at(const double rate) const
    {
      return rate != 0 ? mean_stiffness : stiffness;
    }
  };

  /**
   * Rings of all bearings and couplings of the bodies of a discretization. Bearings are linearized.
   * Throws
   * InputError on one sector of a body.
   */
  std::vector<BearingRing> find_bearing_rings(const Discretization &discretization);
} // namespace vfife

#endif
