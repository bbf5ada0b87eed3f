// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "plain_elements.h"

#include <vfife/element/frame.h>

#include <Eigen/LU>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** Newton's iteration R <- (R + R^-T)/2 from F; its error is squared in each step: four leave
     * round-off for strains of a per cent. */
    Matrix3 iterate_rotation(const Matrix3 &F)
    {
      Matrix3 R = F;
      for (unsigned int i = 0; i < 4; ++i)
        R = 0.5 * (R + R.inverse().transpose().eval());
      return R;
    }
  } // namespace

  PlainElements::PlainElements(const Body         &body,
                               const StiffnessKind stiffness,
                               const unsigned int  n_elements)
  {
    for (unsigned int e = 0; e < std::min(n_elements, body.n_elements()); ++e)
      {
        const HexahedronNodes X = body.element_nodes(e);
        // The whole 24 x 24 stiffness of each element, as a textbook has it.
        elements_.push_back({compute_stiffness(X, body.material(e), stiffness),
                             X.colwise() - X.col(0).eval(),
                             compute_mean_gradients(X),
                             compute_triad(X),
                             body.elements()[e]});
      }
  }

  void PlainElements::add_internal_forces(const FrameKind frame,
                                          const double   *positions,
                                          double         *forces) const
  {
    for (const Element &element : elements_)
      {
        // f = -R K (R^T x - X), places relative to node 0: large coordinates would cost digits.
        HexahedronNodes x;
        for (unsigned int a = 0; a < 8; ++a)
          x.col(a) = Eigen::Map<const Vector3>(positions + 4 * std::size_t(element.nodes[a]));
        x.colwise() -= x.col(0).eval();
        const Matrix3                      R = frame == FrameKind::polar
                                                 ? iterate_rotation(x * element.gradients.transpose())
                                                 : Matrix3(compute_triad(x) * element.triad.transpose());
        const HexahedronNodes              u = R.transpose() * x - element.reference;
        const Eigen::Matrix<double, 24, 1> f =
          element.stiffness * Eigen::Map<const Eigen::Matrix<double, 24, 1>>(u.data());
        const HexahedronNodes turned = R * Eigen::Map<const HexahedronNodes>(f.data());
        for (unsigned int a = 0; a < 8; ++a)
          Eigen::Map<Vector3>(forces + 4 * std::size_t(element.nodes[a])) -= turned.col(a);
      }
  }

  std::size_t PlainElements::size() const
  {
    return elements_.size();
  }
} // namespace vfife
