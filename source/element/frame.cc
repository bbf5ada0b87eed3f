// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/element/frame.h>

#include <Eigen/SVD>

namespace vfife
{
  const Choices<FrameKind> &frame_choices()
  {
    static const Choices<FrameKind> choices = {{"polar", FrameKind::polar},
                                               {"three nodes", FrameKind::three_nodes}};
    return choices;
  }

  namespace
  {
    /** @p mean_gradients: of the undeformed element. */
    Matrix3 deformation_gradient_of(const HexahedronNodes &mean_gradients, const HexahedronNodes &x)
    {
      // Relative to one node: the columns of the gradients sum to zero only up to round-off.
      return (x.colwise() - x.col(0).eval()) * mean_gradients.transpose();
    }
  } // namespace

  Matrix3 compute_polar_rotation(const Matrix3 &F)
  {
    // F = W S V^T = (W V^T)(V S V^T): the first factor is the rotation, the second the stretch U.
    // If F mirrors, so does W V^T: refused, like a collapsed element, where R is not unique.
    const Eigen::JacobiSVD<Matrix3> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Matrix3                   R = svd.matrixU() * svd.matrixV().transpose();
    if (!(svd.singularValues()[2] > 0.) || !(R.determinant() > 0.))
      throw NumericalError("An element is inverted: its mean deformation gradient has "
                           "no polar rotation.");
    return R;
  }

  Matrix3 compute_triad(const HexahedronNodes &nodes)
  {
    const Vector3 side   = nodes.col(1) - nodes.col(0);
    const Vector3 normal = side.cross(nodes.col(2) - nodes.col(0));
    if (!(side.norm() > 0.) || !(normal.norm() > 0.))
      throw NumericalError("The first three nodes of an element lie on one line, so that its "
                           "three-node frame is undefined.");
    //     d
    //     |        e1 along a-b, e3 normal to the plane a-b-d, e2 in it:
    //     a----b   whatever the angle at a is.
    Matrix3 triad;
    triad.col(0) = side.normalized();
    triad.col(2) = normal.normalized();
    triad.col(1) = triad.col(2).cross(triad.col(0));
    return triad;
  }

  ElementFrame::ElementFrame(const FrameKind kind, const HexahedronNodes &X)
    : kind_(kind)
  {
    if (kind == FrameKind::polar)
      mean_gradients_ = compute_mean_gradients(X);
    else
      triad_ = compute_triad(X);
  }

  Matrix3 ElementFrame::compute(const HexahedronNodes &x) const
  {
    // Three nodes: triad(X)^T takes the reference axes to x y z, triad(x)
    // takes those to the present axes.
    return kind_ == FrameKind::polar
             ? compute_polar_rotation(deformation_gradient_of(mean_gradients_, x))
             : Matrix3(compute_triad(x) * triad_.transpose());
  }

  Matrix3 compute_frame(const FrameKind kind, const HexahedronNodes &X, const HexahedronNodes &x)
  {
    return ElementFrame(kind, X).compute(x);
  }
} // namespace vfife
