// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_stress_surface_stress_h
#define vfife_stress_surface_stress_h

#include <vfife/base/types.h>
#include <vfife/element/material.h>

namespace vfife
{
  /** Corners of a facet of a body's surface, a column a corner, counter-clockwise seen from
   * outside [mm]. */
  using FacetCorners = Eigen::Matrix<double, 3, 4>;

  /** Symmetric tensor in a surface's tangent plane: components 11, 22, 12 (no doubled shear). */
  using SurfaceTensor = Vector3;

  /**
   * Mean strain of a bilinear facet of a free surface: that of the displacements of its corners,
   * which are the elements' own on the surface, at the facet's centre. There the derivatives of
   * bilinear displacements are as accurate as those of biquadratic ones, and along a side they are
   * what the length between the corners has changed by, whatever happens between them
   * (doc/theory/stress.md).
   */
  class FacetStrain
  {
  public:
    /** Of the undeformed facet. */
    explicit FacetStrain(const FacetCorners &X);

    /** Directions 1 (along the facet's first side) and 2 (across) in its plane, unit columns. */
    const Eigen::Matrix<double, 3, 2> &axes() const
    {
      return axes_;
    }

    /** Linear strain of small displacements [mm]. */
    SurfaceTensor of_displacements(const FacetCorners &u) const;

    /** Stretch U - 1 of the present places @p x [mm], however much the facet has turned. */
    SurfaceTensor of_places(const FacetCorners &x) const;

  private:
    /** Derivatives of a field at the centre along the directions 1 and 2. */
    Eigen::Matrix<double, 3, 2> gradient(const FacetCorners &values) const;

    Eigen::Matrix<double, 3, 2> axes_;
    Eigen::Matrix2d             to_axes_; ///< from derivatives along xi, eta
  };

  /** Stress in the tangent plane [MPa] of a strain there, where nothing presses on the surface:
   * plane stress. */
  SurfaceTensor compute_surface_stress(const SurfaceTensor &strain, const Material &material);

  /** Principal stresses of a free surface [MPa], the third direction being free of stress. */
  struct PrincipalStresses
  {
    double first = 0; ///< largest tension, not below zero
    double third = 0; ///< largest compression, not above zero
    double angle = 0; ///< of the in-plane stress of the larger amount, from direction 1, (-pi/2,
                      ///< pi/2] [rad]
  };

  PrincipalStresses compute_principal_stresses(const SurfaceTensor &stress);
} // namespace vfife

#endif
