// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_system_matrices_h
#define vfife_fem_system_system_matrices_h

#include <vfife/fem/system/fem_system.h>
#include <vfife/fem/system/finite_strain.h>

namespace vfife
{
  /**
   * The matrices of small motions u in axes that turn with the body at the rate Omega about its
   * axis (doc/theory/fem.md), on the unknowns of a system, about the state of spin u0:
   * M u'' + 2 Omega G u' + (K(u0) + C - Omega^2 S) u = f, K the tangent stiffness, C the hub's
   * curvature. All functions are collective; fields are displacements of all points, first copy.
   */
  class SystemMatrices
  {
  public:
    SystemMatrices(const FemSystem &system, MassKind mass, StrainMeasure strain);

    const FemSystem &system() const
    {
      return system_;
    }

    /** Angular velocity of a body of the model about its axis [rad/s]. */
    using Rate = BearingRings::Rate;

    /** Without stresses of spin, with the model's springs to the ground, bearings and couplings as
     * bodies feel them that turn at @p rate. */
    FemMatrix stiffness(const Rate &rate) const;
    FemMatrix mass() const;

    /** Omega^2 S with S = m_ab (1 - a a^T): the mass of motions across the axis. */
    FemMatrix spin_mass(const Rate &rate) const;
    /** Omega G with G = m_ab [a]x, skew. */
    FemMatrix gyroscopic(const Rate &rate) const;

    using PointMatrices = std::vector<std::pair<unsigned int, Matrix3>>;

    /**
     * What keeping the radius adds at the points of hubs that turn freely: -F/r t t^T, F the radial
     * force of the constraint in steady spin with the displacements @p u, r the radius, t the
     * tangent. Without it a spun body on such a hub would not turn freely.
     */
    PointMatrices hub_curvature(const std::vector<double> &u, const Rate &rate) const;
    /** K(u) - Omega^2 S + C of bodies that spin displaced by @p u. */
    FemMatrix spinning_stiffness(const std::vector<double> &u, const Rate &rate) const;

    /**
     * What acts on bodies that spin displaced by @p u and is not in balance: Omega^2 S (X + u) -
     * f(u) - C u, f their internal forces [N]. @p softening: whether the load acts on the displaced
     * mass, or as Omega^2 S X.
     */
    OwnedVector
    spinning_residual(const std::vector<double> &u, const Rate &rate, bool softening) const;

    /** Omega^2 S (X + u) of an element, 3 a point [N]. */
    Eigen::VectorXd
    centrifugal_force(unsigned int e, const Eigen::VectorXd &u, const Rate &rate) const;

    /** M r for a field r of all points: what a base motion r puts on the unknowns. */
    OwnedVector apply_mass(const std::vector<double> &field) const;
    /** M r at all points, 3 a point, without constraints. */
    std::vector<double> mass_forces(const std::vector<double> &field) const;

    /** Owned parts of the rigid motions of each body, for multigrid. */
    std::vector<OwnedVector> near_kernel() const;

  private:
    /** What does not come from the elements: springs to the ground, and hub_curvature(). */
    PointMatrices point_stiffnesses(const std::vector<double> &u, const Rate &rate) const;
    /** @p K and what bearings and couplings add to it. */
    FemMatrix       add_rings(FemMatrix K, const Rate &rate) const;
    Eigen::MatrixXd mass_coefficients(unsigned int e) const;
    /** M r of an element, 3 a point. */
    Eigen::VectorXd mass_forces_of(unsigned int e, const std::vector<double> &field) const;
    unsigned int    body(unsigned int e) const;
    const Axis     &axis(unsigned int e) const;

    const FemSystem &system_;
    MassKind         mass_;
    StrainMeasure    strain_;
  };

  /** The same rate [rad/s] for whatever body. */
  SystemMatrices::Rate constant_rate(double rate);
} // namespace vfife

#endif
