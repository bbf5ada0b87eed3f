// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/element/stress.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace vfife
{
  Vector24 compute_local_displacements(const HexahedronNodes &X,
                                       const HexahedronNodes &x,
                                       const FrameKind        frame)
  {
    const Matrix3         R = compute_frame(frame, X, x);
    const HexahedronNodes u =
      R.transpose() * (x.colwise() - x.col(0).eval()) - (X.colwise() - X.col(0).eval());
    return Eigen::Map<const Vector24>(u.data());
  }

  StressRecovery::StressRecovery(const HexahedronNodes &X,
                                 const Material        &material,
                                 const StiffnessKind    kind,
                                 const FrameKind        frame)
    : frame_(frame, X)
    , from_first_(X.colwise() - X.col(0).eval())
  {
    // The strain at a point is that of the nodes and of the bubbles which they leave without force.
    const Eigen::Matrix<double, 6, 6>  D       = compute_elasticity(material);
    const ElementStrains               strains = compute_element_strains(X, kind);
    const Eigen::Matrix<double, 9, 24> bubbles = compute_bubble_recovery(strains, material);

    // The points are the corners of a cube shrunk by sqrt(3).
    of_displacements_.setZero();
    for (unsigned int q = 0; q < 8; ++q)
      {
        const Eigen::Matrix<double, 6, 24> at_point =
          D * (strains.displacement[q] + strains.bubble[q] * bubbles);
        for (unsigned int a = 0; a < 8; ++a)
          of_displacements_.middleRows<6>(6 * a) +=
            shape_functions(std::sqrt(3.) * reference_corner(a))[q] * at_point;
      }
  }

  Eigen::Matrix<double, 6, 8> StressRecovery::compute(const HexahedronNodes &x) const
  {
    // As compute_local_displacements().
    const HexahedronNodes u =
      frame_.compute(x).transpose() * (x.colwise() - x.col(0).eval()) - from_first_;
    Eigen::Matrix<double, 6, 8> stresses;
    Eigen::Map<Eigen::Matrix<double, 48, 1>>(stresses.data()).noalias() =
      of_displacements_ * Eigen::Map<const Vector24>(u.data());
    return stresses;
  }

  Eigen::Matrix<double, 6, 8> compute_nodal_stresses(const HexahedronNodes &X,
                                                     const HexahedronNodes &x,
                                                     const Material        &material,
                                                     const StiffnessKind    kind,
                                                     const FrameKind        frame)
  {
    return StressRecovery(X, material, kind, frame).compute(x);
  }

  Stress turn_stress(const Stress &s, const Matrix3 &axes)
  {
    // sigma' = A^T sigma A, A with the new axes as columns.
    Matrix3 tensor;
    tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    const Matrix3 t = axes.transpose() * tensor * axes;
    Stress        turned;
    turned << t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(2, 0);
    return turned;
  }

  Vector3 compute_principal_stresses(const Stress &stress)
  {
    Matrix3 tensor;
    tensor << stress[0], stress[3], stress[5], stress[3], stress[1], stress[4], stress[5],
      stress[4], stress[2];
    return Eigen::SelfAdjointEigenSolver<Matrix3>(tensor, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .reverse();
  }

  double von_mises(const Stress &stress)
  {
    // s^2 = 1/2 ((xx - yy)^2 + (yy - zz)^2 + (zz - xx)^2) + 3 (xy^2 + yz^2 + zx^2).
    const Vector3 difference(stress[0] - stress[1], stress[1] - stress[2], stress[2] - stress[0]);
    return std::sqrt(0.5 * difference.squaredNorm() + 3. * stress.tail<3>().squaredNorm());
  }
} // namespace vfife
