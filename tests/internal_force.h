// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_internal_force_h
#define vfife_tests_internal_force_h

#include <vfife/element/frame.h>
#include <vfife/element/stress.h>

#include <Eigen/LU>

namespace vfife
{
  /**
   * Strain energy 1/2 u^T K u [mJ] with u of compute_local_displacements(). The reference for the
   * kernels: dense and exact where they are short and use series.
   */
  inline double compute_strain_energy(const Matrix24        &K,
                                      const HexahedronNodes &X,
                                      const HexahedronNodes &x,
                                      const FrameKind        frame)
  {
    const Vector24 u = compute_local_displacements(X, x, frame);
    return 0.5 * u.dot(K * u);
  }

  /**
   * Restoring forces on the nodes [N], one column a node, with the stiffness @p K of reference @p
   * X.
   *
   * three_nodes: -R K u, as published; forces sum to zero, moments only to O(strain^2).
   * polar: exactly minus the derivative of compute_strain_energy(), -R (K u - t x b), where
   * t = (tr U I - U)^-1 sum_a y_a x (K u)_a with y = R^T x, the part that comes from the turning of
   * the frame. Forces and moments sum to zero, and energy is conserved.
   */
  inline HexahedronNodes compute_internal_forces(const Matrix24        &K,
                                                 const HexahedronNodes &X,
                                                 const HexahedronNodes &x,
                                                 const FrameKind        frame)
  {
    const Vector24  Ku    = K * compute_local_displacements(X, x, frame);
    HexahedronNodes force = Eigen::Map<const HexahedronNodes>(Ku.data());
    const Matrix3   R     = compute_frame(frame, X, x);
    if (frame == FrameKind::polar)
      {
        // W = 1/2 u^T K u with u = R^T x - X changes by dW = (K u) . (R^T dx + d(R^T) x). With
        // R^T dR = [w], d(R^T) x = -w x y, which gives -w . M, M = sum_a y_a x (K u)_a. How far R
        // turns with the nodes follows from F = R U: (tr U I - U) w is the axial vector of R^T dF
        // less its transpose, dF = sum_a dx_a b_a^T, so that
        //     dW/dx_a = R (K u - t x b)_a,     (tr U I - U) t = M.
        const HexahedronNodes b      = compute_mean_gradients(X);
        const HexahedronNodes y      = R.transpose() * (x.colwise() - x.col(0).eval());
        const Matrix3         U      = y * b.transpose();
        Vector3               moment = Vector3::Zero();
        for (unsigned int a = 0; a < 8; ++a)
          moment += y.col(a).cross(force.col(a));
        const Vector3 t = (U.trace() * Matrix3::Identity() - U).inverse() * moment;
        for (unsigned int a = 0; a < 8; ++a)
          force.col(a) -= t.cross(b.col(a));
      }
    return -R * force;
  }
} // namespace vfife

#endif
