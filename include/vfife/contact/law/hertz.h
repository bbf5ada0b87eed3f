// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_law_hertz_h
#define vfife_contact_law_hertz_h

#include <vfife/base/types.h>

namespace vfife
{
  /**
   * Hertz's frictionless contact of two elastic bodies whose gap is A x^2/2 + B y^2/2, A <= B the
   * relative curvatures [1/mm] (Johnson 1985, section 4.2). The contact is an ellipse with the
   * semi-axis a >= b along x; its form depends on A/B only and is solved for once.
   */
  class HertzContact
  {
  public:
    /** Contact that carries nothing, of no size. */
    HertzContact() = default;

    /**
     * @p relative_curvatures: smaller and larger one, both positive [1/mm]; @p modulus E* of
     * contact_modulus() [MPa]. Throws InputError for values that are not positive.
     */
    HertzContact(const Vector2 &relative_curvatures, double modulus);

    /** Larger and smaller semi-axis under a force [N]; [mm]. */
    Vector2 semi_axes(double force) const;

    /** In the middle of the ellipse [MPa]; the mean is two thirds of it. */
    double largest_pressure(double force) const;

    /** How far distant points of the bodies approach each other [mm]. */
    double approach(double force) const;

  private:
    double axis_ratio_ = 1.; ///< b/a
    double major_      = 0.; ///< a = major_ F^(1/3)
    double approach_   = 0.; ///< approach = approach_ F^(2/3)
  };

  /** E*: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [MPa]. */
  double contact_modulus(double youngs_modulus_1,
                         double poissons_ratio_1,
                         double youngs_modulus_2,
                         double poissons_ratio_2);
} // namespace vfife

#endif
