// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_half_space_bonded_layer_h
#define vfife_contact_half_space_bonded_layer_h

#include <vfife/base/types.h>

#include <vector>

namespace vfife
{
  /**
   * The integral of 1/r over a rectangle with the @p sides [mm], r the distance to a point in its
   * plane that lies @p from_middle [mm]. A uniform pressure p on the rectangle moves the surface of
   * a half-space there by (1 - nu^2)/(pi E) p times it, into the body (Love 1929; Johnson 1985, Eq.
   * (3.25)). [mm]
   */
  double integrate_inverse_distance(const Vector2 &from_middle, const Vector2 &sides);

  /**
   * A layer of the thickness d whose other side is held. A force F normal to its surface moves the
   * surface at the distance r by (1 - nu^2)/(pi E) F (1/r + correction(r, d)); the first part alone
   * is that of a half-space (doc/theory/pressure-grid.md).
   */
  class BondedLayer
  {
  public:
    /** Tabulates the correction. */
    explicit BondedLayer(double poissons_ratio);

    /** [1/mm], for @p distance >= 0 and @p depth > 0 [mm]. */
    double correction(double distance, double depth) const;

  private:
    std::vector<double> values_; ///< times the depth, at equal steps of the distance over the depth
  };
} // namespace vfife

#endif
