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
