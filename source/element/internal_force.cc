// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/element/internal_force.h>
#include <vfife/element/stress.h>

#include <Eigen/LU>

namespace vfife
{
  double compute_strain_energy(const Matrix24        &K,
                               const HexahedronNodes &X,
                               const HexahedronNodes &x,
                               const FrameKind        frame)
  {
    const Vector24 u = compute_local_displacements(X, x, frame);
    return 0.5 * u.dot(K * u);
  }


  HexahedronNodes compute_internal_forces(const Matrix24        &K,
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
