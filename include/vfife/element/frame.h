// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_frame_h
#define vfife_element_frame_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/element/frame_kind.h>
#include <vfife/element/hexahedron.h>

namespace vfife
{
  /** "polar", "three nodes". */
  const Choices<FrameKind> &frame_choices();

  /** The rotation R of F = R U (U symmetric positive definite), by singular value decomposition. */
  Matrix3 compute_polar_rotation(const Matrix3 &F);

  /**
   * Axes (columns) e1 along b - a, e3 normal to the plane of a, b, d, e2 = e3 x e1, of the nodes
   * a = 0, b = 1 (next along xi), d = 2 (next along eta).
   */
  Matrix3 compute_triad(const HexahedronNodes &nodes);

  /**
   * The rotation R that carries the reference nodes @p X nearest to the current ones @p x, so that
   * u = R^T (x - x_0) - (X - X_0) is free of rigid motion.
   *
   * polar: R of the mean deformation gradient. Does not depend on the numbering of the nodes.
   *
   * three_nodes: the fictitious reverse motion of the VFIFE papers. Their steps "point a
   * coincides, side a-b coincides, face a-b-d coincides" are two successive plane rotations;
   * their product equals triad(x) triad(X)^T. Depends on which node is a.
   *
   * Throws NumericalError where the frame does not exist (singular F or collinear a, b, d).
   */
  Matrix3 compute_frame(FrameKind kind, const HexahedronNodes &X, const HexahedronNodes &x);

  /** compute_frame() of one undeformed element in many states. */
  class ElementFrame
  {
  public:
    ElementFrame(FrameKind kind, const HexahedronNodes &X);

    Matrix3 compute(const HexahedronNodes &x) const;

  private:
    FrameKind       kind_;
    HexahedronNodes mean_gradients_; ///< polar
    Matrix3         triad_;          ///< three nodes: of the undeformed element
  };
} // namespace vfife

#endif
