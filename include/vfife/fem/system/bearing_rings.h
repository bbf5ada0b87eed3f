// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_bearing_rings_h
#define vfife_fem_system_bearing_rings_h

#include <vfife/bearing/shaft_seat.h>
#include <vfife/fem/system/discretization.h>

#include <vector>

namespace vfife
{
  /**
   * The seat of a bearing or coupling for small displacements: B u are the displacement and the
   * turn of the ring's centre along the fixed frame's axes, B^T K B is its stiffness, -B^T f what
   * it exerts on the points of an undisplaced ring.
   */
  struct BearingRing
  {
    std::size_t               support = 0; ///< place in list_supports()
    unsigned int              body    = 0; ///< of the model
    std::vector<unsigned int> points;
    Eigen::MatrixXd           motion; ///< B, 6 x 3 n
    /** In axes that stand still, and its mean over all turns [N/mm, N, N mm]. */
    Eigen::Matrix<double, 6, 6> stiffness, mean_stiffness;
    Eigen::Matrix<double, 6, 1> preload = Eigen::Matrix<double, 6, 1>::Zero(); ///< on the shaft

    /** In axes that turn at @p rate [rad/s]. */
    const Eigen::Matrix<double, 6, 6> &stiffness_at(const double rate) const
    {
      return rate != 0 ? mean_stiffness : stiffness;
    }
    /** B u of a field of all points. */
    Eigen::Matrix<double, 6, 1> displacement(const std::vector<double> &u) const;
    /** Adds B^T @p load to forces at all points. */
    void add_forces(const Eigen::Matrix<double, 6, 1> &load, std::vector<double> &forces) const;
  };

  /**
   * Rings of all bearings and couplings of the bodies of a discretization. Bearings are linearized.
   * Throws
   * InputError on one sector of a body.
   */
  std::vector<BearingRing> find_bearing_rings(const Discretization &discretization);
} // namespace vfife

#endif
