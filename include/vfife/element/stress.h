// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_stress_h
#define vfife_element_stress_h

#include <vfife/element/frame.h>
#include <vfife/element/stiffness.h>

namespace vfife
{
  /** Components xx yy zz xy yz zx [MPa]. */
  using Stress = Eigen::Matrix<double, 6, 1>;

  /** u = R^T (x - x_0) - (X - X_0) [mm], R of compute_frame(): what deforms the element. */
  Vector24
  compute_local_displacements(const HexahedronNodes &X, const HexahedronNodes &x, FrameKind frame);

  /**
   * Nodal stresses of an element, and of all its turned copies. What its undeformed shape and its
   * material tell is found once, so that a state costs a product of a matrix and a vector.
   */
  class StressRecovery
  {
  public:
    /** Of the reference configuration @p X. Throws as compute_element_strains(). */
    StressRecovery(const HexahedronNodes &X,
                   const Material        &material,
                   StiffnessKind          kind,
                   FrameKind              frame);

    /**
     * Stresses at the 8 nodes, now at @p x [MPa], one column a node, in the axes of the reference
     * configuration (turned with the element). Evaluated at the 2x2x2 points with the bubbles of
     * the kind recovered, then extrapolated trilinearly; exact at the nodes of rectangular elements
     * in pure bending.
     */
    Eigen::Matrix<double, 6, 8> compute(const HexahedronNodes &x) const;

  private:
    ElementFrame                  frame_;
    HexahedronNodes               from_first_;       ///< X - X_0 [mm]
    Eigen::Matrix<double, 48, 24> of_displacements_; ///< rows 6 node + component [MPa/mm]
  };

  /** StressRecovery of an element that is looked at once. */
  Eigen::Matrix<double, 6, 8> compute_nodal_stresses(const HexahedronNodes &X,
                                                     const HexahedronNodes &x,
                                                     const Material        &material,
                                                     StiffnessKind          kind,
                                                     FrameKind              frame);

  /** The stress in the axes that are the columns of @p axes. */
  Stress turn_stress(const Stress &stress, const Matrix3 &axes);

  /** Principal stresses, the largest first [MPa]. */
  Vector3 compute_principal_stresses(const Stress &stress);

  /** Von Mises' equivalent stress [MPa]. */
  double von_mises(const Stress &stress);
} // namespace vfife

#endif
